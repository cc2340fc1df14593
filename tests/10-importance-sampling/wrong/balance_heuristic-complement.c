// Wrong: 1 minus the other weight, rounded before.
// Expect: 1 minus the other weight
#include "chapters/10-importance-sampling/importance.h"

real balance_heuristic(real p, real q) {
    return 1 - (real)((double)q / ((double)p + q));
}
