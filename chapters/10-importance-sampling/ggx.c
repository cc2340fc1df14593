// ggx.c: see ggx.h. The derivations are in README.md.
#include "chapters/10-importance-sampling/ggx.h"

// 1 / (π alpha² cos⁴ θ (1 + tan² θ / alpha²)²), multiplied out: no tan θ, and nothing cancels
// for a tiny alpha.
real ggx_density(vec3 h, real alpha) {
    if (h.z <= 0) return 0;
    const real a = alpha * alpha;
    const real k = (h.x * h.x + h.y * h.y) / a + h.z * h.z;
    return 1 / ((real)PI * a * k * k);
}

// sqrt(w.z² + alpha² (w.x² + w.y²)): Smith's Λ is (stretched / w.z - 1) / 2.
static real stretched(vec3 w, real alpha) {
    return sqrt(w.z * w.z + alpha * alpha * (w.x * w.x + w.y * w.y));
}

// G2 / (4 o.z v.z) = 1 / (2 (v.z stretched(o) + o.z stretched(v)))
real ggx_brdf(vec3 o, vec3 v, real alpha) {
    const vec3 sum = add(o, v);
    if (o.z <= 0 || v.z <= 0 || dot(sum, sum) == 0) return 0;
    const real G = 1 / (2 * (v.z * stretched(o, alpha) + o.z * stretched(v, alpha)));
    return ggx_density(normalize(sum), alpha) * G;
}

// (1 + Λ(o)) / (1 + Λ(o) + Λ(v))
real ggx_weight(vec3 o, vec3 v, real alpha) {
    if (o.z <= 0 || v.z <= 0) return 0;
    const real so = stretched(o, alpha), sv = stretched(v, alpha);
    return v.z * (o.z + so) / (v.z * so + o.z * sv);
}

color schlick_color(color F0, real cosine) {
    const real m = 1 - fmin(fmax(cosine, 0), 1);
    const real m5 = m * m * m * m * m;
    return add(F0, scale(m5, sub((color){1, 1, 1}, F0)));
}
