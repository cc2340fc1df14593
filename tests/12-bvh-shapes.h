// 12-bvh-shapes.h: the part of 12-bvh.c about the generated meshes.
#ifndef TESTS_12_BVH_SHAPES_H
#define TESTS_12_BVH_SHAPES_H

#include <stdlib.h>
#include <string.h>

#include "chapters/12-bvh/draft.h"
#include "chapters/12-bvh/noise.h"
#include "chapters/12-bvh/shapes.h"
#include "tests/check-directions.h"

static const long wanted[] = {1, 2, 12, 100, 10000, 300000};
enum { FEW = 5 }; // of them are small

static mesh shape_made(const shape *s, long triangles) {
    const mesh m = s->make(triangles);
    given("shape_%s(%ld): %d triangles", s->name, triangles, m.count);
    return m;
}

static bool same_shape(const shape *s, mesh (*make)(long)) {
    return s->make == make;
}

static int points_of(const mesh *m) {
    int last = -1;
    for (int i = 0; i < m->count; i++)
        for (int k = 0; k < 3; k++)
            if (m->corners[i][k] > last) last = m->corners[i][k];
    return last + 1;
}

// ---- how many ---------------------------------------------------------------------------

// Of the numbers unit k², k >= 1, the one nearest to n.
static long nearest_square(long unit, long n) {
    long best = unit;
    for (long k = 1; unit * (k - 1) * (k - 1) <= n; k++)
        if (labs(unit * k * k - n) < labs(best - n)) best = unit * k * k;
    return best;
}

static int sponge_level(long n) {
    static const long all[] = {12, 144, 2112, 36096, 672768, 13062144};
    int level = 0;
    while (level + 1 < COUNT(all) && 2 * all[level + 1] <= 3 * n) level++;
    return level;
}

static void shape_counts(void) {
    rng g = check_rng(1201);
    for (int i = 0; i < 60; i++) {
        const long n = i < COUNT(wanted) ? wanted[i] : (long)exp(between(&g, 0, log(20000)));
        static const struct {
            mesh (*make)(long);
            long unit;
        } squares[] = {{shape_icosphere, 20}, {shape_hills, 2}, {shape_cave, 20}};
        for (int s = 0; s < COUNT(squares); s++) {
            mesh m = squares[s].make(n);
            given("%ld triangles of shape %d", n, s);
            CHECK_INT(m.count, nearest_square(squares[s].unit, n));
            mesh_free(&m);
        }
    }
}

static void shape_counts_near(void) {
    static const struct {
        mesh (*make)(long);
        long least;
    } rows[] = {{shape_knot, 72},
                {shape_sphereflake, 20},
                {shape_sponge, 12},
                {shape_cloud, 1},
                {shape_stadium, 84}};
    rng g = check_rng(1202);
    for (int i = 0; i < 60; i++) {
        const long n = i < COUNT(wanted) ? wanted[i] : (long)exp(between(&g, 0, log(20000)));
        for (int s = 0; s < COUNT(rows); s++) {
            mesh m = rows[s].make(n);
            given("%ld triangles of shape %d: %d", n, s, m.count);
            CHECK(m.count >= rows[s].least, "not less than the smallest");
            CHECK(m.count >= 0.4 * (double)n, "at least 0.4 times as many");
            CHECK(m.count == rows[s].least || m.count <= 1.6 * (double)n, "at most 1.6 times");
            mesh_free(&m);
        }
    }
}

// ---- sound ------------------------------------------------------------------------------

static void check_sound(const mesh *m) {
    for (int i = 0; i < m->count; i++) {
        const triangle T = mesh_triangle(m, i);
        if (!is_finite(T.p1) || !is_finite(T.p2) || !is_finite(T.p3) || !triangle_has_area(T)) {
            given("triangle %d of %d: " VEC ", " VEC ", " VEC, i, m->count, ARG(T.p1),
                  ARG(T.p2), ARG(T.p3));
            CHECK(false, "finite corners and an area");
        }
    }
    double furthest = 0;
    const int points = points_of(m);
    for (int i = 0; i < points; i++) furthest = fmax(furthest, wide_length(m->points[i]));
    CHECK_AT_MOST(furthest, 1 + REAL_EPSILON, "within the ball of radius 1, rounded");
    CHECK_AT_MOST(furthest, m->around.r, "within the sphere around the mesh");
    CHECK_AT_MOST(m->around.r, furthest * (1 + 4 * REAL_EPSILON),
                  "which is no larger than that");
}

static void shape_sound(void) {
    for (const shape *s = shapes; s->name; s++) {
        for (int i = 0; i < COUNT(wanted); i++) {
            mesh m = shape_made(s, wanted[i]);
            check_sound(&m);
            mesh_free(&m);
        }
    }
}

static bool same_bits(const mesh *a, const mesh *b) {
    const size_t points = (size_t)points_of(a);
    return a->count == b->count && !memcmp(a->points, b->points, points * sizeof(vec3)) &&
           !memcmp(a->corners, b->corners, (size_t)a->count * sizeof *a->corners) &&
           !a->normals == !b->normals &&
           (!a->normals || !memcmp(a->normals, b->normals, points * sizeof(vec3)));
}

static void shape_repeats(void) {
    for (const shape *s = shapes; s->name; s++) {
        mesh a = shape_made(s, 10000), b = s->make(10000);
        CHECK(same_bits(&a, &b), "made twice it is the same, bit for bit");
        mesh_free(&a);
        mesh_free(&b);
    }
}

// ---- closed -----------------------------------------------------------------------------

// Where the edges from each point lead to: those of point i are `to` from start[i] on.
typedef struct {
    int points, edges, *start, *to;
} edge_list;

static edge_list edges_of(const mesh *m) {
    const int points = points_of(m);
    edge_list e = {points, 3 * m->count, mesh_room(points + 2L, sizeof(int)),
                   mesh_room(3L * m->count, sizeof(int))};
    int *next = e.start + 1; // counts, then where the next edge of a point is noted
    for (int i = 0; i < m->count; i++)
        for (int k = 0; k < 3; k++) next[m->corners[i][k] + 1]++;
    for (int i = 0; i < points; i++) next[i + 1] += next[i];
    for (int i = 0; i < m->count; i++)
        for (int k = 0; k < 3; k++) e.to[next[m->corners[i][k]]++] = m->corners[i][(k + 1) % 3];
    return e;
}

static void edges_free(edge_list *e) {
    free(e->start);
    free(e->to);
}

static int times_used(const edge_list *e, int from, int to) {
    int times = 0;
    for (int i = e->start[from]; i < e->start[from + 1]; i++) times += e->to[i] == to;
    return times;
}

// Edges with no triangle on the other side; more than one on a side is an error at once.
static long open_edges(const edge_list *e) {
    long open = 0;
    for (int a = 0; a < e->points; a++) {
        for (int i = e->start[a]; i < e->start[a + 1]; i++) {
            const int there = times_used(e, a, e->to[i]), back = times_used(e, e->to[i], a);
            if (there != 1 || back > 1) return -1;
            open += back == 0;
        }
    }
    return open;
}

// V - E + F: twice the number of bodies, less two for each handle. Of a closed mesh.
static long euler(const edge_list *e) {
    long used = 0;
    for (int i = 0; i < e->points; i++) used += e->start[i + 1] > e->start[i];
    return used - e->edges / 2 + e->edges / 3;
}

// A sponge is twenty smaller ones, and two of them touch at 24 places, each a Sierpiński
// carpet: χ' = 20 χ - 24 (1 - holes). The surface has 2 χ.
static long sponge_euler(int level) {
    long chi = 1, holes = 0, eight = 1;
    for (int i = 0; i < level; i++) {
        chi = 20 * chi - 24 * (1 - holes);
        holes += eight, eight *= 8;
    }
    return 2 * chi;
}

static long flake_balls(const mesh *m) {
    long balls = 0; // each begins with its poles, opposite each other
    const int points = points_of(m);
    for (int i = 0; i + 1 < points; i++) {
        const wide3 n = widen(m->normals[i]), o = widen(m->normals[i + 1]);
        balls += n.x == 0 && n.y == 0 && n.z == 1 && o.x == 0 && o.y == 0 && o.z == -1;
    }
    return balls;
}

static void check_closed(const shape *s, long triangles, const mesh *m) {
    edge_list e = edges_of(m);
    const long open = same_shape(s, shape_hills)   ? 4 * lround(sqrt(m->count / 2.0))
                      : same_shape(s, shape_cloud) ? 3L * m->count
                                                   : 0;
    CHECK_INT(open_edges(&e), open);
    if (open == 0) {
        const long chi = same_shape(s, shape_knot)     ? 0
                         : same_shape(s, shape_sponge) ? sponge_euler(sponge_level(triangles))
                         : same_shape(s, shape_sphereflake) ? 2 * flake_balls(m)
                                                            : 2;
        CHECK_INT(euler(&e), chi);
    }
    edges_free(&e);
}

static void shape_closed(void) {
    for (const shape *s = shapes; s->name; s++) {
        for (int i = 0; i < COUNT(wanted); i++) {
            mesh m = shape_made(s, wanted[i]);
            check_closed(s, wanted[i], &m);
            mesh_free(&m);
        }
    }
}

// One ball; then 9 more whenever a third of its fineness is at least 2: 20 balls' fineness
// 1, 5, 6, 18.
static void flake_levels(void) {
    static const struct {
        long triangles, balls;
    } rows[] = {{20, 1}, {500, 1}, {1440, 10}, {20 * (18 * 18 + 9 * 6 * 6 + 81 * 2 * 2), 91}};
    for (int i = 0; i < COUNT(rows); i++) {
        mesh m = shape_sphereflake(rows[i].triangles);
        given("shape_sphereflake(%ld)", rows[i].triangles);
        CHECK_INT(m.count, rows[i].triangles);
        CHECK_INT(flake_balls(&m), rows[i].balls);
        mesh_free(&m);
    }
}

// Ball i of a flake, by its poles: they stand first among its 10 k² + 2 points.
typedef struct {
    wide3 c;
    double r;
} flake_ball;

static int flake_list(const mesh *m, flake_ball *balls) {
    int made = 0;
    const int points = points_of(m);
    for (int i = 0; i + 1 < points; i++) {
        if (m->normals[i].z != 1 || m->normals[i + 1].z != -1) continue;
        const wide3 a = widen(m->points[i]), b = widen(m->points[i + 1]);
        balls[made++] =
            (flake_ball){{(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2}, (a.z - b.z) / 2};
    }
    return made;
}

static double gap(flake_ball a, flake_ball b) {
    const wide3 apart = wide_along(a.c, -1, b.c);
    return sqrt(wide_dot(apart, apart)) - a.r - b.r;
}

// Every ball but the first sits on one three times as large; no two overlap.
static void flake_touches(void) {
    static flake_ball balls[91];
    mesh m = shape_sphereflake(20 * (18 * 18 + 9 * 6 * 6 + 81 * 2 * 2));
    given("the 91 balls of a sphereflake");
    CHECK_INT(flake_balls(&m), 91);
    const int count = flake_list(&m, balls);
    const double rounded = 8 * REAL_EPSILON;
    for (int i = 0; i < count; i++) {
        int carriers = 0;
        for (int k = 0; k < count; k++) {
            if (k == i) continue;
            given("balls %d and %d", i, k);
            CHECK(gap(balls[i], balls[k]) > -rounded, "they do not overlap");
            carriers += fabs(balls[k].r - 3 * balls[i].r) < rounded &&
                        gap(balls[i], balls[k]) < rounded;
        }
        given("ball %d, r = %g", i, balls[i].r);
        CHECK_INT(carriers, i > 0);
    }
    mesh_free(&m);
}

// ---- volume and normals ---------------------------------------------------------------

// Of the triangles from `first` on, by Gauss: positive where they face outwards. Added up
// without rounding to speak of.
static double volume_of(const mesh *m, int first, int end) {
    exact sum = 0;
    for (int i = first; i < end; i++) {
        const triangle T = mesh_triangle(m, i);
        sum += wide_dot(widen(T.p1), wide_cross(widen(T.p2), widen(T.p3))) / 6;
    }
    return (double)sum;
}

static double volume_made(mesh (*make)(long), long triangles) {
    mesh m = make(triangles);
    const double V = volume_of(&m, 0, m.count);
    mesh_free(&m);
    return V;
}

// Each point is rounded by half an ulp: over the surface that adds up to less than this.
static allowance rounded_points(void) {
    return relative_to(4 * REAL_EPSILON, "rounded points");
}

static void icosphere_volume(void) {
    given("the icosahedron: (5/12)(3 + √5) a³ with the edge a = 4 / √(10 + 2√5)");
    const double a = 4 / sqrt(10 + 2 * sqrt(5.0));
    CHECK_REAL(volume_made(shape_icosphere, 20), 5 * (3 + sqrt(5.0)) / 12 * a * a * a,
               rounded_points());
    double missing = 0;
    for (long k = 8; k <= 64; k *= 2) {
        const double now = 4 * PI / 3 - volume_made(shape_icosphere, 20 * k * k);
        given("faces cut in %ld²: 4π/3 less the volume, and the same with half as many", k);
        CHECK(now > 0, "inside the sphere");
        if (k > 8)
            CHECK_REAL(missing / now, 4,
                       relative_to(2.0 / (double)k, "as 1/k², and further terms"));
        missing = now;
    }
}

static void sponge_volume(void) {
    static const long counts[] = {12, 144, 144 * 9, 2112, 36096, 36096 * 4, 672768};
    for (int i = 0; i < COUNT(counts); i++) {
        mesh m = shape_sponge(counts[i]);
        given("shape_sponge(%ld): the volume is (20/27)^level", counts[i]);
        CHECK_INT(m.count, counts[i]);
        // Faces inside are rounded each by itself: their area is what the rounding weighs with.
        const double area = 6 * pow(20.0 / 9, sponge_level(counts[i]));
        CHECK_REAL(volume_of(&m, 0, m.count), pow(20.0 / 27, sponge_level(counts[i])),
                   absolute_of(area * REAL_EPSILON / 4, "planes rounded by half an ulp"));
        mesh_free(&m);
    }
}

// ∫ |c'| dt over the knot's middle line; the trapezoid rule is exact to the last digits for
// a periodic function.
static double knot_length(void) {
    enum { STEPS = 2000 };
    double sum = 0;
    for (int i = 0; i < STEPS; i++) {
        const double t = 2 * PI * i / STEPS, far = 0.55 + 0.28 * cos(3 * t);
        sum += sqrt(4 * far * far + 9 * 0.28 * 0.28);
    }
    return 2 * PI * sum / STEPS;
}

// A circle of radius r cut in n has the area π r² (1 - (2π/n)²/6); along the knot the squares are
// as long as across, and the tube bends no more: at most as much again.
static void knot_volume(void) {
    double missing = 0;
    for (long n = 20000; n <= 320000; n *= 4) {
        const double V = PI * 0.17 * 0.17 * knot_length(), now = V - volume_made(shape_knot, n);
        const double turn = 2 * PI / sqrt((double)n / 2 * 2 * PI * 0.17 / knot_length());
        given("a knot of %ld triangles: π r² times length, less the volume", n);
        CHECK(now > 0, "inside the tube");
        CHECK_AT_MOST(now, V * turn * turn / 3, "polygons in the place of curves");
        given("the same of %ld triangles and of a quarter", n);
        if (n > 20000)
            CHECK_REAL(missing / now, 4,
                       relative_to(0.1, "as 1/n; the grid is rounded to whole"));
        missing = now;
    }
}

static void flake_volume(void) {
    static const struct {
        long triangles;
        int finest, middle, least;
    } rows[] = {
        {500, 5, 0, 0}, {1440, 6, 2, 0}, {20 * (18 * 18 + 9 * 6 * 6 + 81 * 2 * 2), 18, 6, 2}};
    for (int i = 0; i < COUNT(rows); i++) {
        const long k[] = {rows[i].finest, rows[i].middle, rows[i].least};
        double V = 0, part = 1.0 / 8;
        for (int level = 0; level < 3; level++, part /= 3)
            if (k[level]) V += part * volume_made(shape_icosphere, 20 * k[level] * k[level]);
        given("shape_sphereflake(%ld): the sum of its balls", rows[i].triangles);
        CHECK_REAL(volume_made(shape_sphereflake, rows[i].triangles), V, rounded_points());
    }
}

static void cave_volume(void) {
    const double V = 4 * PI / 3 * 0.62 * 0.62 * 0.62;
    for (long n = 20000; n <= 320000; n *= 4) {
        given("a cave of %ld triangles: shears keep the volume of the sphere", n);
        CHECK_REAL(volume_made(shape_cave, n), -V,
                   relative_to(100.0 / (double)n, "what its triangles cut off, as 1/n"));
    }
}

static void stadium_parts(void) {
    mesh m = shape_stadium(10000), knot = shape_knot(10000 - 12);
    const int hall = m.count - 12;
    given("shape_stadium(10000)");
    CHECK_INT(hall, knot.count);
    CHECK_REAL(volume_of(&m, 0, hall), 1e-9 * volume_of(&knot, 0, knot.count),
               rounded_points());
    CHECK_REAL(volume_of(&m, hall, m.count), -(1 * 0.401 * 1),
               relative_to(4 * REAL_EPSILON, "a box, seen from inside"));
    mesh_free(&m);
    mesh_free(&knot);
}

static void check_normals(const shape *s, const mesh *m) {
    for (int i = 0; i < m->count; i++) {
        const triangle T = mesh_triangle(m, i);
        for (int k = 0; k < 3; k++) {
            const vec3 n = m->normals[m->corners[i][k]];
            if (fabs(wide_length(n) - 1) < 2 * REAL_EPSILON &&
                cosine(n, triangle_normal(T)) > 0)
                continue;
            given("%s, triangle %d of %d: normal " VEC, s->name, i, m->count, ARG(n));
            CHECK_REAL(wide_length(n), 1, roundings(4, "a unit vector"));
            CHECK(cosine(n, triangle_normal(T)) > 0, "on the side of the orientation");
        }
    }
}

static void shape_normals(void) {
    for (const shape *s = shapes; s->name; s++) {
        const bool smooth = same_shape(s, shape_icosphere) || same_shape(s, shape_hills) ||
                            same_shape(s, shape_knot) || same_shape(s, shape_sphereflake);
        mesh m = shape_made(s, 300000);
        CHECK_BOOL(m.normals != NULL, smooth);
        if (smooth) check_normals(s, &m);
        mesh_free(&m);
    }
}

// ---- noise --------------------------------------------------------------------------------

static void noise_slopes(void) {
    rng g = check_rng(1203);
    const double h = 1e-5;
    for (int i = 0; i < 3000; i++) {
        const double x = between(&g, -50, 50), y = between(&g, -50, 50);
        const uint32_t seed = rng_bits(&g);
        const noise n = noise_at(x, y, seed);
        given("noise at (%.17g, %.17g), seed %u", x, y, (unsigned)seed);
        const double east = noise_at(x + h, y, seed).value,
                     west = noise_at(x - h, y, seed).value;
        const double south = noise_at(x, y - h, seed).value,
                     up = noise_at(x, y + h, seed).value;
        const allowance differences = absolute_of(1e-8, "differences over 2e-5: h² of a third "
                                                        "derivative below 60, and its jumps");
        CHECK_REAL(n.x, (east - west) / (2 * h), differences);
        CHECK_REAL(n.y, (up - south) / (2 * h), differences);
        CHECK_AT_MOST(fabs(n.value), 1, "between -1 and 1");
    }
}

static void noise_corners(void) {
    running slopes = {0};
    for (int i = -40; i < 40; i++) {
        for (int j = -40; j < 40; j++) {
            const noise n = noise_at(i, j, 7);
            given("noise at (%d, %d)", i, j);
            CHECK_REAL(n.value, 0, exactly());
            running_add(&slopes, n.x);
            running_add(&slopes, n.y);
        }
    }
    given("the slopes at 6,400 whole points, uniform from -1 to 1");
    CHECK_REAL(slopes.mean, 0, standard_errors(5, running_standard_error(&slopes)));
    CHECK_REAL(running_variance(&slopes), 1.0 / 3, // the fourth moment is 1/5
               standard_errors(5, sqrt((0.2 - 1.0 / 9) / (double)slopes.n)));
}

// ---- the cloud ------------------------------------------------------------------------------

static void cloud_uniform(void) {
    enum { GRAINS = 200000 };
    mesh m = shape_cloud(GRAINS);
    const double size = 1 / (1 + sqrt((double)GRAINS));
    tally places = {{0}, 0}, heights = {{0}, 0}, directions = {{0}, 0};
    for (int i = 0; i < m.count; i++) {
        const triangle T = mesh_triangle(&m, i);
        const wide3 c = widen(scale((real)1 / 3, add(T.p1, add(T.p2, T.p3))));
        const double r = sqrt(wide_dot(c, c)) / (1 - size),
                     around = atan2(c.y, c.x) / (2 * PI) + 0.5;
        const wide3 n = wide_unit(widen(triangle_normal(T)));
        tally_add(&places, r * r * r, around);
        tally_add(&heights, (c.z / (1 - size) / r + 1) / 2, around);
        tally_add(&directions, (n.z + 1) / 2, atan2(n.y, n.x) / (2 * PI) + 0.5);
    }
    given("the centres of 200,000 triangles: r³ and the angle around z");
    CHECK_UNIFORM(&places);
    given("the centres of 200,000 triangles: z/r and the angle around z");
    CHECK_UNIFORM(&heights);
    given("the normals of 200,000 triangles: z and the angle around it");
    CHECK_UNIFORM(&directions);
    mesh_free(&m);
}

static void cloud_sizes(void) {
    for (long n = 1; n <= 100000; n *= 10) {
        mesh m = shape_cloud(n);
        const double side = sqrt(3.0) / (1 + sqrt((double)n));
        given("shape_cloud(%ld): each side √3 / (1 + √n)", n);
        for (int i = 0; i < m.count && i < 1000; i++) {
            const triangle T = mesh_triangle(&m, i);
            const allowance rounded = absolute_of(2 * REAL_EPSILON, "corners are rounded");
            CHECK_REAL(wide_length(sub(T.p2, T.p1)), side, rounded);
            CHECK_REAL(wide_length(sub(T.p3, T.p2)), side, rounded);
            CHECK_REAL(wide_length(sub(T.p1, T.p3)), side, rounded);
        }
        mesh_free(&m);
    }
}

// ---- seen ---------------------------------------------------------------------------------

static ray view_ray(const shape *s, rng *g) {
    enum { WIDTH = 400, HEIGHT = 300 };
    const real half = (real)tan(20 * PI / 180) * length(sub(s->target, s->eye));
    const camera cam = camera_across(s->eye, s->target, half, WIDTH, HEIGHT);
    const real x = (real)between(g, 0, WIDTH), y = (real)between(g, 0, HEIGHT);
    return camera_ray(&cam, x, y);
}

typedef struct {
    int rays, hits, from_behind;
} view_tally;

static view_tally look(const shape *s, const mesh *m, rng *g) {
    view_tally v = {100, 0, 0};
    for (int i = 0; i < v.rays; i++) {
        const ray r = view_ray(s, g);
        int index;
        const triangle_point q = mesh_hit(m, r, 0, NO_HIT, &index);
        if (q.t == NO_HIT) continue;
        v.hits++;
        v.from_behind += !triangle_surface(mesh_triangle(m, index), r, q).front;
    }
    return v;
}

static void shape_views(void) {
    rng g = check_rng(1204);
    for (const shape *s = shapes; s->name; s++) {
        mesh m = shape_made(s, 10000);
        const view_tally v = look(s, &m, &g);
        const bool from_inside = same_shape(s, shape_cave) || same_shape(s, shape_stadium);
        const bool cloud = same_shape(s, shape_cloud);
        given("shape_%s(10000): %d of %d rays hit, %d from behind", s->name, v.hits, v.rays,
              v.from_behind);
        CHECK(v.hits >= (cloud ? v.rays / 40 : v.rays / 5), "the picture shows it");
        CHECK(v.hits == v.rays || !from_inside, "from inside it is all that is seen");
        CHECK(v.from_behind <= v.rays / 50 || cloud,
              "seen from where its triangles are counter-clockwise, but for edges of a coarse "
              "mesh");
        mesh_free(&m);
    }
}

static int times_through(const mesh *m, ray r) {
    int times = 0;
    for (int i = 0; i < m->count; i++)
        times += triangle_hit(mesh_triangle(m, i), r, 0, NO_HIT).t != NO_HIT;
    return times;
}

static void cave_hides_itself(void) {
    rng g = check_rng(1205);
    const shape *cave = shapes;
    while (!same_shape(cave, shape_cave)) cave++;
    mesh m = shape_made(cave, 30000);
    const vec3 eyes[] = {{0, 0, 0}, cave->eye};
    enum { RAYS = 100 };
    for (int e = 0; e < COUNT(eyes); e++) {
        int hidden = 0, even = 0;
        for (int i = 0; i < RAYS; i++) {
            const int times = times_through(&m, (ray){eyes[e], generic_unit(&g)});
            hidden += times > 1;
            even += times % 2 == 0; // an edge or corner counts twice: once in 1e5 rays
        }
        given("30,000 triangles, seen from " VEC ": %d of %d rays meet more walls",
              ARG(eyes[e]), hidden, RAYS);
        CHECK_AT_MOST(even, 1,
                      "the eye is inside: a ray leaves as often as it enters, and once");
        CHECK_AT_MOST(RAYS / 10, hidden,
                      "ridges hide what is behind them: in a tenth at least");
    }
    mesh_free(&m);
}

// -------------------------------------------------------------------------------------------

#define SHAPES_HINT "Given code: did it change?"
#define SHAPE_TESTS                                                                       \
    {"shapes: the nearest number of triangles", shape_counts, SHAPES_HINT},               \
        {"shapes: about as many as are wanted", shape_counts_near, SHAPES_HINT},          \
        {"shapes: finite, with area, in the ball", shape_sound, SHAPES_HINT},             \
        {"shapes: made twice, the same bits", shape_repeats, SHAPES_HINT},                \
        {"shapes: closed, with the handles they should have", shape_closed, SHAPES_HINT}, \
        {"shapes: normals", shape_normals, SHAPES_HINT},                                  \
        {"shapes: the icosphere's volume", icosphere_volume, SHAPES_HINT},                \
        {"shapes: the knot's volume", knot_volume, SHAPES_HINT},                          \
        {"shapes: the sphereflake's levels", flake_levels, SHAPES_HINT},                  \
        {"shapes: the sphereflake's balls touch", flake_touches, SHAPES_HINT},            \
        {"shapes: the sphereflake's volume", flake_volume, SHAPES_HINT},                  \
        {"shapes: the sponge's volume", sponge_volume, SHAPES_HINT},                      \
        {"shapes: the cave's volume", cave_volume, SHAPES_HINT},                          \
        {"shapes: the cave hides itself", cave_hides_itself, SHAPES_HINT},                \
        {"shapes: the stadium's knot and hall", stadium_parts, SHAPES_HINT},              \
        {"shapes: the cloud is uniform", cloud_uniform, SHAPES_HINT},                     \
        {"shapes: the cloud's triangles", cloud_sizes, SHAPES_HINT},                      \
        {"shapes: what a camera sees", shape_views, SHAPES_HINT},                         \
        {"shapes: noise and its slopes", noise_slopes, SHAPES_HINT}, {                    \
        "shapes: noise is 0 at whole numbers", noise_corners, SHAPES_HINT                 \
    }

#endif
