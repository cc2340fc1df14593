// lights.c: lights of radiance 1: what arrives from a direction, and the irradiance in
// closed form.
#include "chapters/07-rendering-equation/rendering.h"

double from_uniform_sky(const void *nothing, vec3 x, vec3 w) {
    (void)nothing, (void)x, (void)w;
    return 1;
}

double from_sphere(const void *S, vec3 x, vec3 w) {
    return sphere_hit(*(const sphere *)S, (ray){x, w}, 0, NO_HIT) < NO_HIT;
}

double from_disc(const void *D, vec3 x, vec3 w) {
    return disc_hit(*(const disc *)D, (ray){x, w}, 0, NO_HIT) < NO_HIT;
}

// The ray meets the plane at t = above / approach; where, counts in the sides.
double from_rectangle(const void *data, vec3 x, vec3 w) {
    const rectangle *R = data;
    const wide3 s1 = widen(R->side1), s2 = widen(R->side2), d = widen(w);
    const wide3 normal = wide_cross(s1, s2), from_corner = wide_sub(x, R->corner);
    const double above = wide_dot(from_corner, normal), approach = -wide_dot(d, normal);
    if (!(above > 0 && approach > 0)) return 0;
    const wide3 p = wide_along(from_corner, above / approach, d);
    const double a = wide_dot(p, s1) / wide_dot(s1, s1), b = wide_dot(p, s2) / wide_dot(s2, s2);
    return a >= 0 && a <= 1 && b >= 0 && b <= 1;
}

// The sphere is a cap of directions with the radius σ about a, which stands at the angle
// ω from n. ψ counts along its rim, from the top: above the horizon up to ψ = psi.
// E = ½ ∮ (w x dw)·n: the rim's part, and beta from the horizon between its ends.
double sphere_irradiance(sphere S, vec3 x, vec3 n) {
    const wide3 to_centre = wide_sub(S.c, x), up = widen(n);
    const double d = sqrt(wide_dot(to_centre, to_centre));
    const double sin_s = S.r / d, cos_s = sqrt((1 - sin_s) * (1 + sin_s));
    const double cos_w = wide_dot(to_centre, up) / d;
    if (cos_w >= sin_s) return PI * sin_s * sin_s * cos_w;
    if (cos_w <= -sin_s) return 0;
    const double sin_w = sqrt((1 - cos_w) * (1 + cos_w));
    const double psi = acos(fmax(-1, fmin(1, -cos_s * cos_w / (sin_s * sin_w))));
    const double beta = atan2(sin_s * sin(psi), cos_s / sin_w);
    return beta + psi * sin_s * sin_s * cos_w - sin_s * cos_s * sin_w * sin(psi);
}

// The part of the edge from a along `side`: its angle seen from the origin, times the
// cosine between n and the normal of the plane through both. a x side is the same as
// a x b, b = a + side, and keeps its digits when the edge is short; atan2 keeps the angle's.
static double edge_part(wide3 a, wide3 side, wide3 n) {
    const wide3 b = wide_along(a, 1, side), normal = wide_cross(a, side);
    const double size = sqrt(wide_dot(normal, normal));
    if (size == 0) return 0; // the edge points at x
    return atan2(size, wide_dot(a, b)) * wide_dot(normal, n) / size;
}

double rectangle_irradiance(rectangle R, vec3 x, vec3 n) {
    const wide3 s1 = widen(R.side1), s2 = widen(R.side2), up = widen(n);
    const wide3 p0 = wide_sub(R.corner, x), p1 = wide_along(p0, 1, s1);
    const wide3 p3 = wide_along(p0, 1, s2);
    if (!(wide_dot(p0, wide_cross(s1, s2)) < 0)) return 0;
    // Seen from the front the corners go round against the clock; from above x, with it.
    return -(edge_part(p0, s1, up) + edge_part(p1, s2, up) - edge_part(p3, s1, up) -
             edge_part(p0, s2, up)) /
           2;
}
