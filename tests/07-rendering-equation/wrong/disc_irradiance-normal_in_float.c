// Wrong: only the normal is made a unit vector in float: its square overflows, or is 0.
// Expect: the square of 1e-30, or of 1e30, is no float
#include "chapters/07-rendering-equation/rendering.h"

double disc_irradiance(disc D, vec3 x, vec3 n, int n_r, int n_phi) {
    const double d_r = (double)D.radius / n_r, d_phi = 2 * PI / n_phi;
    const wide3 m = widen(normalize(D.P.n));
    double E = 0;
    for (int i = 0; i < n_r; i++)
        for (int j = 0; j < n_phi; j++) {
            const double r = (i + 0.5) * d_r;
            const wide3 out = perpendicular_at(D.P.n, (j + 0.5) * d_phi);
            const wide3 v = wide_along(wide_sub(D.P.x, x), r, out), w = wide_unit(v);
            const double here = wide_dot(w, widen(n)), there = fabs(wide_dot(w, m));
            if (here > 0) E += here * there / wide_dot(v, v) * r * d_r * d_phi;
        }
    return E;
}
