// Wrong: nobody asks whether up is a number, and no comparison stops a NaN.
// Expect: every comparison with NaN is false
// Expect: camera_right: up is zero or not finite
#include "chapters/02-camera/camera.h"
#include "common/wide3.h"

// v x the axis that is least along v: far from zero, and exactly perpendicular.
static vec3 any_perpendicular(vec3 v) {
    const vec3 a = absolute(v);
    if (a.x <= a.y && a.x <= a.z) return normalize((vec3){0, v.z, -v.y});
    if (a.y <= a.z) return normalize((vec3){-v.z, 0, v.x});
    return normalize((vec3){v.y, -v.x, 0});
}

vec3 camera_right(vec3 forward, vec3 up) {
    const double size = fmax(fabs(up.x), fmax(fabs(up.y), fabs(up.z)));
    if (size == 0) return any_perpendicular(forward);
    const wide3 f = widen(forward), u = {up.x / size, up.y / size, up.z / size};
    const wide3 across = wide_cross(f, u);
    // A few roundings: what is left of parallel vectors is noise.
    if (wide_dot(across, across) < 16 * DBL_EPSILON * DBL_EPSILON)
        return any_perpendicular(forward);
    // Near parallel, rounding leaves a part along f: it is taken away.
    const wide3 right = wide_along(across, -wide_dot(across, f) / wide_dot(f, f), f);
    const double length_of_right = sqrt(wide_dot(right, right));
    return (vec3){(real)(right.x / length_of_right), (real)(right.y / length_of_right),
                  (real)(right.z / length_of_right)};
}
