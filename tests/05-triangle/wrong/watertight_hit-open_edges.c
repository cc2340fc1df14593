// Wrong: a weight of 0 is a miss: the edges are left out.
// Expect: Edges and corners belong to the triangle
#include "chapters/05-triangle/triangle.h"
#include "common/wide3.h"

// The axis along which d is longest.
static int main_axis(vec3 d) {
    const vec3 a = absolute(d);
    if (a.x >= a.y && a.x >= a.z) return 0;
    return a.y >= a.z ? 1 : 2;
}

// The axes renamed in their order, so that `axis` becomes z.
static wide3 turned(wide3 a, int axis) {
    if (axis == 0) return (wide3){a.y, a.z, a.x};
    if (axis == 1) return (wide3){a.z, a.x, a.y};
    return a;
}

// p - O in a frame where the ray is the z axis: x and y are sheared, times d.z, so
// that they vanish on the ray. Only p and the ray enter: all triangles agree on a
// corner that they share.
static wide3 seen_along(ray r, wide3 d, int axis, vec3 p) {
    const wide3 a = turned(wide_sub(p, r.O), axis);
    return (wide3){a.x * d.z - a.z * d.x, a.y * d.z - a.z * d.y, a.z};
}

// Twice the signed area of the origin, a and b. Rounding may turn it to 0 but never
// turns its sign, and b, a gives minus a, b to the last bit: so the two triangles at
// an edge never both refuse it.
static double edge(wide3 a, wide3 b) {
    return a.x * b.y - a.y * b.x;
}

triangle_point watertight_hit(triangle T, ray r, real t_min, real t_max) {
    const triangle_point miss = {NO_HIT, 0, 0};
    const int axis = main_axis(r.d);
    const wide3 d = turned(widen(r.d), axis);
    const wide3 a = seen_along(r, d, axis, T.p1), b = seen_along(r, d, axis, T.p2),
                c = seen_along(r, d, axis, T.p3);
    const double u = edge(c, a), v = edge(a, b), w = edge(b, c); // weights of p2, p3, p1
    if (!((u < 0 && v < 0 && w < 0) || (u > 0 && v > 0 && w > 0))) return miss;
    const double det = u + v + w;
    if (det == 0) return miss;
    const real t = (real)((w * a.z + u * b.z + v * c.z) / (det * d.z));
    if (!(t > t_min && t < t_max) || !triangle_has_area(T)) return miss;
    return (triangle_point){t, (real)(u / det), (real)(v / det)};
}
