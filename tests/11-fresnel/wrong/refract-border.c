// Wrong: the critical angle itself counts as total reflection.
// Expect: what if it is 1?
#include "chapters/11-fresnel/fresnel.h"
#include "common/wide3.h"

bool refract(vec3 d, vec3 n, real eta, vec3 *t) {
    const double e = eta, c = -wide_dot(widen(d), widen(n));
    const double g2 = (e - 1) * (e + 1) + c * c;
    if (g2 <= 0) return false;
    *t = keep_unit(narrow(wide_along(widen(d), c - sqrt(g2), widen(n))));
    return true;
}
