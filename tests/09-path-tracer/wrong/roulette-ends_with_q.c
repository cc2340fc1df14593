// Wrong: ends with the probability q.
// Expect: it ends with the probability q
#include "chapters/09-path-tracer/path.h"

real roulette(real q, rng *g) {
    return rng_real(g) < q ? 0 : 1 / q;
}
