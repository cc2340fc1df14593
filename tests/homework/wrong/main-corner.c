// Wrong: rays through the corners of the pixels.
// Expect: half a pixel off
// Stage: depth
#include "solutions/homework/raytracer.h"

#define camera_ray(sc, x, y) camera_ray(sc, (x) - (real)0.5, (y) - (real)0.5)
#include "solutions/homework/main.c"
