// Wrong: the larger root of the sphere.
// Expect: the far side of the spheres is seen
// Stage: depth
#include "solutions/homework/raytracer.h"

#undef sqrt
#define sqrt(D) -sqrt(D)
#include "solutions/homework/shapes.c"
