// area.c: integrals over the light in place of the hemisphere.
#include "chapters/07-rendering-equation/rendering.h"

// cos θ cos θ' / |v|² for v from one point to the other, n unit, normal2 of the length
// `area`: then times dA. Facing away on either side: nothing.
static double exchange(wide3 v, wide3 n, wide3 normal2) {
    const double square = wide_dot(v, v);
    const double here = wide_dot(v, n), there = -wide_dot(v, normal2);
    if (!(here > 0 && there > 0)) return 0;
    return (here / square) * (there / square);
}

// The point (u, v) of R, in units of its sides, seen from `from`.
static wide3 rectangle_point(rectangle R, vec3 from, double u, double v) {
    const wide3 corner = wide_sub(R.corner, from);
    return wide_along(wide_along(corner, u, widen(R.side1)), v, widen(R.side2));
}

static wide3 area_vector(rectangle R) {
    return wide_cross(widen(R.side1), widen(R.side2));
}

typedef struct {
    rectangle R;
    vec3 x, n;
} receiver;

static double from_point_of_light(const void *data, const double *u) {
    const receiver *r = data;
    const wide3 v = rectangle_point(r->R, r->x, u[0], u[1]);
    return exchange(v, widen(r->n), area_vector(r->R));
}

double rectangle_irradiance_by_area(quadrature rule, int n, rectangle R, vec3 x, vec3 normal) {
    const receiver r = {R, x, normal};
    return integrate_cube(rule, n, 2, from_point_of_light, &r);
}

typedef struct {
    rectangle a, b;
} two_rectangles;

// From the point (u0, u1) of a to the point (u2, u3) of b.
static double between_points(const void *data, const double *u) {
    const two_rectangles *r = data;
    const wide3 on_a = rectangle_point(r->a, r->b.corner, u[0], u[1]);
    const wide3 on_b = rectangle_point(r->b, r->b.corner, u[2], u[3]);
    const wide3 area_a = area_vector(r->a);
    const double size = sqrt(wide_dot(area_a, area_a));
    const wide3 n = {area_a.x / size, area_a.y / size, area_a.z / size};
    return exchange(wide_along(on_b, -1, on_a), n, area_vector(r->b)) / PI;
}

// The mean over a of the share of its light that goes to b.
double form_factor(quadrature rule, int n, rectangle a, rectangle b) {
    const two_rectangles r = {a, b};
    return integrate_cube(rule, n, 4, between_points, &r);
}

static double lambert_at_point(const void *data, const double *u) {
    const two_rectangles *r = data;
    const wide3 p = rectangle_point(r->a, (vec3){0, 0, 0}, u[0], u[1]);
    return rectangle_irradiance(r->b, narrow(p), normalize(narrow(area_vector(r->a)))) / PI;
}

double form_factor_lambert(quadrature rule, int n, rectangle a, rectangle b) {
    const two_rectangles r = {a, b};
    return integrate_cube(rule, n, 2, lambert_at_point, &r);
}
