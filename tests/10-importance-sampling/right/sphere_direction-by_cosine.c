// Right: cos θ by the inverse of its cumulative density, the sine from 1 - cos θ; another frame.
#include "chapters/10-importance-sampling/importance.h"
#include "common/wide3.h"

vec3 sphere_direction(sphere S, vec3 x, rng *g) {
    const wide3 w = wide_sub(S.c, x);
    const double d = sqrt(wide_dot(w, w)), half = asin(fmin(S.r / d, 1)) / 2;
    const double c = 2 * sin(half) * sin(half) * (1 - (double)rng_real(g));
    const double phi = 2 * PI * (double)rng_real(g), sine = sqrt(c * (2 - c));
    const wide3 axis = {w.x / d, w.y / d, w.z / d};
    const vec3 other = fabs(axis.x) < 0.6 ? (vec3){1, 0, 0} : (vec3){0, 1, 0};
    const vec3 s = normalize(cross(other, narrow(axis))), t = cross(narrow(axis), s);
    const wide3 v = wide_along((wide3){0, 0, 0}, 1 - c, axis);
    return narrow(
        wide_along(wide_along(v, sine * cos(phi), widen(s)), sine * sin(phi), widen(t)));
}
