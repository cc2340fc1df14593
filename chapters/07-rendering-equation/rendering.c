// rendering.c: the rendering equation for one point, and directions about a normal.
#include "chapters/07-rendering-equation/rendering.h"

static wide3 stretched(double s, wide3 a) {
    return (wide3){s * a.x, s * a.y, s * a.z};
}

// Of two axes the one that is further from n. |n x a| = |n| |a|, since they are
// perpendicular.
wide3 perpendicular_at(vec3 n, double phi) {
    const wide3 up = widen(n);
    const wide3 axis = fabs(up.x) < fabs(up.y) ? (wide3){1, 0, 0} : (wide3){0, 1, 0};
    const wide3 a = wide_cross(axis, up), b = wide_cross(up, a);
    const double size = sqrt(wide_dot(a, a));
    return wide_along(stretched(cos(phi) / size, a), sin(phi) / (size * sqrt(wide_dot(up, up))),
                      b);
}

vec3 direction_at(vec3 n, double theta, double phi) {
    const wide3 up = widen(n);
    const double along = cos(theta) / sqrt(wide_dot(up, up));
    return narrow(wide_along(stretched(along, up), sin(theta), perpendicular_at(n, phi)));
}

// What stands under the integral, but for the cosine and the solid angle.
typedef struct {
    const lit_point *at;
    vec3 w_o;
} seen_point;

static double reflected(const void *data, vec3 x, vec3 w_i) {
    const seen_point *seen = data;
    const lit_point *at = seen->at;
    const double f_r = at->f_r(at->paint, at->n, w_i, seen->w_o);
    const double L_i = at->L_i(at->world, x, w_i);
    return f_r * L_i;
}

double outgoing_radiance(const lit_point *at, vec3 w_o, int n_theta, int n_phi) {
    const seen_point seen = {at, w_o};
    return at->L_e + irradiance(reflected, &seen, at->x, at->n, n_theta, n_phi);
}

double brdf_lambert(const void *rho, vec3 n, vec3 w_i, vec3 w_o) {
    (void)n, (void)w_i, (void)w_o;
    return lambert_brdf(*(const double *)rho);
}

double brdf_own(const void *data, vec3 n, vec3 w_i, vec3 w_o) {
    const gloss *m = data;
    return own_brdf(m->rho, m->shine, n, w_i, w_o);
}
