// Wrong: negative where the back is seen.
// Expect: the lamp's back is seen
#include "chapters/10-importance-sampling/importance.h"
#include "common/wide3.h"

real solid_angle_probability(vec3 x, vec3 y, vec3 n_y, real area) {
    const wide3 w = wide_sub(y, x);
    const double d = sqrt(wide_dot(w, w)), cosine = wide_dot(widen(n_y), w) / d;
    return (real)(d * d / (area * cosine));
}
