#include "chapters/09-path-tracer/path.h"

// rng_real is never 1: q = 1 always goes on.
real roulette(real q, rng *g) {
    return rng_real(g) < q ? 1 / q : 0;
}
