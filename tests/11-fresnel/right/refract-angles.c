// Right: by angles: θ_t = asin(sin θ / eta), in double.
#include "chapters/11-fresnel/fresnel.h"
#include "common/wide3.h"

bool refract(vec3 d, vec3 n, real eta, vec3 *t) {
    const wide3 D = widen(d), N = widen(n);
    const double c = -wide_dot(D, N), e = eta;
    if ((e - 1) * (e + 1) + c * c < 0) return false;
    const wide3 P = wide_along(D, c, N);
    const double sine = sqrt(wide_dot(P, P) / wide_dot(D, D)), theta = asin(fmin(sine / e, 1));
    const double a = sine > 0 ? sin(theta) / sine : 0, b = cos(theta);
    *t = narrow((wide3){a * P.x - b * N.x, a * P.y - b * N.y, a * P.z - b * N.z});
    return true;
}
