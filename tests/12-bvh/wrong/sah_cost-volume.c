// Wrong: the volume in place of the area.
// Expect: with the surface area as in aabb_area
#include "chapters/12-bvh/bvh.h"

static real volume(aabb a) {
    const vec3 e = sub(a.max, a.min);
    return e.x * e.y * e.z;
}

real sah_cost(aabb box, int n_l, aabb l, int n_r, aabb r) {
    const real hits = (real)n_l * volume(l) + (real)n_r * volume(r);
    return C_STEP + C_HIT * hits / volume(box);
}
