// Wrong: all in float: the fourth power of a large distance is infinite.
// Expect: infinity: divided by 0
// Expect: Double inside
#include "chapters/07-rendering-equation/rendering.h"

double disc_irradiance(disc D, vec3 x, vec3 n, int n_r, int n_phi) {
    const float d_r = (float)D.radius / (float)n_r, d_phi = (float)(2 * PI) / (float)n_phi;
    const wide3 normal = widen(D.P.n);
    const float size = (float)sqrt(wide_dot(normal, normal));
    float E = 0;
    for (int i = 0; i < n_r; i++)
        for (int j = 0; j < n_phi; j++) {
            const float r = ((float)i + 0.5f) * d_r;
            const wide3 out = perpendicular_at(D.P.n, (j + 0.5) * (double)d_phi);
            const wide3 v = wide_along(wide_sub(D.P.x, x), (double)r, out);
            const float square = (float)wide_dot(v, v), here = (float)wide_dot(v, widen(n));
            const float there = (float)fabs(wide_dot(v, normal)) / size;
            if (here > 0) E += here * there / (square * square) * r * d_r * d_phi;
        }
    return (double)E;
}
