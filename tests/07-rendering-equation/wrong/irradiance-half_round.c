// Wrong: φ runs only to π.
// Expect: φ ran only half the way round
// Expect: φ did not run all the way round: only to π, or n_theta
#include "chapters/07-rendering-equation/rendering.h"

double irradiance(radiance_field L_i, const void *world, vec3 x, vec3 n, int n_theta,
                  int n_phi) {
    const double d_theta = PI / 2 / n_theta, d_phi = PI / n_phi;
    double E = 0;
    for (int i = 0; i < n_theta; i++)
        for (int j = 0; j < n_phi; j++) {
            const double theta = (i + 0.5) * d_theta, phi = (j + 0.5) * d_phi;
            const vec3 w = direction_at(n, theta, phi);
            E += L_i(world, x, w) * cos(theta) * sin(theta) * d_theta * d_phi;
        }
    return E;
}
