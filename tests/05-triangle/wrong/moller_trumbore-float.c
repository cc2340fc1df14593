// Wrong: all in float, as published.
// Expect: Float products cancel here. Compute in double.
#include "chapters/05-triangle/triangle.h"

triangle_point moller_trumbore(triangle T, ray r, real t_min, real t_max) {
    const triangle_point miss = {NO_HIT, 0, 0};
    const vec3 e1 = sub(T.p2, T.p1), e2 = sub(T.p3, T.p1), s = sub(r.O, T.p1);
    const vec3 p = cross(r.d, e2), q = cross(s, e1);
    const float det = (float)dot(e1, p);
    if (det == 0) return miss;
    const float u = (float)dot(s, p) / det, v = (float)dot(r.d, q) / det;
    if (!(u >= 0 && v >= 0 && u + v <= 1)) return miss;
    const float t = (float)dot(e2, q) / det;
    return t > t_min && t < t_max ? (triangle_point){t, u, v} : miss;
}
