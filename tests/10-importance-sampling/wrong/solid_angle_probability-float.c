// Wrong: the cube of the distance in real arithmetic, which overflows.
// Expect: the range of float
#include "chapters/10-importance-sampling/importance.h"

real solid_angle_probability(vec3 x, vec3 y, vec3 n_y, real area) {
    const vec3 w = sub(y, x);
    const real square = dot(w, w);
    return square * sqrt(square) / (area * fabs(dot(n_y, w)));
}
