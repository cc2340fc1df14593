#include "chapters/09-path-tracer/path.h"

// rng_real is below 1 and may be 0: so q = 1 always goes on, and q = 0 never.
real roulette(real q, rng *g) {
    return rng_real(g) < q ? 1 / q : 0;
}
