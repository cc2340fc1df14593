// Wrong: the lamp's upper side shines, too.
// Expect: the lamp's upper side shines
// Stage: path
#include "solutions/homework/raytracer.h"

#define geometry(x, n, y, m) (geometry(x, n, y, m) + geometry(x, n, y, neg(m)))
#include "solutions/homework/path.c"
