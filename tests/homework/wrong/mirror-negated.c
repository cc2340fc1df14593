// Wrong: the mirrored direction is turned round.
// Expect: the reflected direction is 2 (n·d) n - d
// Stage: mirror
#include "solutions/homework/raytracer.h"

#define sub(a, b) neg(sub(a, b))
#include "solutions/homework/mirror.c"
