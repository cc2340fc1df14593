// Wrong: the disc's points and their distances in float; normalised first, so no power overflows.
// Expect: At 1e6 floats lie 1/16 apart
// Expect: the square of 1e-30, or of 1e30, is no float
#include "chapters/07-rendering-equation/rendering.h"

double disc_irradiance(disc D, vec3 x, vec3 n, int n_r, int n_phi) {
    const double dr = (double)D.radius / n_r, dphi = 2 * PI / n_phi;
    const vec3 m = normalize(D.P.n);
    double sum = 0;
    for (int i = 0; i < n_r; i++)
        for (int j = 0; j < n_phi; j++) {
            const double r = (i + 0.5) * dr, phi = (j + 0.5) * dphi;
            const vec3 out = narrow(perpendicular_at(D.P.n, phi));
            const vec3 v = sub(add(D.P.x, scale((real)r, out)), x), w = normalize(v);
            const double here = dot(w, n), there = fabs((double)dot(w, m));
            if (here > 0) sum += here * there * r * dr * dphi / (double)dot(v, v);
        }
    return sum;
}
