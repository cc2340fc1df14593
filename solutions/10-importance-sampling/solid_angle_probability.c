#include "chapters/10-importance-sampling/importance.h"
#include "common/wide3.h"

// cos θ' = n_y·w / |w|. In double |w|³ neither overflows nor vanishes.
real solid_angle_probability(vec3 x, vec3 y, vec3 n_y, real area) {
    const wide3 w = wide_sub(y, x);
    const double square = wide_dot(w, w);
    return (real)(square * sqrt(square) / ((double)area * fabs(wide_dot(widen(n_y), w))));
}
