// Wrong: the far corner of each cell, not its middle.
// Expect: the far corner of the cell, not its middle: (i + 1) dθ
#include "chapters/07-rendering-equation/rendering.h"

double irradiance(radiance_field L_i, const void *world, vec3 x, vec3 n, int n_theta,
                  int n_phi) {
    const double d_theta = PI / 2 / n_theta, d_phi = 2 * PI / n_phi;
    double E = 0;
    for (int i = 0; i < n_theta; i++)
        for (int j = 0; j < n_phi; j++) {
            const double theta = (i + 1) * d_theta;
            const vec3 w = direction_at(n, theta, (j + 1) * d_phi);
            E += L_i(world, x, w) * cos(theta) * sin(theta) * d_theta * d_phi;
        }
    return E;
}
