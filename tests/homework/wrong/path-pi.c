// Wrong: the lamp's light is π times too strong: Lambert's 1/π is missing.
// Expect: all reflected light is multiplied by π, once
// Stage: path
#include "solutions/homework/raytracer.h"

#define geometry(x, n, y, m) ((real)PI * geometry(x, n, y, m))
#include "solutions/homework/path.c"
