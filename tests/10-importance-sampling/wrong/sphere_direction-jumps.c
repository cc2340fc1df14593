// Wrong: evenly spread jumps that remember where they were, in place of g.
// Expect: something kept from the call before?
#include "chapters/10-importance-sampling/importance.h"
#include "common/wide3.h"

vec3 sphere_direction(sphere S, vec3 x, rng *g) {
    static double at;
    at = fmod(at + 0.6180339887498949, 1);
    const wide3 w = wide_sub(S.c, x);
    const double square = wide_dot(w, w), far = sqrt(square), r2 = (double)S.r * S.r;
    const double cos_max = sqrt(fmax(square - r2, 0)) / far;
    const double c = (double)rng_real(g) * r2 / square / (1 + cos_max);
    const double phi = 2 * PI * at, sine = sqrt(c * (2 - c));
    const wide3 axis = {w.x / far, w.y / far, w.z / far};
    const frame f = orthonormal_basis(narrow(axis));
    const wide3 along = {(1 - c) * axis.x, (1 - c) * axis.y, (1 - c) * axis.z};
    const wide3 aside = wide_along(along, sine * cos(phi), widen(f.s));
    return narrow(wide_along(aside, sine * sin(phi), widen(f.t)));
}
