// disc_irradiance: the light of a disc, over its surface. The task is in README.md.
#include "chapters/07-rendering-equation/rendering.h"
#include "common/todo.h"

double disc_irradiance(disc D, vec3 x, vec3 n, int n_r, int n_phi) {
    TODO("disc_irradiance"); // your answer instead of these two lines
    return 0;
}
