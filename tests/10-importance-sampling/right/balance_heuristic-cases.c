// Right: p / (p + q) in double, and the infinite cases by themselves.
#include "chapters/10-importance-sampling/importance.h"

real balance_heuristic(real p, real q) {
    if (isinf(p)) return 1;
    if (isinf(q)) return 0;
    return (real)((p / 2.0) / (p / 2.0 + q / 2.0));
}
