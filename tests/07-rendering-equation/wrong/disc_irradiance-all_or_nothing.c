// Wrong: the whole disc is judged by its centre.
// Expect: the whole disc was judged by its centre
// Expect: Judge every point of the disc by itself.
#include "chapters/07-rendering-equation/rendering.h"

double disc_irradiance(disc D, vec3 x, vec3 n, int n_r, int n_phi) {
    const double d_r = (double)D.radius / n_r, d_phi = 2 * PI / n_phi;
    const double size = sqrt(wide_dot(widen(D.P.n), widen(D.P.n)));
    double E = 0;
    for (int i = 0; i < n_r; i++)
        for (int j = 0; j < n_phi; j++) {
            const double r = (i + 0.5) * d_r;
            const wide3 out = perpendicular_at(D.P.n, (j + 0.5) * d_phi);
            const wide3 v = wide_along(wide_sub(D.P.x, x), r, out);
            const double d = sqrt(wide_dot(v, v));
            const double here = wide_dot(v, widen(n)) / d,
                         there = wide_dot(v, widen(D.P.n)) / d / size;
            if (!(wide_dot(wide_sub(D.P.x, x), widen(n)) > 0)) continue;
            E += fabs(here * there) / (d * d) * r * d_r * d_phi;
        }
    return E;
}
