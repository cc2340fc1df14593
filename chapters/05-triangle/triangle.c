// triangle.c: see triangle.h. The derivations are in README.md.
#include "chapters/05-triangle/triangle.h"

#include <stdlib.h>

#include "common/die.h"
#include "common/wide3.h"

// ---- one triangle --------------------------------------------------------------

static wide3 wide_normal(triangle T) {
    return wide_cross(wide_sub(T.p2, T.p1), wide_sub(T.p3, T.p1));
}

vec3 triangle_normal(triangle T) {
    return narrow(wide_normal(T));
}

bool triangle_has_area(triangle T) {
    const wide3 n = wide_normal(T);
    return n.x != 0 || n.y != 0 || n.z != 0;
}

// u and v as shares of the area: the parts that p cuts off opposite p2 and p3.
static triangle_point shares(triangle T, vec3 n, vec3 p, real t) {
    const real area = dot(n, n);
    const real u = dot(cross(sub(T.p1, T.p3), sub(p, T.p3)), n) / area;
    const real v = dot(cross(sub(T.p2, T.p1), sub(p, T.p1)), n) / area;
    return (triangle_point){t, u, v};
}

triangle_point triangle_hit_slide(triangle T, ray r, real t_min, real t_max) {
    const triangle_point miss = {NO_HIT, 0, 0};
    const vec3 n = triangle_normal(T);
    const real t = plane_hit((plane){T.p1, n}, r, t_min, t_max);
    if (t == NO_HIT) return miss;
    const vec3 p = ray_at(r, t);
    return point_in_triangle(p, T, n) ? shares(T, n, p, t) : miss;
}

triangle_point triangle_hit(triangle T, ray r, real t_min, real t_max) {
    return watertight_hit(T, r, t_min, t_max);
}

hit triangle_surface(triangle T, ray r, triangle_point q) {
    const wide3 n = wide_normal(T); // its square may leave float's range
    const double length_of_n = sqrt(wide_dot(n, n));
    hit h = hit_at(r, q.t,
                   narrow((wide3){n.x / length_of_n, n.y / length_of_n, n.z / length_of_n}));
    // The double arithmetic inside: nothing beside float, as much as the rest in a double build.
    const vec3 sides = add(absolute(sub(T.p2, T.p1)), absolute(sub(T.p3, T.p1)));
    const vec3 extent = add(sides, absolute(scale(q.t, r.d)));
    h.error = add(h.error, scale((real)(4 * DBL_EPSILON), extent));
    return h;
}

// ---- many ------------------------------------------------------------------------

// Is the line of the ray at most r from the centre? |v x d| / |d| is its distance. The
// double arithmetic may be wrong by some roundings: a sphere is made larger by more.
static bool may_meet(sphere S, ray r) {
    const wide3 d = widen(r.d), w = wide_cross(wide_sub(r.O, S.c), d);
    const double rr = (double)S.r * S.r;
    return !(wide_dot(w, w) > (1 + 1e-12) * rr * wide_dot(d, d));
}

triangle_point mesh_hit(const mesh *m, ray r, real t_min, real t_max, int *index) {
    triangle_point nearest = {NO_HIT, 0, 0};
    if (m->finder) return m->finder->nearest(m->finder->tree, r, t_min, t_max, index);
    if (m->around.r > 0 && !may_meet(m->around, r)) return nearest;
    for (int i = 0; i < m->count; i++) {
        const triangle_point q = triangle_hit(mesh_triangle(m, i), r, t_min, t_max);
        if (q.t == NO_HIT) continue;
        nearest = q;
        t_max = q.t;
        *index = i;
    }
    return nearest;
}

bool mesh_any(const mesh *m, ray r, real t_min, real t_max) {
    if (m->finder) return m->finder->any(m->finder->tree, r, t_min, t_max);
    if (m->around.r > 0 && !may_meet(m->around, r)) return false;
    for (int i = 0; i < m->count; i++)
        if (triangle_hit(mesh_triangle(m, i), r, t_min, t_max).t != NO_HIT) return true;
    return false;
}

hit mesh_surface(const mesh *m, int index, ray r, triangle_point q) {
    hit h = triangle_surface(mesh_triangle(m, index), r, q);
    if (!m->normals) return h;
    const int *k = m->corners[index];
    h.n = smooth_normal(m->normals[k[0]], m->normals[k[1]], m->normals[k[2]], q.u, q.v);
    return h;
}

// ---- a torus -----------------------------------------------------------------------

void *mesh_room(long count, size_t size) {
    void *room = calloc((size_t)count, size);
    if (!room) die(EXIT_RUN, "no memory for %ld points or triangles of a mesh", count);
    return room;
}

// A point of the tube and its normal; i counts around the axis, k around the tube.
static void torus_points(vec3 *points, vec3 *normals, vec3 centre, vec3 axis, real ring,
                         real tube, int around, int across) {
    const vec3 up = normalize(axis), x = camera_right(up, (vec3){0, 0, 1}), y = cross(up, x);
    for (int i = 0; i < around; i++) {
        const real angle = (real)(2 * PI * i / around);
        const vec3 outwards = add(scale(cos(angle), x), scale(sin(angle), y));
        for (int k = 0; k < across; k++) {
            const real turn = (real)(2 * PI * k / across);
            const vec3 n = add(scale(cos(turn), outwards), scale(sin(turn), up));
            normals[i * across + k] = normalize(n);
            points[i * across + k] = add(centre, add(scale(ring, outwards), scale(tube, n)));
        }
    }
}

// Two triangles for each square of neighbouring points, counter-clockwise from outside.
static void torus_corners(int (*corners)[3], int around, int across) {
    for (int i = 0; i < around; i++) {
        for (int k = 0; k < across; k++) {
            const int next_i = (i + 1) % around, next_k = (k + 1) % across;
            const int a = i * across + k, b = next_i * across + k;
            const int c = next_i * across + next_k, d = i * across + next_k;
            int(*two)[3] = corners + 2 * (i * across + k);
            two[0][0] = a, two[0][1] = b, two[0][2] = c;
            two[1][0] = a, two[1][1] = c, two[1][2] = d;
        }
    }
}

mesh mesh_torus(vec3 centre, vec3 axis, real ring, real tube, int around, int across) {
    const int count = around * across;
    vec3 *points = mesh_room(count, sizeof *points),
         *normals = mesh_room(count, sizeof *normals);
    int(*corners)[3] = mesh_room(2 * count, sizeof *corners);
    torus_points(points, normals, centre, axis, ring, tube, around, across);
    torus_corners(corners, around, across);
    // Points are rounded at the size of their coordinates.
    const vec3 size = add(absolute(centre), (vec3){ring + tube, ring + tube, ring + tube});
    const real r = ring + tube + 8 * REAL_EPSILON * (size.x + size.y + size.z);
    return (mesh){.points = points,
                  .normals = normals,
                  .corners = (const int(*)[3])corners,
                  .count = 2 * count,
                  .around = {centre, r}};
}

void mesh_free(mesh *m) {
    free((void *)m->points);
    free((void *)m->normals);
    free((void *)m->corners);
    *m = (mesh){0};
}
