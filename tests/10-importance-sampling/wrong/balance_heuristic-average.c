// Wrong: half for each.
// Expect: 1/2 for all
#include "chapters/10-importance-sampling/importance.h"

real balance_heuristic(real p, real q) {
    return p == 0 && q == 0 ? 0 : (real)0.5;
}
