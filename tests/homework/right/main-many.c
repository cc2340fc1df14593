// Right: 100 samples a pixel.
#include "solutions/homework/raytracer.h"

#undef SAMPLES
#define SAMPLES 100
#include "solutions/homework/main.c"
