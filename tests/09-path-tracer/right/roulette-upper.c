// Right: the upper end of the interval goes on.
#include "chapters/09-path-tracer/path.h"

real roulette(real q, rng *g) {
    return 1 - rng_real(g) <= q ? 1 / q : 0;
}
