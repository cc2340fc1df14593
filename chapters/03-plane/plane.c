// plane.c: see plane.h. The derivations are in README.md.
#include "chapters/03-plane/plane.h"

hit hit_at(ray r, real t, vec3 n) {
    const vec3 step = scale(t, r.d);
    return (hit){.t = t,
                 .p = add(r.O, step),
                 .error = scale(rounding_bound(4), add(absolute(r.O), absolute(step))),
                 .n = n,
                 .front = dot(r.d, n) < 0};
}

// plane_hit's two dot products in double: nothing beside float's roundings, all that
// counts where real is double.
hit plane_surface(plane P, ray r, real t) {
    hit h = hit_at(r, t, dot(P.n, P.n) == 1 ? P.n : normalize(P.n));
    const vec3 summed = add(absolute(sub(P.x, r.O)), absolute(scale(t, r.d)));
    h.error = add(h.error, scale((real)(4 * DBL_EPSILON), summed));
    return h;
}

// Is floor(x) odd? Stays right where the whole number no longer fits an int.
static int odd(real x) {
    const real whole = floor(x);
    return whole - 2 * floor(whole / 2) != 0;
}

int checks(real x, real z) {
    return odd(x) ^ odd(z);
}
