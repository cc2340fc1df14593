// Wrong: a ray may hit again what it has just left: t > 0 alone.
// Expect: do rays that leave them hit them again at t near 0
// Stage: path
#include "solutions/homework/raytracer.h"

#undef NEAR
#define NEAR 0
#include "solutions/homework/path.c"
