// Right: first the square over the area, then the cosine.
#include "chapters/10-importance-sampling/importance.h"
#include "common/wide3.h"

real solid_angle_probability(vec3 x, vec3 y, vec3 n_y, real area) {
    const wide3 w = wide_sub(y, x);
    const double square = wide_dot(w, w), cosine = fabs(wide_dot(widen(n_y), w)) / sqrt(square);
    return (real)(square / area / cosine);
}
