// Wrong: multiplied by q in place of divided.
// Expect: multiplied in place of divided
#include "chapters/09-path-tracer/path.h"

real roulette(real q, rng *g) {
    return rng_real(g) < q ? q : 0;
}
