// directional_albedo: how much does a BRDF reflect?. The task is in README.md.
#include "chapters/07-rendering-equation/rendering.h"
#include "common/todo.h"

double directional_albedo(brdf f, const void *paint, vec3 n, vec3 w_o, int n_theta, int n_phi) {
    TODO("directional_albedo"); // your answer instead of these two lines
    return 0;
}
