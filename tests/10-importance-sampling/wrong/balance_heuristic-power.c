// Wrong: the power heuristic.
// Expect: the power heuristic
#include "chapters/10-importance-sampling/importance.h"

real balance_heuristic(real p, real q) {
    return power_heuristic(p, q);
}
