// Wrong: the lamp is not asked for what stands before it.
// Expect: no shadows
// Stage: path
#include "solutions/homework/raytracer.h"

#define blocked(sc, x, y) false
#include "solutions/homework/path.c"
