// Wrong: infinity is thought of, a sum that overflows is not.
// Expect: p + q overflows
#include "chapters/10-importance-sampling/importance.h"

real balance_heuristic(real p, real q) {
    return isinf(p) ? 1 : p / (p + q);
}
