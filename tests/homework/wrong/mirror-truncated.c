// Wrong: checks by (int), which does not round down.
// Expect: the checks are wrong where x or z is negative
// Stage: mirror
#include "solutions/homework/raytracer.h"

#undef floor
#define floor(x) (x)
#include "solutions/homework/mirror.c"
