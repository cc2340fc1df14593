#include "chapters/05-triangle/triangle.h"
#include "common/wide3.h"

static double component(vec3 v, int axis) {
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

// The axis along which d is longest.
static int main_axis(vec3 d) {
    const vec3 a = absolute(d);
    if (a.x >= a.y && a.x >= a.z) return 0;
    return a.y >= a.z ? 1 : 2;
}

// p seen from O in a frame where the ray is the z axis: x and y are sheared so
// that they vanish on the ray. Only p and the ray enter, so that two triangles
// agree on a corner that they share.
static wide3 sheared(vec3 p, ray r, int kz) {
    const int kx = (kz + 1) % 3, ky = (kz + 2) % 3;
    const double z = (component(p, kz) - component(r.O, kz)) / component(r.d, kz); // its t
    return (wide3){component(p, kx) - component(r.O, kx) - component(r.d, kx) * z,
                   component(p, ky) - component(r.O, ky) - component(r.d, ky) * z, z};
}

// Twice the signed area of the origin, a and b: minus itself when a and b swap
// places, to the last bit, so that an edge's two triangles never both refuse it.
static double edge(wide3 a, wide3 b) {
    return a.x * b.y - a.y * b.x;
}

triangle_point watertight_hit(triangle T, ray r, real t_min, real t_max) {
    const triangle_point miss = {NO_HIT, 0, 0};
    const int kz = main_axis(r.d);
    if (component(r.d, kz) == 0) return miss;
    const wide3 a = sheared(T.p1, r, kz), b = sheared(T.p2, r, kz), c = sheared(T.p3, r, kz);
    const double u = edge(c, a), v = edge(a, b), w = edge(b, c); // weights of p2, p3, p1
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return miss;
    const double det = u + v + w;
    if (det == 0) return miss;
    const real t = (real)((w * a.z + u * b.z + v * c.z) / det);
    if (!(t > t_min && t < t_max)) return miss;
    return (triangle_point){t, (real)(u / det), (real)(v / det)};
}
