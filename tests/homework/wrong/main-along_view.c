// Wrong: the depth along the axis of the view.
// Expect: the distance from the eye is asked for
// Stage: depth
#include "solutions/homework/raytracer.h"

static hit along_view(const scene *sc, ray r, real t_min, real t_max) {
    hit h = nearest(sc, r, t_min, t_max);
    h.t *= dot(r.d, normalize(sub(sc->target, sc->eye)));
    return h;
}
#define nearest(sc, r, t_min, t_max) along_view(sc, r, t_min, t_max)
#include "solutions/homework/main.c"
