// Right: the two parts: sin θ_t along the surface, cos θ_t along -n, in double.
#include "chapters/11-fresnel/fresnel.h"
#include "common/wide3.h"

bool refract(vec3 d, vec3 n, real eta, vec3 *t) {
    const wide3 D = widen(d), N = widen(n);
    const double c = -wide_dot(D, N), e = eta, cos2 = 1 - (1 - c) * (1 + c) / (e * e);
    if (cos2 < 0) return false;
    const wide3 P = wide_along(D, c, N);
    const double far = sqrt(cos2);
    *t = narrow((wide3){P.x / e - far * N.x, P.y / e - far * N.y, P.z / e - far * N.z});
    return true;
}
