// Right: points of a disc, spread so that 1 - cos θ is as their area.
#include "chapters/10-importance-sampling/importance.h"
#include "common/wide3.h"

vec3 sphere_direction(sphere S, vec3 x, rng *g) {
    real a, b, s;
    do {
        a = 2 * rng_real(g) - 1;
        b = 2 * rng_real(g) - 1;
        s = a * a + b * b;
    } while (s >= 1);
    const wide3 w = wide_sub(S.c, x);
    const double square = wide_dot(w, w), far = sqrt(square), sin2 = (double)S.r * S.r / square;
    const double width = sin2 / (1 + sqrt(fmax(1 - sin2, 0))), c = width * (double)s;
    const double k = sqrt(width * (2 - c)); // sin θ / sqrt(s)
    const wide3 axis = {w.x / far, w.y / far, w.z / far};
    const frame f = orthonormal_basis(narrow(axis));
    const wide3 v = wide_along(wide_along(axis, -c, axis), k * (double)a, widen(f.s));
    return narrow(wide_along(v, k * (double)b, widen(f.t)));
}
