// Wrong: tan θ_max = r/d in place of the sine.
// Expect: θ_max as if r/d were its tangent
#include "chapters/10-importance-sampling/importance.h"
#include "common/wide3.h"

vec3 sphere_direction(sphere S, vec3 x, rng *g) {
    const wide3 w = wide_sub(S.c, x);
    const double far = sqrt(wide_dot(w, w)), t = S.r / far, cos_max = 1 / sqrt(1 + t * t);
    const double c = (double)rng_real(g) * t * t * cos_max / (1 + 1 / cos_max);
    const double phi = 2 * PI * (double)rng_real(g), sine = sqrt(c * (2 - c));
    const wide3 axis = {w.x / far, w.y / far, w.z / far};
    const frame f = orthonormal_basis(narrow(axis));
    const wide3 along = {(1 - c) * axis.x, (1 - c) * axis.y, (1 - c) * axis.z};
    const wide3 aside = wide_along(along, sine * cos(phi), widen(f.s));
    return narrow(wide_along(aside, sine * sin(phi), widen(f.t)));
}
