#include "chapters/07-rendering-equation/rendering.h"

// cos θ and cos θ' are dot products over |v|, so that |v| appears squared, and squared
// again: taken apart, so that neither overflows.
double disc_irradiance(disc D, vec3 x, vec3 n, int n_r, int n_phi) {
    const double d_r = D.radius / (double)n_r, d_phi = 2 * PI / n_phi;
    const wide3 to_centre = wide_sub(D.P.x, x), up = widen(n), normal = widen(D.P.n);
    const double size = sqrt(wide_dot(normal, normal));
    double E = 0;
    for (int i = 0; i < n_r; i++) {
        const double r = (i + 0.5) * d_r, dA = r * d_r * d_phi;
        for (int j = 0; j < n_phi; j++) {
            const wide3 out = perpendicular_at(D.P.n, (j + 0.5) * d_phi);
            const wide3 v = wide_along(to_centre, r, out);
            const double square = wide_dot(v, v), above = wide_dot(v, up);
            if (!(above > 0)) continue;
            E += above / square * fabs(wide_dot(v, normal)) / size / square * dA;
        }
    }
    return E;
}
