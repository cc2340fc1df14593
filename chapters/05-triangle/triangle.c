// triangle.c: see triangle.h. The derivations are in README.md.
#include "chapters/05-triangle/triangle.h"

vec3 triangle_normal(triangle T) {
    return cross(sub(T.p2, T.p1), sub(T.p3, T.p1));
}

triangle_point triangle_hit(triangle T, ray r, real t_min, real t_max) {
    return watertight_hit(T, r, t_min, t_max);
}

hit triangle_surface(triangle T, ray r, triangle_point q) {
    return hit_at(r, q.t, normalize(triangle_normal(T)));
}

triangle_point mesh_hit(const mesh *m, ray r, real t_min, real t_max, int *index) {
    triangle_point nearest = {NO_HIT, 0, 0};
    for (int i = 0; i < m->count; i++) {
        const triangle_point q = triangle_hit(mesh_triangle(m, i), r, t_min, t_max);
        if (q.t == NO_HIT) continue;
        nearest = q;
        t_max = q.t;
        *index = i;
    }
    return nearest;
}
