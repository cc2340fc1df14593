// Wrong: the sine at the corner of the cell.
// Expect: the sine of the cell's corner, sin(i dθ), not of its middle
#include "chapters/07-rendering-equation/rendering.h"

double directional_albedo(brdf f, const void *paint, vec3 n, vec3 w_o, int n_theta, int n_phi) {
    const double d_theta = PI / 2 / n_theta, d_phi = 2 * PI / n_phi;
    double albedo = 0;
    for (int i = 0; i < n_theta; i++)
        for (int j = 0; j < n_phi; j++) {
            const double theta = (i + 0.5) * d_theta;
            const vec3 w_i = direction_at(n, theta, (j + 0.5) * d_phi);
            albedo += f(paint, n, w_i, w_o) * cos(theta) * sin(i * d_theta) * d_theta * d_phi;
        }
    return albedo;
}
