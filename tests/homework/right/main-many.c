// Right: 200 samples a pixel.
#include "solutions/homework/raytracer.h"

#undef SAMPLES
#define SAMPLES 200
#include "solutions/homework/main.c"
