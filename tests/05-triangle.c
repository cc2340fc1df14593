// Tests of 05-triangle: the exercises, the mesh, and that a traced picture covers
// the pixels of the rasterised one.
#include <stdio.h>

#include "chapters/05-triangle/triangle.h"
#include "common/exact3.h"
#include "common/wide3.h"
#include "tests/check.h"

typedef triangle_point (*hit_function)(triangle T, ray r, real t_min, real t_max);

static const bool in_float = sizeof(real) == sizeof(float);

static const char *const one_rounding = "double inside, one rounding out";

// Mixed arithmetic reaches 6e-8, half a step of float. With double data the rounding
// of the differences is magnified by `condition`.
static allowance t_allowance(double condition) {
    return relative_to(in_float ? 6e-8 : 4e-15 * condition, one_rounding);
}

static const char *called(hit_function f, const char *rest) {
    static char words[200];
    const char *name = f == moller_trumbore  ? "moller_trumbore"
                       : f == watertight_hit ? "watertight_hit"
                                             : "triangle_hit";
    snprintf(words, sizeof words, "%s%s", name, rest);
    return words;
}

// One table tests several functions: the message shall name the student's.
#define CHECK_TEST(f, args, part, expected, allowed)                                  \
    check_real(__FILE__, __LINE__, called(f, #args "." #part), (double)(f args).part, \
               (double)(expected), allowed)

// `note` says what is special about them; it begins with a line break, or is "".
static void given_special(triangle T, ray r, const char *note) {
    given("triangle T = " VEC ", " VEC ", " VEC "\nray O = " VEC ", d = " VEC "%s", ARG(T.p1),
          ARG(T.p2), ARG(T.p3), ARG(r.O), ARG(r.d), note);
}

static void given_triangle(triangle T, ray r) {
    given_special(T, r, "");
}

static void check_miss(hit_function triangle_test, triangle T, ray r, real t_min,
                       const char *note) {
    given_special(T, r, note);
    CHECK_TEST(triangle_test, (T, r, t_min, NO_HIT), t, NO_HIT, exactly());
}

// ---- the reference --------------------------------------------------------------

typedef struct {
    bool hit;
    exact t, u, v;
    double margin; // the smallest weight: how far inside, or outside when negative
} truth;

static truth exact_hit(triangle T, ray r) {
    const exact3 d = exact_of(r.d), s = exact_sub(r.O, T.p1);
    const exact3 e1 = exact_sub(T.p2, T.p1), e2 = exact_sub(T.p3, T.p1);
    const exact3 n = exact_cross(e1, e2), c = exact_cross(s, d);
    const exact det = -exact_dot(d, n);
    if (det == 0) return (truth){.hit = false};
    const exact u = exact_dot(e2, c) / det, v = -exact_dot(e1, c) / det, w = 1 - u - v;
    const double margin = fmin(fmin((double)u, (double)v), (double)w);
    return (truth){u >= 0 && v >= 0 && w >= 0, exact_dot(n, s) / det, u, v, margin};
}

// ---- data -------------------------------------------------------------------------

static vec3 at(triangle T, real u, real v) {
    return add(add(scale(1 - u - v, T.p1), scale(u, T.p2)), scale(v, T.p3));
}

typedef struct {
    real size, width, slope, speed; // width over length; slope 0: any; |d|
} shape;

// About half of the rays hit; the others pass outside one of the edges.
static void generic(rng *g, shape s, triangle *T, ray *r) {
    const vec3 p1 = scale(2 * s.size, in_cube(g)), e1 = scale(s.size, in_cube(g));
    const vec3 across = scale(s.width * s.size, in_cube(g));
    *T = (triangle){p1, add(p1, e1), add(p1, add(scale(rng_real(g), e1), across))};
    const real u = (real)1.5 * rng_real(g) - (real)0.25;
    const real v = (real)1.5 * rng_real(g) - (real)0.25;
    vec3 d = normalize(in_cube(g));
    if (s.slope > 0) {
        const vec3 n = normalize(triangle_normal(*T));
        d = add(normalize(sub(d, scale(dot(d, n), n))), scale(s.slope, n));
    }
    r->O = sub(at(*T, u, v), scale(3 * s.size, d));
    r->d = scale(s.speed, normalize(sub(at(*T, u, v), r->O)));
}

static const shape usual = {1, 1, 0, 1};

// ---- point_in_triangle ---------------------------------------------------------------

// Corners (1, 0, 2), (5, 2, 2), (1, 4, 6); p = p1 + u e1 + v e2 with halves and quarters.
static const triangle by_hand = {{1, 0, 2}, {5, 2, 2}, {1, 4, 6}};

// A second one, exact too, with no edge along an axis.
static const triangle tilted = {{-3, 5, 1}, {2, -6, 8}, {7, 4, -5}};

static void given_point(triangle T, vec3 p, real u, real v) {
    given("T = " VEC ", " VEC ", " VEC "; p = " VEC " = %.3g p1 + %.3g p2 + %.3g p3", ARG(T.p1),
          ARG(T.p2), ARG(T.p3), ARG(p), (double)(1 - u - v), (double)u, (double)v);
}

static void check_inside(triangle T, real u, real v, bool expected) {
    const vec3 p = at(T, u, v), n = triangle_normal(T);
    given_point(T, p, u, v);
    CHECK_BOOL(point_in_triangle(p, T, n), expected);
}

static void inside_worked_out(void) {
    check_inside(by_hand, 0.25f, 0.25f, true);
    check_inside(by_hand, 0.5f, 0.375f, true);
    check_inside(by_hand, -0.25f, 0.5f, false);
    check_inside(by_hand, 0.5f, -0.25f, false);
    check_inside(by_hand, 0.75f, 0.5f, false);
    check_inside(by_hand, -0.25f, -0.25f, false);
    check_inside(by_hand, 1.5f, -0.25f, false);
    check_inside(by_hand, -0.25f, 1.5f, false);
}

// On each edge and corner, and a little outside of it.
static void inside_border(void) {
    const real uv[][2] = {{0, 0}, {1, 0}, {0, 1}, {0.5f, 0}, {0, 0.25f}, {0.5f, 0.5f}};
    const real outside[][2] = {{-0.125f, -0.125f}, {1.25f, -0.125f}, {-0.125f, 1.25f},
                               {0.5f, -0.125f},    {-0.125f, 0.25f}, {0.625f, 0.5f}};
    for (int i = 0; i < COUNT(uv); i++) {
        check_inside(by_hand, uv[i][0], uv[i][1], true);
        check_inside(tilted, uv[i][0], uv[i][1], true);
        check_inside(by_hand, outside[i][0], outside[i][1], false);
        check_inside(tilted, outside[i][0], outside[i][1], false);
    }
}

// On the line of an edge and beyond a corner, where one cross product is 0.
static void inside_beyond(void) {
    const real uv[][2] = {{1.5f, 0},   {-0.5f, 0},    {0, 1.25f},
                          {0, -0.25f}, {1.5f, -0.5f}, {-0.25f, 1.25f}};
    for (int i = 0; i < COUNT(uv); i++) {
        check_inside(by_hand, uv[i][0], uv[i][1], false);
        check_inside(tilted, uv[i][0], uv[i][1], false);
    }
}

// Rounding moves p by about 1e-7: decisions are asked for 1e-3 away from the edges.
static void inside_generic(void) {
    rng g = rng_seed(5, 1);
    for (int i = 0; i < 6000; i++) {
        const real size = (real)pow(10, i % 13 - 6);
        const triangle T = {scale(size, in_cube(&g)), scale(size, in_cube(&g)),
                            scale(size, in_cube(&g))};
        const real u = 2 * rng_real(&g) - (real)0.5, v = 2 * rng_real(&g) - (real)0.5;
        const real nearest = fmin(fmin(u, v), 1 - u - v);
        const vec3 n = triangle_normal(T), p = at(T, u, v);
        if (fabs(nearest) < (real)1e-3 || length(n) < (real)1e-2 * size * size) continue;
        given_point(T, p, u, v);
        CHECK_BOOL(point_in_triangle(p, T, n), nearest > 0);
        const triangle turned = {T.p1, T.p3, T.p2};
        given_point(turned, p, v, u);
        CHECK_BOOL(point_in_triangle(p, turned, triangle_normal(turned)), nearest > 0);
    }
}

// Triangles that a test of two coordinates only sees as a line.
static void inside_every_plane(void) {
    const triangle planes[] = {
        {{2, 0, 0}, {2, 4, 1}, {2, 1, 4}},
        {{0, 2, 0}, {4, 2, 1}, {1, 2, 4}},
        {{0, 0, 2}, {4, 1, 2}, {1, 4, 2}},
    };
    for (int i = 0; i < COUNT(planes); i++) {
        const triangle T = planes[i];
        check_inside(T, 0.25f, 0.25f, true);
        check_inside(T, 0.75f, 0.75f, false);
    }
}

// ---- moller_trumbore and watertight_hit -------------------------------------------------

// u = v = 1/4 of by_hand is (2, 1.5, 3); O = that - 2 d.
static void worked_out_t(hit_function triangle_test) {
    const triangle T = by_hand, turned = {T.p1, T.p3, T.p2};
    const ray r = {{0, -0.5f, 7}, {1, 1, -2}};
    given_special(T, r, "\nby hand: n = (8, -16, 16), det = 40, u = v = 10 / 40, t = 80 / 40");
    suspect_value("the distance |t d|: t counts in |d|", 2 * sqrt(6.0));
    suspect_value("t times det: the division is missing", 80);
    suspect_value("minus t: det, or s = O - p1, the wrong way round", -2);
    suspect_value(
        "a miss: det or s = O - p1 the wrong way round, or u and v not divided by det?",
        (double)NO_HIT);
    CHECK_TEST(triangle_test, (T, r, -NO_HIT, NO_HIT), t, 2, exactly());
    given_special(turned, r,
                  "\nby hand: the back; det = -40, u = v = -10 / -40, t = -80 / -40");
    suspect_value("a miss: both sides are hit, and det < 0 is the back", (double)NO_HIT);
    CHECK_TEST(triangle_test, (turned, r, 0, NO_HIT), t, 2, exactly());
}

static void worked_out(hit_function triangle_test) {
    worked_out_t(triangle_test);
    const triangle T = by_hand;
    const ray r = {{1, -0.5f, 7}, {1, 1, -2}}; // meets the plane at (3.2, 1.7, 2.6)
    const char *second = "\nby hand: det = 40, u = 22 / 40, v = 6 / 40, t = 88 / 40";
    const truth want = exact_hit(T, r);
    given_special(T, r, second);
    suspect_value("v: are u and v exchanged?", (double)want.v);
    suspect_value("the weight of p1: u belongs to p2", (double)(1 - want.u - want.v));
    suspect_value("u times det: the division is missing", (double)want.u * 40);
    CHECK_TEST(triangle_test, (T, r, 0, NO_HIT), u, want.u, roundings(2, "double inside"));
    given_special(T, r, second);
    suspect_value("u: are u and v exchanged?", (double)want.u);
    suspect_value("the weight of p1: v belongs to p3", (double)(1 - want.u - want.v));
    suspect_value("v times det: the division is missing", (double)want.v * 40);
    CHECK_TEST(triangle_test, (T, r, 0, NO_HIT), v, want.v, roundings(2, "double inside"));
}

static void check_truth(hit_function triangle_test, triangle T, ray r, double condition) {
    const truth want = exact_hit(T, r);
    if (want.t < 0 || fabs(want.margin) < (in_float ? 1e-11 : 1e-14 * condition)) return;
    given_triangle(T, r);
    if (!want.hit)
        suspect_value("a point outside: which of u, v, u + v is beyond its limits?",
                      (double)want.t);
    if (want.hit && fabs(length(r.d) - 1) > (real)0.01)
        suspect_value("the distance |t d|: t counts in |d|", (double)want.t * length(r.d));
    CHECK_TEST(triangle_test, (T, r, 0, NO_HIT), t, want.hit ? (double)want.t : (double)NO_HIT,
               t_allowance(condition));
    if (!want.hit) return;
    const allowance weight = absolute_of((in_float ? 1e-7 : 1e-14 * condition),
                                         "double inside, rounded; weights are at most 1");
    suspect_value("u and v exchanged?", (double)want.v);
    suspect_value("the weight of p1: u is that of p2", (double)(1 - want.u - want.v));
    CHECK_TEST(triangle_test, (T, r, 0, NO_HIT), u, want.u, weight);
    CHECK_TEST(triangle_test, (T, r, 0, NO_HIT), v, want.v, weight);
}

static void generic_rays(hit_function triangle_test) {
    rng g = rng_seed(5, 2);
    for (int i = 0; i < 20000; i++) {
        triangle T;
        ray r;
        generic(&g, usual, &T, &r);
        check_truth(triangle_test, T, r, 1e3);
    }
}

static void reproduces(hit_function triangle_test) {
    rng g = rng_seed(5, 3);
    for (int i = 0; i < 5000; i++) {
        triangle T;
        ray r;
        generic(&g, usual, &T, &r);
        const triangle_point q = triangle_test(T, r, 0, NO_HIT);
        if (q.t == NO_HIT) continue;
        given_triangle(T, r);
        CHECK_VEC3(at(T, q.u, q.v), ray_at(r, q.t),
                   absolute_of(in_float ? 40 * REAL_EPSILON : 1e-11,
                               "points within 8 of 0; double has no digits to spare"));
    }
}

static void interval(hit_function triangle_test) {
    const ray r = {{0, -0.5f, 7}, {1, 1, -2}};
    given_triangle(by_hand, r); // at t = 2
    CHECK_TEST(triangle_test, (by_hand, r, 1, 3), t, 2, exactly());
    CHECK_TEST(triangle_test, (by_hand, r, 2, 3), t, NO_HIT, exactly());
    CHECK_TEST(triangle_test, (by_hand, r, 0, 2), t, NO_HIT, exactly());
    CHECK_TEST(triangle_test, (by_hand, r, 2.5f, 3), t, NO_HIT, exactly());
    const triangle wide = {{-8, -8, -4}, {24, -8, -4}, {-8, 24, -4}};
    const ray near = {{1, 2, (real)(REAL_EPSILON / 16)}, {0, 0, -1}};
    given_triangle(wide, near);
    suspect_value("t compared before it was rounded to real: it comes back as t_min", 4);
    CHECK_TEST(triangle_test, (wide, near, 4, 5), t, NO_HIT, exactly());
    const ray nearer = {{1, 2, (real)(-REAL_EPSILON / 16)}, {0, 0, -1}};
    given_triangle(wide, nearer);
    suspect_value("t compared before it was rounded to real: it comes back as t_max", 4);
    CHECK_TEST(triangle_test, (wide, nearer, 3, 4), t, NO_HIT, exactly());
    const ray behind = {{0, -0.5f, 7}, {-1, -1, 2}};
    given_triangle(by_hand, behind);
    CHECK_TEST(triangle_test, (by_hand, behind, 0, NO_HIT), t, NO_HIT, exactly());
    CHECK_TEST(triangle_test, (by_hand, behind, -NO_HIT, NO_HIT), t, -2, exactly());
}

static void both_sides(hit_function triangle_test) {
    rng g = rng_seed(5, 4);
    for (int i = 0; i < 2000; i++) {
        triangle T;
        ray r;
        generic(&g, usual, &T, &r);
        const triangle turned = {T.p1, T.p3, T.p2};
        const triangle_point q = triangle_test(T, r, 0, NO_HIT);
        if (fabs(exact_hit(T, r).margin) < 1e-9) continue;
        given_special(turned, r, "\nwith p2 and p3 exchanged t stays, and u becomes v");
        CHECK_TEST(triangle_test, (turned, r, 0, NO_HIT), t, q.t,
                   relative_to(in_float ? 1.2e-7 : 4e-12, "one rounding in each"));
        if (q.t == NO_HIT) continue;
        CHECK_TEST(triangle_test, (turned, r, 0, NO_HIT), u, q.v,
                   absolute_of(1e3 * REAL_EPSILON, "rounded weights"));
    }
}

static void sizes(hit_function triangle_test) {
    rng g = rng_seed(5, 5);
    for (int k = -10; k <= 9; k++) {
        for (int i = 0; i < 300; i++) {
            triangle T;
            ray r;
            shape s = usual;
            s.size = (real)pow(10, k);
            generic(&g, s, &T, &r);
            check_truth(triangle_test, T, r, 1e3);
        }
    }
}

static void speeds(hit_function triangle_test) {
    rng g = rng_seed(5, 6);
    for (int k = -30; k <= 30; k += 5) {
        for (int i = 0; i < 300; i++) {
            triangle T;
            ray r;
            shape s = usual;
            s.speed = (real)pow(10, k);
            generic(&g, s, &T, &r);
            check_truth(triangle_test, T, r, 1e3);
        }
    }
}

static void needles(hit_function triangle_test) {
    rng g = rng_seed(5, 7);
    for (int k = -5; k <= -1; k++) {
        for (int i = 0; i < 2000; i++) {
            triangle T;
            ray r;
            shape s = usual;
            s.width = (real)pow(10, k);
            generic(&g, s, &T, &r);
            check_truth(triangle_test, T, r, pow(10, 3 - k));
        }
    }
}

static void grazing(hit_function triangle_test) {
    rng g = rng_seed(5, 8);
    for (int k = -5; k <= -1; k++) {
        for (int i = 0; i < 2000; i++) {
            triangle T;
            ray r;
            shape s = usual;
            s.slope = (real)pow(10, k);
            generic(&g, s, &T, &r);
            check_truth(triangle_test, T, r, pow(10, 3 - k));
        }
    }
}

static void far_away(hit_function triangle_test) {
    rng g = rng_seed(5, 9);
    for (int k = 1; k <= 6; k++) {
        for (int i = 0; i < 1000; i++) {
            triangle T;
            ray r;
            generic(&g, usual, &T, &r);
            const vec3 there = scale((real)pow(10, k), in_cube(&g));
            T = (triangle){add(T.p1, there), add(T.p2, there), add(T.p3, there)};
            r.O = add(r.O, there);
            check_truth(triangle_test, T, r, 1e4);
        }
    }
}

static int whole(rng *g, int limit) {
    return (int)(rng_bits(g) % (uint32_t)(2 * limit + 1)) - limit;
}

static vec3 whole_point(rng *g, int limit) {
    const int x = whole(g, limit), y = whole(g, limit), z = whole(g, limit);
    return (vec3){(real)x, (real)y, (real)z};
}

// Corners p, p + j e, p + k e, on one line exactly: whole numbers times a power of 2.
static triangle collinear(rng *g, int kind, real unit) {
    const vec3 p = whole_point(g, 20000), e = whole_point(g, 20000);
    const vec3 a = add(p, scale((real)whole(g, 9), e)), b = add(p, scale((real)whole(g, 9), e));
    const triangle kinds[] = {{p, a, b}, {p, p, a}, {a, p, p}, {p, a, p}, {p, p, p}, {b, p, a}};
    const triangle T = kinds[kind % COUNT(kinds)];
    return (triangle){scale(unit, T.p1), scale(unit, T.p2), scale(unit, T.p3)};
}

static void zero_area(hit_function triangle_test) {
    rng g = rng_seed(5, 10);
    for (int i = 0; i < 60000; i++) {
        const real unit = (real)ldexp(1, (int)(rng_bits(&g) % 61) - 30);
        const triangle T = collinear(&g, i, unit);
        const real s = i % 3 == 0 ? rng_real(&g) : (real)(i % 3 - 1);
        const vec3 d = scale(unit, i % 2 ? whole_point(&g, 20000) : scale(20000, in_cube(&g)));
        const ray r = {sub(lerp(T.p2, T.p3, s), d), d};
        given_triangle(T, r);
        CHECK_TEST(triangle_test, (T, r, 0, NO_HIT), t, NO_HIT, exactly());
    }
}

static void not_crossing(hit_function triangle_test) {
    const triangle T = by_hand;
    const vec3 middle = at(T, 0.25f, 0.25f), along = sub(T.p3, T.p2);
    const vec3 above = add(middle, (vec3){0, 0, 1}), zero = {0, 0, 0};
    const ray inside = {sub(middle, along), along}, edge = {{-3, -2, 2}, {4, 2, 0}};
    const ray parallel = {sub(above, along), along};
    check_miss(triangle_test, T, inside, 0, "\nin the plane of T, through its middle");
    check_miss(triangle_test, T, edge, 0, "\nalong the edge from p1 to p2");
    check_miss(triangle_test, T, parallel, 0, "\nparallel to the plane of T, above it");
    check_miss(triangle_test, T, (ray){middle, zero}, -1, "\nO lies in T");
    check_miss(triangle_test, T, (ray){above, zero}, -1, "\nO lies above T");
}

static void not_a_number(hit_function triangle_test) {
    const real nan = (real)NAN;
    const triangle T = by_hand, bad = {T.p1, {nan, 2, 2}, T.p3};
    const ray good = {{0, -0.5f, 7}, {1, 1, -2}};
    check_miss(triangle_test, T, (ray){{0, nan, 7}, good.d}, 0, "");
    check_miss(triangle_test, T, (ray){good.O, {1, nan, -2}}, 0, "");
    check_miss(triangle_test, T, (ray){good.O, {nan, nan, nan}}, 0, "");
    check_miss(triangle_test, bad, good, 0, "");
}

// Rays along the axes, in each of which two components of d are 0.
static void along_axes(hit_function triangle_test) {
    rng g = rng_seed(5, 22);
    for (int i = 0; i < 600; i++) {
        const triangle T = {in_cube(&g), in_cube(&g), in_cube(&g)};
        const real long_way = i % 2 ? 3 : -3, share = rng_real(&g);
        const vec3 axes[] = {{long_way, 0, 0}, {0, long_way, 0}, {0, 0, long_way}};
        const vec3 d = axes[i % 3];
        check_truth(triangle_test, T, (ray){sub(at(T, share / 2, (real)0.4), d), d}, 1e4);
    }
}

// e1, e2 and n are such that all quotients are exact.
static void exact_border(hit_function triangle_test) {
    const triangle T = {{3, -1, 2}, {11, -1, 2}, {3, 7, 2}};
    const real uv[][2] = {{0, 0},           {1, 0},      {0, 1},
                          {0.5f, 0},        {0, 0.25f},  {0.5f, 0.5f},
                          {0.125f, 0.875f}, {0.875f, 0}, {0.75f, 0.25f}};
    for (int i = 0; i < COUNT(uv); i++) {
        const vec3 p = at(T, uv[i][0], uv[i][1]);
        const vec3 d[] = {{0, 0, -1}, {1, 2, -4}, {-4, 1, 3}, {3, 8, -1}};
        for (int k = 0; k < COUNT(d); k++) {
            const ray r = {sub(p, scale(2, d[k])), d[k]};
            given_triangle(T, r);
            suspect_value("a miss: edges and corners belong to the triangle", (double)NO_HIT);
            CHECK_TEST(triangle_test, (T, r, 0, NO_HIT), t, 2, exactly());
        }
    }
}

#define BOTH(test)                \
    static void mt_##test(void) { \
        test(moller_trumbore);    \
    }                             \
    static void wt_##test(void) { \
        test(watertight_hit);     \
    }
BOTH(worked_out)
BOTH(generic_rays)
BOTH(reproduces)
BOTH(interval)
BOTH(both_sides)
BOTH(sizes)
BOTH(speeds)
BOTH(needles)
BOTH(grazing)
BOTH(far_away)
BOTH(along_axes)
BOTH(zero_area)
BOTH(not_crossing)
BOTH(not_a_number)
BOTH(exact_border)

// Whole coordinates, and a longest component of d that divides without rounding: all
// is exact in double, so that a ray through an edge or corner goes through it exactly.
static void whole_borders(void) {
    rng g = rng_seed(5, 11);
    for (int i = 0; i < 30000; i++) {
        const triangle T = {scale(8, whole_point(&g, 100)), scale(8, whole_point(&g, 100)),
                            scale(8, whole_point(&g, 100))};
        const real s = (real)(rng_bits(&g) % 9) / 8;
        const vec3 p = i % 3 == 0   ? lerp(T.p1, T.p2, s)
                       : i % 3 == 1 ? lerp(T.p2, T.p3, s)
                                    : lerp(T.p3, T.p1, s);
        vec3 d = whole_point(&g, 1000);
        *(i % 7 < 3 ? &d.x : i % 7 < 5 ? &d.y : &d.z) = i % 2 ? 1024 : -1024;
        if (dot(d, triangle_normal(T)) == 0) continue;
        const ray r = {sub(p, d), d};
        given_triangle(T, r);
        suspect_value("a miss: edges and corners belong to the triangle", (double)NO_HIT);
        CHECK_REAL(watertight_hit(T, r, 0, NO_HIT).t, 1, roundings(2, one_rounding));
    }
}

static void orders(void) {
    rng g = rng_seed(5, 12);
    for (int i = 0; i < 20000; i++) {
        triangle T;
        ray r;
        generic(&g, usual, &T, &r);
        if (i % 2) r.d = sub(at(T, rng_real(&g), 0), r.O); // within rounding of an edge
        const triangle_point q = watertight_hit(T, r, 0, NO_HIT);
        const triangle others[] = {{T.p2, T.p3, T.p1},
                                   {T.p3, T.p1, T.p2},
                                   {T.p1, T.p3, T.p2},
                                   {T.p3, T.p2, T.p1},
                                   {T.p2, T.p1, T.p3}};
        const real u[] = {q.v, 1 - q.u - q.v, q.v, q.u, 1 - q.u - q.v};
        for (int k = 0; k < COUNT(others); k++) {
            given_triangle(others[k], r);
            const triangle_point other = watertight_hit(others[k], r, 0, NO_HIT);
            CHECK_BOOL(other.t == NO_HIT, q.t == NO_HIT);
            if (q.t == NO_HIT) continue;
            CHECK_REAL(other.t, q.t,
                       relative_to(in_float ? 1.2e-7 : 4e-12, "one rounding in each"));
            CHECK_REAL(other.u, u[k], absolute_of(8 * REAL_EPSILON, "rounded weights"));
        }
    }
}

// ---- leaks -----------------------------------------------------------------------------

enum { AROUND = 12, ACROSS = 8, POINTS = AROUND * ACROSS };

typedef struct {
    mesh m;
    int ring[POINTS][6]; // the triangles at a corner
    vec3 middle[AROUND]; // of each slice of the tube
} closed_mesh;

static closed_mesh closed_torus(void) {
    closed_mesh c = {
        .m = mesh_torus((vec3){0, 0, 0}, (vec3){0.3f, 1, 0.5f}, 2, 1, AROUND, ACROSS)};
    int count[POINTS] = {0};
    for (int i = 0; i < c.m.count; i++) {
        for (int k = 0; k < 3; k++) {
            const int corner = c.m.corners[i][k];
            c.ring[corner][count[corner]++] = i;
        }
    }
    for (int i = 0; i < POINTS; i++) {
        vec3 *middle = &c.middle[i / ACROSS];
        *middle = add(*middle, scale((real)1 / ACROSS, c.m.points[i]));
    }
    return c;
}

static bool leaks(const closed_mesh *c, hit_function triangle_test, int corner, ray r) {
    for (int k = 0; k < 6; k++)
        if (triangle_test(mesh_triangle(&c->m, c->ring[corner][k]), r, 0, NO_HIT).t != NO_HIT)
            return false;
    for (int i = 0; i < c->m.count; i++)
        if (triangle_test(mesh_triangle(&c->m, i), r, 0, NO_HIT).t != NO_HIT) return false;
    return true;
}

// Rays from inside the tube, which is closed: none may get out. They are aimed at points
// of edges, or at corners; the eye has few bits, so that many d are exact; every other
// d is a unit vector.
static long count_leaks(hit_function triangle_test, bool at_corner, long rays) {
    const closed_mesh c = closed_torus();
    rng g = rng_seed(5, 13);
    long count = 0;
    for (long i = 0; i < rays; i++) {
        const int *k = c.m.corners[rng_bits(&g) % (uint32_t)c.m.count];
        const vec3 eye = add(c.middle[k[0] / ACROSS], scale((real)0.2, in_cube(&g)));
        const vec3 O = {rint(64 * eye.x) / 64, rint(64 * eye.y) / 64, rint(64 * eye.z) / 64};
        const vec3 other = c.m.points[k[1 + rng_bits(&g) % 2]];
        const real s = at_corner ? 0 : rng_real(&g);
        const vec3 d = sub(lerp(c.m.points[k[0]], other, s), O);
        const ray r = {O, i % 2 ? normalize(d) : d};
        if (leaks(&c, triangle_test, k[0], r) && count++ == 0)
            given_triangle(mesh_triangle(&c.m, c.ring[k[0]][0]), r);
    }
    mesh_free((mesh *)&c.m);
    return count;
}

static void mt_edges(void) {
    const long rays = 1000000;
    const long leaked = count_leaks(moller_trumbore, false, rays);
    CHECK_AT_MOST(leaked, in_float ? 0 : rays / 10,
                  "of 1000000 rays at edges; double can only hold the edges of float data");
}

static void wt_edges(void) {
    const long leaked = count_leaks(watertight_hit, false, 6000000);
    CHECK_INT(leaked, 0);
}

static void wt_corners(void) {
    const long leaked = count_leaks(watertight_hit, true, 3000000);
    CHECK_INT(leaked, 0);
}

// ---- triangle_hit follows what is done to the scene ---------------------------------------

static vec3 rotated(const vec3 axes[3], vec3 p) {
    return (vec3){dot(axes[0], p), dot(axes[1], p), dot(axes[2], p)};
}

// The rotated data are rounded, so t moves by roundings times how grazing the ray is.
static void moved(void) {
    rng g = rng_seed(5, 14);
    for (int i = 0; i < 3000; i++) {
        triangle T;
        ray r;
        generic(&g, usual, &T, &r);
        const truth want = exact_hit(T, r);
        const vec3 n = triangle_normal(T);
        const double slope = fabs((double)(dot(n, r.d) / (length(n) * length(r.d))));
        if (fabs(want.margin) < 1e-2 || slope < 0.1 || length(n) < (real)0.05) continue;
        const vec3 forward = normalize(in_cube(&g)), right = camera_right(forward, in_cube(&g));
        const vec3 axes[] = {right, cross(right, forward), forward};
        const vec3 there = scale(10, in_cube(&g));
        const triangle M = {add(rotated(axes, T.p1), there), add(rotated(axes, T.p2), there),
                            add(rotated(axes, T.p3), there)};
        const ray s = {add(rotated(axes, r.O), there), rotated(axes, r.d)};
        given_special(M, s, "\nboth were rotated and moved: t must stay");
        CHECK_REAL(triangle_hit(M, s, 0, NO_HIT).t, want.hit ? (double)want.t : (double)NO_HIT,
                   absolute_of(4e3 * REAL_EPSILON, "the moved coordinates are rounded"));
    }
}

static void scaled(void) {
    rng g = rng_seed(5, 15);
    for (int i = 0; i < 6000; i++) {
        triangle T;
        ray r;
        generic(&g, usual, &T, &r);
        const triangle_point q = triangle_hit(T, r, 0, NO_HIT);
        const real k = (real)ldexp(1, (int)(rng_bits(&g) % 81) - 40);
        const triangle M = {scale(k, T.p1), scale(k, T.p2), scale(k, T.p3)};
        const ray m = {scale(k, r.O), scale(k, r.d)}, faster = {r.O, scale(k, r.d)};
        given_special(M, m, "\nall multiplied by a power of 2: t must stay, to the last bit");
        CHECK_REAL(triangle_hit(M, m, 0, NO_HIT).t, q.t, exactly());
        given_special(T, faster,
                      "\nd multiplied by a power of 2, and so t must be divided by it");
        CHECK_REAL(triangle_hit(T, faster, 0, NO_HIT).t, q.t / k, exactly());
    }
}

// ---- triangle_surface -----------------------------------------------------------------

static void surface(void) {
    rng g = rng_seed(5, 16);
    for (int i = 0; i < 8000; i++) {
        triangle T;
        ray r;
        shape s = usual;
        s.size = (real)pow(10, i % 20 - 10);
        generic(&g, s, &T, &r);
        const triangle_point q = triangle_hit(T, r, 0, NO_HIT);
        if (q.t == NO_HIT) continue;
        const hit h = triangle_surface(T, r, q);
        given_triangle(T, r);
        CHECK_REAL(length(h.n), 1, roundings(8, "a unit vector in real"));
        const exact3 n = exact_cross(exact_sub(T.p2, T.p1), exact_sub(T.p3, T.p1));
        const exact off = exact_dot(exact_sub(h.p, T.p1), n) / exact_sqrt(exact_dot(n, n));
        CHECK_AT_MOST(fabs((double)off), dot(h.error, absolute(h.n)) * (real)1.0001,
                      "hit.error bounds the distance from the plane");
        CHECK_BOOL(h.front, exact_dot(exact_of(r.d), n) < 0);
    }
}

// ---- mesh -------------------------------------------------------------------------------

static void mesh_nearest(void) {
    mesh m = mesh_torus((vec3){1, -2, 3}, (vec3){1, 3, -2}, 2, 0.75f, 17, 11);
    rng g = rng_seed(5, 17);
    int hits = 0;
    for (int i = 0; i < 4000; i++) {
        const vec3 O = scale(6, in_cube(&g));
        const ray r = {O, sub(add((vec3){1, -2, 3}, scale(3, in_cube(&g))), O)};
        real nearest = NO_HIT;
        int first = -1, index = -1;
        for (int k = 0; k < m.count; k++) {
            const real t = triangle_hit(mesh_triangle(&m, k), r, 0, NO_HIT).t;
            if (!(t < nearest)) continue;
            nearest = t;
            first = k;
        }
        given("a torus of %d triangles, ray O = " VEC ", d = " VEC, m.count, ARG(r.O),
              ARG(r.d));
        CHECK_REAL(mesh_hit(&m, r, 0, NO_HIT, &index).t, nearest, exactly());
        CHECK_INT(index, first);
        hits += first >= 0;
    }
    CHECK(hits > 1000 && hits < 3500, "the test itself: rays hit and miss");
    mesh_free(&m);
}

// Closed: every edge is in two triangles, once in each direction. Normals outward.
// What misses the sphere around a mesh is not asked for: it must hold every point, also
// far from the origin, where points are coarse.
static void torus_around(void) {
    rng g = rng_seed(5, 77);
    for (int i = 0; i < 200; i++) {
        const vec3 centre = scale((real)pow(10, i % 9 - 2), in_cube(&g));
        mesh m = mesh_torus(centre, in_cube(&g), 2, (real)0.75, 9, 7);
        double farthest = 0;
        for (int k = 0; k < 9 * 7; k++) {
            const wide3 v = wide_sub(m.points[k], m.around.c);
            farthest = fmax(farthest, sqrt(wide_dot(v, v)));
        }
        given("a torus 2.75 large at " VEC, ARG(centre));
        CHECK_AT_MOST(farthest, m.around.r, "the sphere around the mesh");
        mesh_free(&m);
    }
}

static void torus_closed(void) {
    enum { R = 5, S = 4, N = R * S };
    mesh m = mesh_torus((vec3){1, -2, 3}, (vec3){1, 3, -2}, 2, 0.75f, R, S);
    int uses[N][N] = {{0}};
    for (int i = 0; i < m.count; i++)
        for (int k = 0; k < 3; k++) uses[m.corners[i][k]][m.corners[i][(k + 1) % 3]]++;
    given("a torus of 5 x 4 points");
    CHECK_INT(m.count, 2 * N);
    for (int a = 0; a < N; a++)
        for (int b = 0; b < N; b++) {
            CHECK(uses[a][b] <= 1 && uses[a][b] == uses[b][a],
                  "each edge is shared by two triangles, once in each direction");
        }
    for (int i = 0; i < m.count; i++) {
        const vec3 n = triangle_normal(mesh_triangle(&m, i));
        CHECK(dot(n, m.normals[m.corners[i][0]]) > 0, "triangles face outwards");
    }
    mesh_free(&m);
}

// The slide's method agrees where it is not a matter of rounding.
static void slide(void) {
    rng g = rng_seed(5, 18);
    for (int i = 0; i < 5000; i++) {
        triangle T;
        ray r;
        generic(&g, usual, &T, &r);
        const vec3 n = triangle_normal(T);
        const truth want = exact_hit(T, r);
        if (want.t < 0 || fabs(want.margin) < 1e-2 || length(n) < (real)0.05) continue;
        if (fabs(dot(n, r.d)) < (real)0.05 * length(n)) continue;
        given_triangle(T, r);
        const triangle_point q = triangle_hit_slide(T, r, 0, NO_HIT);
        CHECK_REAL(
            q.t, want.hit ? (double)want.t : (double)NO_HIT,
            relative_to(1e3 * REAL_EPSILON, "a rounded normal, met at 3 degrees or more"));
        if (!want.hit) continue;
        CHECK_REAL(q.u, want.u, absolute_of(4e3 * REAL_EPSILON, "real arithmetic"));
        CHECK_REAL(q.v, want.v, absolute_of(4e3 * REAL_EPSILON, "real arithmetic"));
    }
}

// ---- smooth_normal ------------------------------------------------------------------------

static void smooth_corners(void) {
    const vec3 n1 = normalize((vec3){3, 0, 4}), n2 = normalize((vec3){0, 4, 3});
    const vec3 n3 = normalize((vec3){-12, 15, 16});
    const allowance a = roundings(8, "normalised in real");
    given("n1 = (0.6, 0, 0.8), n2 = (0, 0.8, 0.6), n3 = (-0.48, 0.6, 0.64); u = v = 0 is p1");
    suspect_vec3("the normal of p2", n2);
    suspect_vec3("the normal of p3", n3);
    CHECK_VEC3(smooth_normal(n1, n2, n3, 0, 0), n1, a);
    given("the same at u = 1, v = 0: p2");
    suspect_vec3("the normal of p3: are u and v exchanged?", n3);
    suspect_vec3("the normal of p1: u is the weight of p2", n1);
    CHECK_VEC3(smooth_normal(n1, n2, n3, 1, 0), n2, a);
    given("the same at u = 0, v = 1: p3");
    suspect_vec3("the normal of p2: are u and v exchanged?", n2);
    CHECK_VEC3(smooth_normal(n1, n2, n3, 0, 1), n3, a);
}

static void smooth_generic(void) {
    rng g = rng_seed(5, 19);
    for (int i = 0; i < 5000; i++) {
        const vec3 n1 = normalize(in_cube(&g)), n2 = normalize(in_cube(&g));
        const vec3 n3 = normalize(in_cube(&g));
        const real root = sqrt(rng_real(&g)), share = rng_real(&g);
        const real u = root * (1 - share), v = root * share;
        wide3 sum = wide_along((wide3){0, 0, 0}, 1.0 - u - v, widen(n1));
        sum = wide_along(wide_along(sum, u, widen(n2)), v, widen(n3));
        const double size = sqrt(wide_dot(sum, sum));
        if (size < 1e-2) continue; // nearly cancels
        const vec3 want = narrow((wide3){sum.x / size, sum.y / size, sum.z / size});
        given("n1 = " VEC ", n2 = " VEC ", n3 = " VEC ", u = %.9g, v = %.9g", ARG(n1), ARG(n2),
              ARG(n3), (double)u, (double)v);
        suspect_vec3("u and v exchanged",
                     normalize(add(add(scale(1 - u - v, n1), scale(v, n2)), scale(u, n3))));
        suspect_vec3("the weighted mean, not of unit length", narrow(sum));
        CHECK_VEC3(smooth_normal(n1, n2, n3, u, v), want,
                   roundings(8 / size, "a sum and a division in real"));
    }
}

static void smooth_cancels(void) {
    const vec3 n1 = normalize((vec3){3, 0, 4}), n2 = neg(n1), n3 = {0, 1, 0};
    given("n1 = (0.6, 0, 0.8), n2 = -n1, u = 1/2, v = 0: the mean is (0, 0, 0)");
    CHECK_VEC3(smooth_normal(n1, n2, n3, 0.5f, 0), n1, roundings(8, "n1 itself"));
}

// ---- the same pixels as 01
// -------------------------------------------------------------------

enum { WIDTH = 64, HEIGHT = 48 };

static camera looking_down_z(int width, int height) {
    return camera_look_at((vec3){0, 0, 0}, (vec3){0, 0, -1}, (vec3){0, 1, 0}, DEMO_FOV, width,
                          height);
}

// The triangle seen at the centre of pixel (x, y), or -1; t as well.
static int seen(const painted *list, int count, const camera *cam, int x, int y, real *t) {
    const ray r = camera_ray(cam, x + (real)0.5, y + (real)0.5);
    int nearest = -1;
    *t = NO_HIT;
    for (int i = 0; i < count; i++) {
        const triangle_point q = triangle_hit(list[i].t, r, 0, *t);
        if (q.t == NO_HIT) continue;
        *t = q.t;
        nearest = i;
    }
    return nearest;
}

static void check_pixel(const painted *list, int i, double t_depth, double depth,
                        color raster) {
    CHECK_BOOL(i >= 0, depth < INFINITY);
    if (i < 0) return;
    CHECK_REAL(t_depth, depth, relative_to(in_float ? 3e-7 : 1e-11, "t and focal are rounded"));
    CHECK_VEC3(list[i].paint, raster, exactly());
}

// Both pictures of the same triangles, pixel by pixel. z-buffer and t might choose
// differently where two triangles are equally far to rounding: these tests have no
// such pixel.
static void compare(const painted *list, int count, int width, int height, const char *what) {
    const camera cam = looking_down_z(width, height);
    framebuffer fb = framebuffer_new(width, height, (color){-1, -1, -1});
    for (int i = 0; i < count; i++)
        rasterize(&fb, (projection){width, height, focal_length(height, DEMO_FOV)}, list[i]);
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            real t;
            const int i = seen(list, count, &cam, x, y, &t);
            const double depth = fb.depth[y * width + x],
                         t_depth = (double)t * (double)cam.focal;
            if (i < 0 && depth == INFINITY) continue;
            given("%s, pixel (%d, %d): rasterised depth %.9g, traced %.9g", what, x, y, depth,
                  t_depth);
            check_pixel(list, i, t_depth, depth, *image_at(&fb.img, x, y));
        }
    }
    framebuffer_free(&fb);
}

static void same_demo(void) {
    compare(demo_triangles, demo_triangle_count, 320, 200, "the scene of 01");
}

static vec3 before_eye(rng *g) {
    const vec3 p = in_cube(g);
    const real depth = 3 + 2 * p.z; // 1 to 5
    return (vec3){p.x * depth / 2, p.y * depth / 2, -depth};
}

static void same_random(void) {
    rng g = rng_seed(5, 20);
    for (int i = 0; i < 3000; i++) {
        const vec3 a = before_eye(&g), b = before_eye(&g), c = before_eye(&g);
        const painted one = {{a, b, c}, {1, 1, 1}};
        compare(&one, 1, WIDTH, HEIGHT, "one random triangle");
    }
}

// A sheet of 8 x 6 squares, its points moved at random, each square cut in two: all
// inner edges are shared, and larger sheets lie behind smaller ones.
static void same_meshes(void) {
    enum { COLUMNS = 8, ROWS = 6 };
    rng g = rng_seed(5, 21);
    for (int m = 0; m < 40; m++) {
        vec3 p[ROWS + 1][COLUMNS + 1];
        for (int j = 0; j <= ROWS; j++)
            for (int i = 0; i <= COLUMNS; i++) {
                const vec3 jitter = in_cube(&g);
                p[j][i] = (vec3){((real)i - 4 + (real)0.3 * jitter.x) / 3,
                                 ((real)j - 3 + (real)0.3 * jitter.y) / 3, -3 - jitter.z};
            }
        painted list[2 * ROWS * COLUMNS];
        int count = 0;
        for (int j = 0; j < ROWS; j++)
            for (int i = 0; i < COLUMNS; i++) {
                const color c = {(real)count, 1, 0}, d = {(real)count, 0, 1};
                list[count++] = (painted){{p[j][i], p[j][i + 1], p[j + 1][i + 1]}, c};
                list[count++] = (painted){{p[j][i], p[j + 1][i + 1], p[j + 1][i]}, d};
            }
        compare(list, count, WIDTH, HEIGHT, "a sheet of triangles with shared edges");
    }
}

int main(void) {
    static const char *const solve =
        "Put O + t d = p1 + u (p2 - p1) + v (p3 - p1): three equations for t, u, v.";
    static const char *const sides =
        "Walk round the triangle: a point inside is on the same side of all three edges.";
    static const char *const belongs =
        "Edges and corners belong to the triangle: what is the test when a weight is 0?";
    static const char *const orientation =
        "Both sides are hit: is the sign of your determinant or areas taken into account?";
    static const char *const only_zero =
        "Do the generic rays pass? Only a determinant of exactly 0 misses: a threshold "
        "loses small triangles and short d.";
    static const char *const double_inside =
        "Do the generic rays pass? Float products cancel here. Compute in double.";
    static const char *const relative = "Subtract O or p1 first, in double: wide_sub.";
    static const char *const no_area =
        "Corners on one line: is the normal in double exactly 0? triangle_has_area tells.";
    static const char *const no_nan =
        "Write tests so that NaN fails them: !(t > t_min && ...).";
    static const char *const flat = "Parallel to the plane, also inside it: no hit.";
    static const char *const ends = "Both ends of t_min < t < t_max are excluded.";
    static const char *const shared =
        "Two triangles must compute the same number, but for its sign, for a shared edge.";
    static const test tests[] = {
        {"point_in_triangle: worked out by hand", inside_worked_out, sides},
        {"point_in_triangle: generic triangles", inside_generic, sides},
        {"point_in_triangle: edges and corners", inside_border, belongs},
        {"point_in_triangle: beyond the corners", inside_beyond,
         "On the line through an edge its cross product is 0: the other two must decide."},
        {"point_in_triangle: in every plane", inside_every_plane,
         "Do the tests before pass? Then: two coordinates are not enough in every plane."},
        {"moller_trumbore: worked out by hand", mt_worked_out, solve},
        {"moller_trumbore: 20000 generic rays", mt_generic_rays, solve},
        {"moller_trumbore: u and v give the point", mt_reproduces, solve},
        {"moller_trumbore: rays along the axes", mt_along_axes, solve},
        {"moller_trumbore: t_min < t < t_max", mt_interval, ends},
        {"moller_trumbore: both sides are hit", mt_both_sides, orientation},
        {"moller_trumbore: edges and corners", mt_exact_border, belongs},
        {"moller_trumbore: tiny and huge triangles", mt_sizes, only_zero},
        {"moller_trumbore: tiny and huge d", mt_speeds, only_zero},
        {"moller_trumbore: needles", mt_needles, double_inside},
        {"moller_trumbore: grazing rays", mt_grazing, double_inside},
        {"moller_trumbore: far from the origin", mt_far_away, relative},
        {"moller_trumbore: zero area is never hit", mt_zero_area, no_area},
        {"moller_trumbore: parallel rays, d = 0", mt_not_crossing, flat},
        {"moller_trumbore: NaN is no hit", mt_not_a_number, no_nan},
        {"moller_trumbore: 1e6 rays at shared edges", mt_edges, double_inside},
        {"watertight_hit: worked out by hand", wt_worked_out, solve},
        {"watertight_hit: 20000 generic rays", wt_generic_rays,
         "Which areas are the weights of p1, p2, p3? t is the weighted mean of the corners'."},
        {"watertight_hit: u and v give the point", wt_reproduces, solve},
        {"watertight_hit: rays along the axes", wt_along_axes,
         "Components of d may be 0: along which axis is d longest?"},
        {"watertight_hit: t_min < t < t_max", wt_interval, ends},
        {"watertight_hit: both sides are hit", wt_both_sides, orientation},
        {"watertight_hit: edges and corners", wt_exact_border, belongs},
        {"watertight_hit: whole numbers, exactly on the border", whole_borders,
         "Divide late: a quotient is rounded before it is compared."},
        {"watertight_hit: any order of the corners", orders, shared},
        {"watertight_hit: tiny and huge triangles", wt_sizes, only_zero},
        {"watertight_hit: tiny and huge d", wt_speeds, only_zero},
        {"watertight_hit: needles", wt_needles, double_inside},
        {"watertight_hit: grazing rays", wt_grazing, double_inside},
        {"watertight_hit: far from the origin", wt_far_away, relative},
        {"watertight_hit: zero area is never hit", wt_zero_area, no_area},
        {"watertight_hit: parallel rays, d = 0", wt_not_crossing, flat},
        {"watertight_hit: NaN is no hit", wt_not_a_number, no_nan},
        {"watertight_hit: 6e6 rays at shared edges", wt_edges, shared},
        {"watertight_hit: 3e6 rays at shared corners", wt_corners,
         "A corner's place on the screen may depend on the corner and the ray alone."},
        {"triangle_hit: rotated and moved", moved, relative},
        {"triangle_hit: scaled", scaled, only_zero},
        {"triangle_hit: the scene of 01, the same pixels", same_demo, shared},
        {"triangle_hit: 3000 random triangles, the same pixels", same_random, shared},
        {"triangle_hit: sheets with shared edges, the same pixels", same_meshes, shared},
        {"triangle_hit_slide: agrees away from the edges", slide, sides},
        {"triangle_surface: normal and error bound", surface, double_inside},
        {"mesh_hit: the nearest, and its index", mesh_nearest,
         "t_max becomes the nearest t so far."},
        {"mesh_torus: closed, facing outwards", torus_closed, "Count each edge."},
        {"mesh_torus: within the sphere around it", torus_around, "Where are points rounded?"},
        {"smooth_normal: at the corners", smooth_corners, "u belongs to n2, v to n3."},
        {"smooth_normal: generic", smooth_generic,
         "The weighted mean of unit vectors is shorter than 1."},
        {"smooth_normal: normals that cancel", smooth_cancels,
         "What is the direction of (0, 0, 0)?"},
    };
    return run_tests("05-triangle", tests, COUNT(tests));
}
