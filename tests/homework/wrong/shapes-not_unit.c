// Wrong: the normals are not made unit vectors.
// Expect: the normals have the right direction, but are not of unit length
// Stage: normal
#include "solutions/homework/raytracer.h"

#undef normalize
#define normalize(v) (v)
#include "solutions/homework/shapes.c"
