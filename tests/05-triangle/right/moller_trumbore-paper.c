// Right: the paper's own order of products, with divided weights.
#include "chapters/05-triangle/triangle.h"
#include "common/wide3.h"

triangle_point moller_trumbore(triangle T, ray r, real t_min, real t_max) {
    const triangle_point miss = {NO_HIT, 0, 0};
    const wide3 d = widen(r.d), s = wide_sub(r.O, T.p1);
    const wide3 e1 = wide_sub(T.p2, T.p1), e2 = wide_sub(T.p3, T.p1);
    const wide3 p = wide_cross(d, e2), q = wide_cross(s, e1);
    const double det = wide_dot(e1, p);
    if (det == 0 || !triangle_has_area(T)) return miss;
    const double u = wide_dot(s, p) / det, v = wide_dot(d, q) / det;
    if (!(u >= 0 && v >= 0 && u + v <= 1)) return miss;
    const real t = (real)(wide_dot(e2, q) / det);
    return t > t_min && t < t_max ? (triangle_point){t, (real)u, (real)v} : miss;
}
