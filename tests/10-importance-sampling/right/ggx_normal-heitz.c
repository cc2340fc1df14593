// Right: Heitz 2018: the projected disc, cut by the horizon.
#include "chapters/10-importance-sampling/ggx.h"

vec3 ggx_normal(vec3 o, real alpha, rng *g) {
    const vec3 w = normalize((vec3){alpha * o.x, alpha * o.y, o.z});
    const real flat = w.x * w.x + w.y * w.y;
    const vec3 s = flat > 0 ? scale(1 / sqrt(flat), (vec3){-w.y, w.x, 0}) : (vec3){1, 0, 0};
    const vec3 t = cross(w, s);
    const real r = sqrt(rng_real(g));
    const real phi = (real)(2 * PI) * rng_real(g), a = r * cos(phi);
    const real k = (1 + w.z) / 2, b = (1 - k) * sqrt(fmax(1 - a * a, 0)) + k * r * sin(phi);
    const real c = sqrt(fmax(1 - a * a - b * b, 0));
    const vec3 h = add(add(scale(a, s), scale(b, t)), scale(c, w));
    return normalize((vec3){alpha * h.x, alpha * h.y, fmax(h.z, 0)});
}
