// Wrong: each reflection is halved: cos θ, and the density of another sampler.
// Expect: every reflection is multiplied by 1/2
// Stage: path
#include "solutions/homework/raytracer.h"

// A matte body's colour is all that a reflection multiplies by here.
#define mul(C, albedo) scale((real)0.5, mul(C, albedo))
#define add(L, light) add(L, scale(2, light))
#include "solutions/homework/path.c"
