// Wrong: both ways count in full.
// Expect: the light is counted by both ways
#include "chapters/10-importance-sampling/importance.h"

real balance_heuristic(real p, real q) {
    return p >= 0 && q >= 0 ? 1 : 0;
}
