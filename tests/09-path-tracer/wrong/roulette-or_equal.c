// Wrong: goes on where the random number equals q: for q = 0 now and then.
// Expect: is the random number compared by < ?
#include "chapters/09-path-tracer/path.h"

real roulette(real q, rng *g) {
    return rng_real(g) <= q ? 1 / q : 0;
}
