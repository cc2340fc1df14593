#include "chapters/10-importance-sampling/importance.h"

// 1 - cos θ is uniform in [0, 1 - cos θ_max], and sin² θ = (1 - cos θ)(1 + cos θ).
vec3 sphere_direction(sphere S, vec3 x, rng *g) {
    const vec3 w = sub(S.c, x);
    const real sin2 = S.r * S.r / dot(w, w);
    const real q = sin2 / (1 + sqrt(1 - sin2)); // 1 - cos θ_max
    const real c = q * rng_real(g);
    const real phi = (real)(2 * PI) * rng_real(g);
    const real sine = sqrt(c * (2 - c));
    const vec3 local = {sine * cos(phi), sine * sin(phi), 1 - c};
    return keep_unit(to_world(orthonormal_basis(normalize(w)), local));
}
