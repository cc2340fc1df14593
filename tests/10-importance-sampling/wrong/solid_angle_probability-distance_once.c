// Wrong: the distance, not its square.
// Expect: |y - x| in place of its square
#include "chapters/10-importance-sampling/importance.h"
#include "common/wide3.h"

real solid_angle_probability(vec3 x, vec3 y, vec3 n_y, real area) {
    const wide3 w = wide_sub(y, x);
    const double d = sqrt(wide_dot(w, w)), cosine = wide_dot(widen(n_y), w) / d;
    return (real)(d / (area * fabs(cosine)));
}
