// Wrong: the mirrored ray may hit the mirror that it leaves.
// Expect: speckles
// Stage: mirror
#include "solutions/homework/raytracer.h"

#undef NEAR
#define NEAR 0
#include "solutions/homework/mirror.c"
