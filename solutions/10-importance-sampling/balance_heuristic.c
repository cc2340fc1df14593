#include "chapters/10-importance-sampling/importance.h"

real balance_heuristic(real p, real q) {
    return 1 / (1 + q / p);
}
