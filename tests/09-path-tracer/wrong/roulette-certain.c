// Wrong: always goes on.
// Expect: all go on
#include "chapters/09-path-tracer/path.h"

real roulette(real q, rng *g) {
    (void)g;
    return 1 / q;
}
