// Wrong: cos θ is compared with cos θ_max, as if |v| were exactly 1.
// Expect: the cosines
// Expect: compared
#include "chapters/10-importance-sampling/importance.h"
#include "common/wide3.h"

real sphere_probability(sphere S, vec3 x, vec3 v) {
    const wide3 w = wide_sub(S.c, x), d = widen(v);
    const double square = wide_dot(w, w), r2 = (double)S.r * S.r;
    if (!(r2 < square) || wide_dot(w, d) <= 0) return 0;
    const double cos_max = sqrt(square - r2) / sqrt(square);
    if (wide_dot(w, d) < cos_max * sqrt(square)) return 0;
    return (real)((1 + cos_max) * square / (2 * PI * r2));
}
