// Wrong: the picture's x runs from right to left.
// Expect: mirrored left to right
#include "solutions/homework/raytracer.h"

#define camera_ray(sc, x, y) camera_ray(sc, WIDTH - (x), y)
#include "solutions/homework/main.c"
