// Right: the shear with the division at the start.
#include "chapters/05-triangle/triangle.h"

static double component(vec3 v, int axis) {
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

typedef struct {
    double x, y, z;
} corner;

static corner sheared(vec3 p, ray r, int kz) {
    const int kx = (kz + 1) % 3, ky = (kz + 2) % 3;
    const double z = (component(p, kz) - component(r.O, kz)) / component(r.d, kz);
    return (corner){component(p, kx) - component(r.O, kx) - component(r.d, kx) * z,
                    component(p, ky) - component(r.O, ky) - component(r.d, ky) * z, z};
}

static double edge(corner a, corner b) {
    return a.x * b.y - a.y * b.x;
}

triangle_point watertight_hit(triangle T, ray r, real t_min, real t_max) {
    const triangle_point miss = {NO_HIT, 0, 0};
    const vec3 l = absolute(r.d);
    const int kz = l.x >= l.y && l.x >= l.z ? 0 : l.y >= l.z ? 1 : 2;
    if (component(r.d, kz) == 0 || !triangle_has_area(T)) return miss;
    const corner a = sheared(T.p1, r, kz), b = sheared(T.p2, r, kz), c = sheared(T.p3, r, kz);
    const double u = edge(c, a), v = edge(a, b), w = edge(b, c), det = u + v + w;
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return miss;
    const real t = (real)((w * a.z + u * b.z + v * c.z) / det);
    if (det == 0 || !(t > t_min && t < t_max)) return miss;
    return (triangle_point){t, (real)(u / det), (real)(v / det)};
}
