// Wrong: the first row of the PFM is the top one.
// Expect: upside down
#include "solutions/homework/raytracer.h"

#define camera_ray(sc, x, y) camera_ray(sc, x, HEIGHT - (y))
#include "solutions/homework/main.c"
