// Wrong: those that go on do not carry the light of those that end.
// Expect: not divided by q
#include "chapters/09-path-tracer/path.h"

real roulette(real q, rng *g) {
    return rng_real(g) < q ? 1 : 0;
}
