// Right: a point on the surface itself counts as outside.
#include "chapters/10-importance-sampling/importance.h"
#include "common/wide3.h"

real sphere_probability(sphere S, vec3 x, vec3 v) {
    const wide3 w = wide_sub(S.c, x), d = widen(v), side = wide_cross(w, d);
    const double square = wide_dot(w, w), r2 = (double)S.r * S.r;
    if (square < r2 || wide_dot(w, d) <= 0) return 0;
    if (wide_dot(side, side) > r2 * wide_dot(d, d)) return 0;
    const double cos_max = sqrt(square - r2) / sqrt(square);
    return (real)((1 + cos_max) * square / (2 * PI * r2));
}
