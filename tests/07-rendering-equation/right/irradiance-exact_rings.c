// Right: the weight of each ring by its exact integral, (sin²θ')/2 from border to border.
#include "chapters/07-rendering-equation/rendering.h"

double irradiance(radiance_field L_i, const void *world, vec3 x, vec3 n, int n_theta,
                  int n_phi) {
    double sum = 0;
    for (int i = 0; i < n_theta; i++)
        for (int j = 0; j < n_phi; j++) {
            const double h = PI / 2 / n_theta, inner = sin(i * h), outer = sin((i + 1) * h);
            const vec3 w = direction_at(n, (i + 0.5) * h, 2 * PI * j / n_phi);
            sum += L_i(world, x, w) * (outer * outer - inner * inner);
        }
    return PI * sum / n_phi;
}
