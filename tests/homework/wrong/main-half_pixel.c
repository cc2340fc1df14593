// Wrong: scene 3: rays from x - 0.5 to x + 0.5.
// Expect: all is half a pixel off
// Stage: path
#include "solutions/homework/raytracer.h"

#define camera_ray(sc, x, y) camera_ray(sc, (x) - (real)0.5, (y) - (real)0.5)
#include "solutions/homework/main.c"
