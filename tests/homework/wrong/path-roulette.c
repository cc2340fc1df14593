// Wrong: roulette that does not divide by its q.
// Expect: roulette that does not divide by its q
// Stage: path
#include "solutions/homework/raytracer.h"

#define scale(s, C) right_scale(s, C)
static color right_scale(real s, color C) {
    return s > 1 ? C : (color){s * C.x, s * C.y, s * C.z};
}
#include "solutions/homework/path.c"
