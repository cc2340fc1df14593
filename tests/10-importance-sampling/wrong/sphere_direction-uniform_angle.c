// Wrong: the angle is uniform, without its sine.
// Expect: too many in the middle
#include "chapters/10-importance-sampling/importance.h"
#include "common/wide3.h"

vec3 sphere_direction(sphere S, vec3 x, rng *g) {
    const wide3 w = wide_sub(S.c, x);
    const double far = sqrt(wide_dot(w, w)), theta = asin(S.r / far) * (double)rng_real(g);
    const double phi = 2 * PI * (double)rng_real(g), sine = sin(theta), h = sin(theta / 2);
    const double c = 2 * h * h;
    const wide3 axis = {w.x / far, w.y / far, w.z / far};
    const frame f = orthonormal_basis(narrow(axis));
    const wide3 along = {(1 - c) * axis.x, (1 - c) * axis.y, (1 - c) * axis.z};
    const wide3 aside = wide_along(along, sine * cos(phi), widen(f.s));
    return narrow(wide_along(aside, sine * sin(phi), widen(f.t)));
}
