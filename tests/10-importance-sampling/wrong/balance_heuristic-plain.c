// Wrong: as written: infinity over infinity, and a sum that overflows.
// Expect: divide so that nothing overflows
#include "chapters/10-importance-sampling/importance.h"

real balance_heuristic(real p, real q) {
    return p / (p + q);
}
