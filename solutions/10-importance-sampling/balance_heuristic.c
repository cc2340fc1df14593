#include "chapters/10-importance-sampling/importance.h"

// p / (p + q), divided through by p: right for p = 0, q = 0, and where p + q would overflow.
real balance_heuristic(real p, real q) {
    return 1 / (1 + q / p);
}
