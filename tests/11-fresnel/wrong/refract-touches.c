// Wrong: *t is written before total reflection is known.
// Expect: false must leave *t alone; it was (7, 8, 9) before
#include "chapters/11-fresnel/fresnel.h"
#include "common/wide3.h"

bool refract(vec3 d, vec3 n, real eta, vec3 *t) {
    const double e = eta, c = -wide_dot(widen(d), widen(n));
    const double g2 = (e - 1) * (e + 1) + c * c;
    *t = keep_unit(narrow(wide_along(widen(d), c - sqrt(g2), widen(n))));
    return g2 >= 0;
}
