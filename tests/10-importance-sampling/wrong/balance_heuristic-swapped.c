// Wrong: the weight of the other one.
// Expect: the weight of the other one
#include "chapters/10-importance-sampling/importance.h"

real balance_heuristic(real p, real q) {
    return 1 / (1 + p / q);
}
