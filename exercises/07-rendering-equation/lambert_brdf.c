// lambert_brdf: a surface as bright from everywhere. The task is in README.md.
#include "chapters/07-rendering-equation/rendering.h"
#include "common/todo.h"

double lambert_brdf(double rho) {
    TODO("lambert_brdf"); // your answer instead of these two lines
    return 0;
}
