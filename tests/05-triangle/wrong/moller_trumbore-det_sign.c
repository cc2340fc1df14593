// Wrong: the determinant has the wrong sign.
// Expect: a miss: det or s = O - p1 the wrong way round
#include "chapters/05-triangle/triangle.h"
#include "common/wide3.h"

// u e1 + v e2 - t d = s by Cramer's rule. The determinant is written d·n, so that
// it is exactly 0 where the area is.
triangle_point moller_trumbore(triangle T, ray r, real t_min, real t_max) {
    const triangle_point miss = {NO_HIT, 0, 0};
    const wide3 d = widen(r.d), s = wide_sub(r.O, T.p1);
    const wide3 e1 = wide_sub(T.p2, T.p1), e2 = wide_sub(T.p3, T.p1);
    const wide3 n = wide_cross(e1, e2), c = wide_cross(s, d);
    const double det = wide_dot(d, n);
    if (det == 0) return miss;
    const double u = wide_dot(e2, c), v = -wide_dot(e1, c), w = det - u - v; // times det
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return miss;
    const real t = (real)(wide_dot(n, s) / det);
    if (!(t > t_min && t < t_max)) return miss;
    return (triangle_point){t, (real)(u / det), (real)(v / det)};
}
