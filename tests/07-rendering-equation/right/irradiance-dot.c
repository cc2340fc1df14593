// Right: the cosine by the dot product; the loops the other way round.
#include "chapters/07-rendering-equation/rendering.h"

double irradiance(radiance_field L_i, const void *world, vec3 x, vec3 n, int n_theta,
                  int n_phi) {
    const double d_theta = PI / 2 / n_theta, d_phi = 2 * PI / n_phi;
    double sum = 0;
    for (int j = 0; j < n_phi; j++)
        for (int i = 0; i < n_theta; i++) {
            const double theta = (i + 0.5) * d_theta;
            const vec3 w = direction_at(n, theta, j * d_phi);
            sum += L_i(world, x, w) * dot(w, n) * sin(theta);
        }
    return sum * d_theta * d_phi;
}
