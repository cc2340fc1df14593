// Wrong: SEED is not used.
// Expect: SEED, the third argument, must seed
// Stage: path
#include "solutions/homework/raytracer.h"

#define rng_sample(seed, x, y, i) rng_sample(1, x, y, i)
#include "solutions/homework/main.c"
