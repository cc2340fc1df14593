// Wrong: cos θ_max in real arithmetic, and 1 - cos θ_max from it, which cancels for small cones.
// Expect: did 1 - cos θ_max cancel to 0?
#include "chapters/10-importance-sampling/importance.h"
#include "common/wide3.h"

vec3 sphere_direction(sphere S, vec3 x, rng *g) {
    const wide3 w = wide_sub(S.c, x);
    const double far = sqrt(wide_dot(w, w)), ratio = S.r / far;
    const real cos_max = (real)sqrt(1 - ratio * ratio);
    const double c = (double)(1 - cos_max) * (double)rng_real(g);
    const double phi = 2 * PI * (double)rng_real(g), sine = sqrt(c * (2 - c));
    const wide3 axis = {w.x / far, w.y / far, w.z / far};
    const frame f = orthonormal_basis(narrow(axis));
    const wide3 along = {(1 - c) * axis.x, (1 - c) * axis.y, (1 - c) * axis.z};
    const wide3 aside = wide_along(along, sine * cos(phi), widen(f.s));
    return narrow(wide_along(aside, sine * sin(phi), widen(f.t)));
}
