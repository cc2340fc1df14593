// Wrong: the axis rounded to float.
// Expect: was the axis rounded to float?
// Expect: A draw is the axis and a little aside
#include "chapters/10-importance-sampling/importance.h"
#include "common/wide3.h"

vec3 sphere_direction(sphere S, vec3 x, rng *g) {
    const wide3 w = wide_sub(S.c, x);
    const double square = wide_dot(w, w), far = sqrt(square), r2 = (double)S.r * S.r;
    const double cos_max = sqrt(fmax(square - r2, 0)) / far;
    const double c = (double)rng_real(g) * r2 / square / (1 + cos_max);
    const double phi = 2 * PI * (double)rng_real(g), sine = sqrt(c * (2 - c));
    const wide3 exact_axis = {w.x / far, w.y / far, w.z / far};
    const wide3 axis =
        widen((vec3){(float)exact_axis.x, (float)exact_axis.y, (float)exact_axis.z});
    const frame f = orthonormal_basis(narrow(axis));
    const wide3 along = {(1 - c) * axis.x, (1 - c) * axis.y, (1 - c) * axis.z};
    const wide3 aside = wide_along(along, sine * cos(phi), widen(f.s));
    return narrow(wide_along(aside, sine * sin(phi), widen(f.t)));
}
