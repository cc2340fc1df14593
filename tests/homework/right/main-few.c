// Right: 16 samples a pixel.
#include "solutions/homework/raytracer.h"

#undef SAMPLES
#define SAMPLES 16
#include "solutions/homework/main.c"
