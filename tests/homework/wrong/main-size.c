// Wrong: half the width and height.
// Expect: the picture has 64x48 pixels
// Stage: depth
#include "solutions/homework/raytracer.h"

#define WIDTH 64
#define HEIGHT 48
#include "solutions/homework/main.c"
