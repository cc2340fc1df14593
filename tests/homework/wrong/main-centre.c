// Wrong: scene 3: all rays of a pixel through its centre.
// Expect: not spread over the whole pixel
// Stage: path
#include "solutions/homework/raytracer.h"

#define camera_ray(sc, x, y) camera_ray(sc, floor(x) + (real)0.5, floor(y) + (real)0.5)
#undef SAMPLES
#define SAMPLES 50
#include "solutions/homework/main.c"
