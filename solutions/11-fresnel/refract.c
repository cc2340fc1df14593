#include "chapters/11-fresnel/fresnel.h"
#include "common/wide3.h"

// (eta cos θ_t)² = eta² - sin² = (eta - 1)(eta + 1) + cos²: for eta near 1 nothing cancels.
bool refract(vec3 d, vec3 n, real eta, vec3 *t) {
    const double e = eta, c = -wide_dot(widen(d), widen(n));
    const double g2 = (e - 1) * (e + 1) + c * c;
    if (!(g2 >= 0)) return false;
    const wide3 eta_t = wide_along(widen(d), c - sqrt(g2), widen(n));
    *t = keep_unit(narrow(eta_t));
    return true;
}
