// Wrong: divided by 1 - q.
// Expect: 1/(1-q)
#include "chapters/09-path-tracer/path.h"

real roulette(real q, rng *g) {
    return rng_real(g) < q ? 1 / (1 - q) : 0;
}
