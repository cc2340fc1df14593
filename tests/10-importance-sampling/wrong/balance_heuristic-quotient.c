// Wrong: p / q.
// Expect: p / q
#include "chapters/10-importance-sampling/importance.h"

real balance_heuristic(real p, real q) {
    return p / q;
}
