// Wrong: the lamp's light falls with the distance, not with its square.
// Expect: falls with the distance
// Stage: path
#include "solutions/homework/raytracer.h"

#define geometry(x, n, y, m) (geometry(x, n, y, m) * length(sub(y, x)))
#include "solutions/homework/path.c"
