// Wrong: the sine as the length of n × d, which passes 1 when d and n are a rounding too long.
// Expect: a sine above 1
#include "chapters/11-fresnel/fresnel.h"
#include "common/wide3.h"

bool refract(vec3 d, vec3 n, real eta, vec3 *t) {
    const double e = eta, c = -wide_dot(widen(d), widen(n));
    const wide3 m = wide_cross(widen(n), widen(d));
    const double g2 = e * e - wide_dot(m, m);
    if (!(g2 >= 0)) return false;
    *t = keep_unit(narrow(wide_along(widen(d), c - sqrt(g2), widen(n))));
    return true;
}
