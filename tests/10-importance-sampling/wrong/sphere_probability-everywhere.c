// Wrong: v is not looked at.
// Expect: the ray misses the sphere, is that looked at?
#include "chapters/10-importance-sampling/importance.h"
#include "common/wide3.h"

real sphere_probability(sphere S, vec3 x, vec3 v) {
    const wide3 w = wide_sub(S.c, x);
    const double square = wide_dot(w, w), r2 = (double)S.r * S.r;
    if (!(r2 < square) || wide_dot(w, widen(v)) <= 0) return 0;
    const double cos_max = sqrt(square - r2) / sqrt(square);
    return (real)((1 + cos_max) * square / (2 * PI * r2));
}
