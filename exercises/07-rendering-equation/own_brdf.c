// own_brdf: a BRDF of your own. The task is in README.md.
#include "chapters/07-rendering-equation/rendering.h"
#include "common/todo.h"

double own_brdf(double rho, double shine, vec3 n, vec3 w_i, vec3 w_o) {
    TODO("own_brdf"); // your answer instead of these two lines
    return 0;
}
