// Wrong: hits behind the camera count.
// Expect: hits behind the camera count
// Stage: depth
#include "solutions/homework/raytracer.h"

#define nearest right_nearest
#include "solutions/homework/shapes.c"
#undef nearest

hit nearest(const scene *sc, ray r, real t_min, real t_max) {
    const hit h = right_nearest(sc, r, t_min, t_max);
    const hit behind = right_nearest(sc, (ray){r.O, neg(r.d)}, t_min, h.t);
    return behind.b ? behind : h;
}
