// Wrong: d - (n·d) n, without the 2.
// Expect: is the reflected direction d - 2 (n·d) n
// Stage: mirror
#include "solutions/homework/raytracer.h"

#define dot(a, b) ((real)0.5 * dot(a, b))
#include "solutions/homework/mirror.c"
