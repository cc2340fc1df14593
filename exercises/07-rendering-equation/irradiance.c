// irradiance: the cosine and the solid angle. The task is in README.md.
#include "chapters/07-rendering-equation/rendering.h"
#include "common/todo.h"

double irradiance(radiance_field L_i, const void *world, vec3 x, vec3 n, int n_theta,
                  int n_phi) {
    TODO("irradiance"); // your answer instead of these two lines
    return 0;
}
