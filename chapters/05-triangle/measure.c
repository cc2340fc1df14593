// measure.c: ways to meet a triangle: their error, what slips between two of them,
// and their cost. It holds answers to the exercises.
#include "chapters/05-triangle/triangle.h"
#include "common/exact3.h"
#include "common/wide3.h"

enum { CASES = 4096, ROUNDS = 9, COLLINEAR = 50000, LEAK_RAYS = 500000 };

// Where a point lies in the frame of a triangle: (u, v, height) = rows · p - offset.
typedef struct {
    vec3 row[3];
    real offset[3];
} frame;

typedef struct {
    triangle T;
    ray r;
    frame F; // worked out beforehand, for the one variant that uses it
} meeting;

typedef triangle_point (*hit_function)(const meeting *m, real t_min, real t_max);

static const triangle_point miss = {NO_HIT, 0, 0};

static triangle_point accept(real t, real u, real v, real t_min, real t_max) {
    return t > t_min && t < t_max ? (triangle_point){t, u, v} : miss;
}

// ---- the variants ------------------------------------------------------------

static triangle_point plane_and_inside(const meeting *m, real t_min, real t_max) {
    return triangle_hit_slide(m->T, m->r, t_min, t_max);
}

// As published, all in one precision. `smallest`: determinants up to it miss.
static triangle_point published(const meeting *m, real smallest, real t_min, real t_max) {
    const vec3 d = m->r.d, s = sub(m->r.O, m->T.p1);
    const vec3 e1 = sub(m->T.p2, m->T.p1), e2 = sub(m->T.p3, m->T.p1);
    const vec3 p = cross(d, e2);
    const real det = dot(e1, p);
    if (fabs(det) <= smallest) return miss;
    const real u = dot(s, p) / det;
    if (!(u >= 0 && u <= 1)) return miss;
    const vec3 q = cross(s, e1);
    const real v = dot(d, q) / det;
    if (!(v >= 0 && u + v <= 1)) return miss;
    return accept(dot(e2, q) / det, u, v, t_min, t_max);
}

static triangle_point plain(const meeting *m, real t_min, real t_max) {
    return published(m, 0, t_min, t_max);
}

static triangle_point threshold(const meeting *m, real t_min, real t_max) {
    return published(m, (real)1e-6, t_min, t_max);
}

// a b - c d with an error of at most 1.5 ulp: e is what rounding took from c d.
// Source: Jeannerod, Louvet and Muller 2013.
static real difference_of_products(real a, real b, real c, real d) {
    const real cd = c * d, e = fma(-c, d, cd);
    return fma(a, b, -cd) + e;
}

static vec3 kahan_cross(vec3 a, vec3 b) {
    return (vec3){difference_of_products(a.y, b.z, a.z, b.y),
                  difference_of_products(a.z, b.x, a.x, b.z),
                  difference_of_products(a.x, b.y, a.y, b.x)};
}

static triangle_point kahan(const meeting *m, real t_min, real t_max) {
    const vec3 d = m->r.d, s = sub(m->r.O, m->T.p1);
    const vec3 e1 = sub(m->T.p2, m->T.p1), e2 = sub(m->T.p3, m->T.p1);
    const vec3 p = kahan_cross(d, e2), q = kahan_cross(s, e1);
    const real det = dot(e1, p);
    if (det == 0) return miss;
    const real u = dot(s, p) / det, v = dot(d, q) / det;
    if (!(u >= 0 && v >= 0 && u + v <= 1)) return miss;
    return accept(dot(e2, q) / det, u, v, t_min, t_max);
}

static triangle_point mixed(const meeting *m, real t_min, real t_max) {
    return moller_trumbore(m->T, m->r, t_min, t_max);
}

static triangle_point published_wide(const meeting *m, real t_min, real t_max) {
    const wide3 d = widen(m->r.d), s = wide_sub(m->r.O, m->T.p1);
    const wide3 e1 = wide_sub(m->T.p2, m->T.p1), e2 = wide_sub(m->T.p3, m->T.p1);
    const wide3 p = wide_cross(d, e2), q = wide_cross(s, e1);
    const double det = wide_dot(e1, p);
    if (det == 0) return miss;
    const double u = wide_dot(s, p) / det, v = wide_dot(d, q) / det;
    if (!(u >= 0 && v >= 0 && u + v <= 1)) return miss;
    return accept((real)(wide_dot(e2, q) / det), (real)u, (real)v, t_min, t_max);
}

// Baldwin and Weber 2016: ray and triangle in a frame in which the triangle is
// (0, 0), (1, 0), (0, 1) at height 0.
static triangle_point baldwin_weber(const meeting *m, real t_min, real t_max) {
    const frame *F = &m->F;
    const vec3 O = m->r.O, d = m->r.d;
    const real t = (F->offset[2] - dot(F->row[2], O)) / dot(F->row[2], d);
    if (!(t > t_min && t < t_max)) return miss;
    const vec3 p = ray_at(m->r, t);
    const real u = dot(F->row[0], p) - F->offset[0], v = dot(F->row[1], p) - F->offset[1];
    return u >= 0 && v >= 0 && u + v <= 1 ? (triangle_point){t, u, v} : miss;
}

// In double, then rounded. With n = e1 x e2 the rows are e2 x n / n², n x e1 / n²
// and n / n²: their products with e1, e2 and n are 1 and 0.
static frame frame_of(triangle T) {
    const wide3 e1 = wide_sub(T.p2, T.p1), e2 = wide_sub(T.p3, T.p1), n = wide_cross(e1, e2);
    const wide3 rows[] = {wide_cross(e2, n), wide_cross(n, e1), n};
    const double n2 = wide_dot(n, n);
    frame F;
    for (int i = 0; i < 3; i++) {
        F.row[i] = narrow((wide3){rows[i].x / n2, rows[i].y / n2, rows[i].z / n2});
        F.offset[i] = (real)(wide_dot(rows[i], widen(T.p1)) / n2);
    }
    return F;
}

// ---- Woop, Benthin and Wald 2013, in real arithmetic ----------------------------

// The axes renamed in their order, so that `axis` becomes z.
static vec3 turned(vec3 a, int axis) {
    if (axis == 0) return (vec3){a.y, a.z, a.x};
    if (axis == 1) return (vec3){a.z, a.x, a.y};
    return a;
}

static vec3 sheared(vec3 a, vec3 d) {
    return (vec3){a.x - d.x / d.z * a.z, a.y - d.y / d.z * a.z, a.z};
}

typedef real (*edge_area)(vec3 a, vec3 b);

static real edge_plain(vec3 a, vec3 b) {
    return a.x * b.y - a.y * b.x;
}

static real edge_kahan(vec3 a, vec3 b) {
    return difference_of_products(a.x, b.y, a.y, b.x);
}

// What a compiler makes of edge_plain when it may contract: one product is rounded,
// the other is not, so that a, b and b, a disagree.
static real edge_fused(vec3 a, vec3 b) {
    return fma(a.x, b.y, -(a.y * b.x));
}

static real edge_double(vec3 a, vec3 b) {
    return (real)((double)a.x * b.y - (double)a.y * b.x);
}

static inline triangle_point woop(const meeting *m, edge_area edge, real t_min, real t_max) {
    const vec3 O = m->r.O, size = absolute(m->r.d);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const vec3 d = turned(m->r.d, axis);
    const vec3 a = sheared(turned(sub(m->T.p1, O), axis), d);
    const vec3 b = sheared(turned(sub(m->T.p2, O), axis), d);
    const vec3 c = sheared(turned(sub(m->T.p3, O), axis), d);
    real u = edge(c, a), v = edge(a, b), w = edge(b, c);
    if (u == 0 || v == 0 || w == 0)
        u = edge_double(c, a), v = edge_double(a, b), w = edge_double(b, c);
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return miss;
    const real det = u + v + w;
    if (det == 0) return miss;
    return accept((w * a.z + u * b.z + v * c.z) / (det * d.z), u / det, v / det, t_min, t_max);
}

static triangle_point woop_plain(const meeting *m, real t_min, real t_max) {
    return woop(m, edge_plain, t_min, t_max);
}

static triangle_point woop_kahan(const meeting *m, real t_min, real t_max) {
    return woop(m, edge_kahan, t_min, t_max);
}

static triangle_point woop_fused(const meeting *m, real t_min, real t_max) {
    return woop(m, edge_fused, t_min, t_max);
}

static triangle_point watertight(const meeting *m, real t_min, real t_max) {
    return watertight_hit(m->T, m->r, t_min, t_max);
}

// ---- cases ----------------------------------------------------------------------

typedef struct {
    meeting m[CASES];
    exact t[CASES];   // the true t; NO_HIT: a true miss
    hit_function hit; // for the clock
} cases;

static exact reference(triangle T, ray r) {
    const exact3 d = {r.d.x, r.d.y, r.d.z}, s = exact_sub(r.O, T.p1);
    const exact3 e1 = exact_sub(T.p2, T.p1), e2 = exact_sub(T.p3, T.p1);
    const exact3 n = exact_cross(e1, e2), c = exact_cross(s, d);
    const exact det = -exact_dot(d, n);
    if (det == 0) return NO_HIT;
    const exact u = exact_dot(e2, c) / det, v = -exact_dot(e1, c) / det;
    return u >= 0 && v >= 0 && u + v <= 1 ? exact_dot(n, s) / det : (exact)NO_HIT;
}

typedef struct {
    real size;       // of the triangle; the eye is about as far away
    real width;      // over length: 1 is round, 1e-5 a needle
    real slope;      // d·n / |d||n|, about; 0: any
    real offset;     // of everything from the origin
    real speed;      // |d|
    real hits;       // the share of rays that hit
    bool thresholds; // ask the variant with a threshold too
} setting;

static const setting usual = {.size = 1, .width = 1, .speed = 1, .hits = (real)0.9};

// A direction that is nearly in the plane of T, but for `slope`.
static vec3 grazing(triangle T, vec3 d, real slope) {
    const vec3 n = normalize(triangle_normal(T));
    const vec3 along = normalize(sub(d, scale(dot(d, n), n)));
    return add(along, scale(slope, n));
}

// The ray is aimed at a point of T with u, v from -margin on: the margin makes the misses.
static meeting generic(const setting *s, rng *g) {
    const vec3 there = scale(s->offset, (vec3){1, (real)-0.3, (real)0.7});
    const vec3 p1 = add(there, scale(s->size, in_cube(g))), e1 = scale(s->size, in_cube(g));
    const vec3 across = scale(s->width * s->size, in_cube(g));
    const triangle T = {p1, add(p1, e1), add(p1, add(scale(rng_real(g), e1), across))};
    const real root = sqrt(rng_real(g)), share = rng_real(g);
    const real beyond = rng_real(g) < s->hits ? 0 : 1; // past the edge p2 p3
    const real u = root * (1 - share) + beyond, v = root * share + beyond;
    const vec3 target = add(add(scale(1 - u - v, T.p1), scale(u, T.p2)), scale(v, T.p3));
    vec3 d = normalize(in_cube(g));
    if (s->slope > 0) d = grazing(T, d, s->slope);
    const vec3 O = sub(target, scale(3 * s->size, d));
    return (meeting){T, {O, scale(s->speed, normalize(sub(target, O)))}, frame_of(T)};
}

static void fill(cases *c, setting s) {
    rng g = rng_seed(5, 1);
    for (int i = 0; i < CASES; i++) {
        c->m[i] = generic(&s, &g);
        c->t[i] = reference(c->m[i].T, c->m[i].r);
    }
}

// Double has tables of its own where it makes nearly all variants right.
#ifdef REAL_IS_DOUBLE
#define OF_REAL ", double"
#else
#define OF_REAL ""
#endif

// ---- errors and cost -----------------------------------------------------------------

typedef struct {
    const char *name;
    hit_function hit;
    enum { ALWAYS, SIZES, FLOAT } where; // the tables in which it differs from another
} variant;

// The order of the rows; the first is what costs are compared with.
static const variant variants[] = {
    {"plane + inside test", plane_and_inside, ALWAYS},
    {"Möller-Trumbore", plain, ALWAYS},
    {"Möller-Trumbore, |det| < 1e-6 misses", threshold, SIZES},
    {"Möller-Trumbore, Kahan's products", kahan, ALWAYS},
    {"Baldwin-Weber (matrix kept)", baldwin_weber, ALWAYS},
    {"Woop", woop_plain, ALWAYS},
    {"Woop, Kahan's products", woop_kahan, ALWAYS},
    {"Möller-Trumbore, double inside", published_wide, FLOAT},
    {"moller_trumbore: -d.n, double inside", mixed, ALWAYS},
    {"watertight_hit: double inside", watertight, ALWAYS},
};

static bool skipped(variant f, bool sizes) {
    if (f.where == FLOAT) return sizeof(real) == sizeof(double);
    return f.where == SIZES && !sizes;
}

// As in a mesh, each ray meets many triangles, so that what a variant works out from
// the ray alone costs little.
static void share_rays(cases *c) {
    enum { TOGETHER = 16 };
    for (int i = 0; i < CASES; i++) {
        const ray own = c->m[i].r, shared = c->m[i - i % TOGETHER].r;
        const vec3 there = sub(ray_at(shared, 3), ray_at(own, 3));
        const triangle T = c->m[i].T;
        c->m[i].T = (triangle){add(T.p1, there), add(T.p2, there), add(T.p3, there)};
        c->m[i].r = shared;
        c->m[i].F = frame_of(c->m[i].T);
    }
}

// The call through a pointer costs all of them the same.
static void run(void *data) {
    const cases *c = data;
    real sum = 0;
    for (int i = 0; i < CASES; i++) {
        const triangle_point q = c->hit(&c->m[i], 0, NO_HIT);
        sum += q.t < 10 ? q.t : 0;
    }
    keep(sum);
}

static void cost(cases *c, const char *table, const char *x_name, double x) {
    const timed t = {"", run};
    share_rays(c);
    for (int v = 0; v < COUNT(variants); v++) {
        double ns;
        if (skipped(variants[v], false)) continue;
        c->hit = variants[v].hit;
        measure_ns(&t, 1, c, CASES, ROUNDS, &ns);
        csv_row(table, variants[v].name, x_name, x, "", NAN, "ns", ns);
    }
}

// The share of wrong decisions, hit or miss, and the 99th percentile of the error of
// t among the hits that were found.
static void errors(cases *c, setting s, const char *what, const char *x_name, double x) {
    fill(c, s);
    char decisions[64], t_errors[64];
    snprintf(decisions, sizeof decisions, "triangle: decisions, %s" OF_REAL, what);
    snprintf(t_errors, sizeof t_errors, "triangle: t, %s" OF_REAL, what);
    for (int v = 0; v < COUNT(variants); v++) {
        static double error[CASES];
        int wrong = 0, found = 0;
        if (skipped(variants[v], s.thresholds)) continue;
        for (int i = 0; i < CASES; i++) {
            const real t = variants[v].hit(&c->m[i], 0, NO_HIT).t;
            if ((t == NO_HIT) != (c->t[i] == NO_HIT))
                wrong++;
            else if (t != NO_HIT)
                error[found++] = relative_error(t, c->t[i]) * REAL_EPSILON;
        }
        csv_row(decisions, variants[v].name, x_name, x, "share of wrong decisions",
                (double)wrong / CASES, "ns", NAN);
        csv_row(t_errors, variants[v].name, x_name, x, "relative error of t, 99 % below",
                found ? quantile(error, found, 0.99) : NAN, "ns", NAN);
    }
}

// ---- zero area -------------------------------------------------------------------------

static int whole(rng *g, int limit) {
    return (int)(rng_bits(g) % (uint32_t)(2 * limit + 1)) - limit;
}

// Corners p, p + j e, p + k e: on one line, exactly, with whole coordinates.
static triangle collinear(rng *g, int limit) {
    const vec3 p = {(real)whole(g, limit), (real)whole(g, limit), (real)whole(g, limit)};
    const vec3 e = {(real)whole(g, limit), (real)whole(g, limit), (real)whole(g, limit)};
    const real j = (real)whole(g, 7), k = (real)whole(g, 7);
    return (triangle){p, add(p, scale(j, e)), add(p, scale(k, e))};
}

// Rays at a point between the corners: the share that is told it hit.
static void zero_area(int bits) {
    for (int v = 0; v < COUNT(variants); v++) {
        if (skipped(variants[v], false)) continue;
        rng g = rng_seed(5, 2);
        long hits = 0;
        for (int i = 0; i < COLLINEAR; i++) {
            meeting m = {.T = collinear(&g, 1 << bits)};
            const vec3 target = lerp(m.T.p2, m.T.p3, rng_real(&g));
            m.r.d = scale((real)(1 << bits), in_cube(&g));
            m.r.O = sub(target, m.r.d);
            m.F = frame_of(m.T);
            hits += variants[v].hit(&m, 0, NO_HIT).t != NO_HIT;
        }
        csv_row("triangle: zero area" OF_REAL, variants[v].name, "coordinates up to", 1 << bits,
                "share hit", (double)hits / COLLINEAR, "ns", NAN);
    }
}

// ---- leaks ------------------------------------------------------------------------------

enum { AROUND = 12, ACROSS = 8, POINTS = AROUND * ACROSS };

typedef struct {
    mesh m;
    frame frames[2 * POINTS];
    int ring[POINTS][8], ring_count[POINTS]; // the triangles at a corner
    vec3 middle[AROUND];                     // of each slice of the tube
} closed_mesh;

static closed_mesh closed_torus(void) {
    closed_mesh c = {.m = mesh_torus((vec3){0, 0, 0}, (vec3){(real)0.3, 1, (real)0.5}, 2, 1,
                                     AROUND, ACROSS)};
    for (int i = 0; i < c.m.count; i++) {
        c.frames[i] = frame_of(mesh_triangle(&c.m, i));
        for (int k = 0; k < 3; k++) {
            const int corner = c.m.corners[i][k];
            c.ring[corner][c.ring_count[corner]++] = i;
        }
    }
    for (int i = 0; i < POINTS; i++) {
        vec3 *middle = &c.middle[i / ACROSS];
        *middle = add(*middle, scale((real)1 / ACROSS, c.m.points[i]));
    }
    return c;
}

static bool meets(const closed_mesh *c, hit_function f, int i, ray r) {
    const meeting m = {mesh_triangle(&c->m, i), r, c->frames[i]};
    return f(&m, 0, NO_HIT).t != NO_HIT;
}

// What a ray is aimed at, from inside the mesh.
typedef enum {
    EDGE,         // a point of an edge; rounding moves the ray a little off it
    CORNER,       // a corner; the same, since d is made a unit vector
    EXACT_CORNER, // a corner, such that the ray goes through it without rounding
} aim;

// A point inside the tube, near the middle of one slice. With few bits, so that
// the difference to a corner can be exact.
static vec3 eye_inside(const closed_mesh *c, int slice, rng *g) {
    const vec3 p = add(c->middle[slice], scale((real)0.2, in_cube(g)));
    return (vec3){rint(64 * p.x) / 64, rint(64 * p.y) / 64, rint(64 * p.z) / 64};
}

// A ray at the corner or at one of two edges that begin there.
static ray aimed(const closed_mesh *c, const int *corners, aim at, rng *g) {
    const vec3 O = eye_inside(c, corners[0] / ACROSS, g);
    const vec3 other = c->m.points[corners[1 + rng_bits(g) % 2]];
    const real s = at == EDGE ? rng_real(g) : 0;
    const vec3 d = sub(lerp(c->m.points[corners[0]], other, s), O);
    return (ray){O, at == CORNER ? normalize(d) : d};
}

static bool is_exact(ray r, vec3 target) {
    const exact3 d = exact_sub(target, r.O);
    return d.x == r.d.x && d.y == r.d.y && d.z == r.d.z;
}

typedef struct {
    long rays, leaks, doubles;
} tally;

// The eye is inside, so every ray meets some triangle. Those at the corner it is
// aimed near are asked first, the others only when they say no.
static void shoot(const closed_mesh *c, hit_function f, int corner, ray r, tally *t) {
    int count = 0;
    for (int k = 0; k < c->ring_count[corner]; k++) count += meets(c, f, c->ring[corner][k], r);
    t->rays++;
    t->doubles += count > 1;
    for (int i = 0; i < c->m.count && count == 0; i++) count += meets(c, f, i, r);
    t->leaks += count == 0;
}

static tally leaks(const closed_mesh *c, hit_function f, aim at, long rays) {
    rng g = rng_seed(5, 3);
    tally t = {0};
    while (t.rays < rays) {
        const int *corners = c->m.corners[rng_bits(&g) % (uint32_t)c->m.count];
        const ray r = aimed(c, corners, at, &g);
        if (at == EXACT_CORNER && !is_exact(r, c->m.points[corners[0]])) continue;
        shoot(c, f, corners[0], r, &t);
    }
    return t;
}

static void leak_rows(const closed_mesh *c, variant f) {
    const long rays[] = {LEAK_RAYS, LEAK_RAYS / 5, LEAK_RAYS / 5};
    for (aim at = EDGE; at <= EXACT_CORNER; at++) {
        const tally t = leaks(c, f.hit, at, rays[at]);
        const double n = (double)t.rays;
        csv_row("triangle: leaks", f.name, "aim", at, "rays that leak", (double)t.leaks / n,
                "ns", NAN);
        csv_row("triangle: double hits", f.name, "aim", at, "rays that hit twice",
                (double)t.doubles / n, "ns", NAN);
    }
}

static void all_leaks(void) {
    static closed_mesh c;
    c = closed_torus();
    for (int v = 0; v < COUNT(variants); v++)
        if (!skipped(variants[v], false)) leak_rows(&c, variants[v]);
    leak_rows(&c, (variant){"Woop, contracted to fma", woop_fused, ALWAYS});
    mesh_free(&c.m);
}

int main(void) {
    static cases c;
    for (int k = 0; k <= 2; k++) {
        setting s = usual;
        s.hits = (real)0.5 * k;
        fill(&c, s);
        cost(&c, "triangle: cost", "share of rays that hit", 0.5 * k);
    }
    for (int k = 0; k >= -5; k--) {
        setting s = usual;
        s.width = (real)pow(10, k);
        errors(&c, s, "needles", "width / length", pow(10, k));
    }
    for (int k = -1; k >= -5; k--) {
        setting s = usual;
        s.slope = (real)pow(10, k);
        errors(&c, s, "grazing", "d.n / |d||n|", pow(10, k));
    }
    for (int k = -6; k <= 9; k += 3) {
        setting s = usual;
        s.size = (real)pow(10, k);
        s.thresholds = true;
        errors(&c, s, "size", "size", pow(10, k));
    }
    for (int k = -10; k <= 5; k += 5) {
        setting s = usual;
        s.speed = (real)pow(10, k);
        s.thresholds = true;
        errors(&c, s, "length of d", "|d|", pow(10, k));
    }
    for (int k = 0; k <= 6; k += 2) {
        setting s = usual;
        s.offset = (real)pow(10, k);
        errors(&c, s, "far away", "distance from the origin / size", pow(10, k));
    }
    for (int bits = 4; bits <= 20; bits += 8) zero_area(bits);
    all_leaks();
}
