// Wrong: the integral of f alone.
// Expect: the integral without the cosine w·n
#include "chapters/07-rendering-equation/rendering.h"

double directional_albedo(brdf f, const void *paint, vec3 n, vec3 w_o, int n_theta, int n_phi) {
    const double d_theta = PI / 2 / n_theta, d_phi = 2 * PI / n_phi;
    double sum = 0;
    for (int i = 0; i < n_theta; i++)
        for (int j = 0; j < n_phi; j++) {
            const double theta = (i + 0.5) * d_theta;
            const vec3 w_i = direction_at(n, theta, (j + 0.5) * d_phi);
            sum += f(paint, n, w_i, w_o) * sin(theta) * d_theta * d_phi;
        }
    return sum;
}
