// Wrong: the lowest row is left out, all others are one too low.
// Expect: all is one row too low
// Stage: depth
#include "solutions/homework/raytracer.h"

#define camera_ray(sc, x, y) camera_ray(sc, x, (y)-1)
#include "solutions/homework/main.c"
