// Wrong: the C library's random numbers.
// Expect: numbers that do not come from g
#include "chapters/09-path-tracer/path.h"

#include <stdlib.h>

real roulette(real q, rng *g) {
    (void)g;
    return (real)(rand() & 0xffff) / 0x10000 < q ? 1 / q : 0;
}
