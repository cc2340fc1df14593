// Wrong: as written: infinity over infinity.
// Expect: infinity / infinity is NaN
// Expect: = nan: their sum should be 1
#include "chapters/10-importance-sampling/importance.h"

real balance_heuristic(real p, real q) {
    return p / (p + q);
}
