// Right: 1 - cos θ_max = 2 sin² (θ_max / 2); the ray is asked by sphere_hit.
#include "chapters/10-importance-sampling/importance.h"
#include "common/wide3.h"

real sphere_probability(sphere S, vec3 x, vec3 v) {
    const wide3 w = wide_sub(S.c, x);
    const double d = sqrt(wide_dot(w, w));
    if (!(d > S.r) || sphere_hit(S, (ray){x, v}, 0, NO_HIT) == NO_HIT) return 0;
    const double half = atan2(S.r, sqrt((d - S.r) * (d + S.r))) / 2;
    return (real)(1 / (4 * PI * sin(half) * sin(half)));
}
