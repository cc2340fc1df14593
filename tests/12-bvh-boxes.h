// 12-bvh-boxes.h: the part of 12-bvh.c about the slab test.
#ifndef TESTS_12_BVH_BOXES_H
#define TESTS_12_BVH_BOXES_H

#include "chapters/12-bvh/aabb.h"
#include "tests/check-generic.h"
#include "tests/check.h"

typedef struct {
    aabb box;
    ray r;
    real t_min, t_max;
} slab_case;

static void given_slabs(const slab_case *c, const char *note) {
    given("box " VEC " to " VEC "\nray O = " VEC ", d = " VEC "\nt_min = %.9g, t_max = %.9g%s",
          ARG(c->box.min), ARG(c->box.max), ARG(c->r.O), ARG(c->r.d), (double)c->t_min,
          (double)c->t_max, note);
}

static bool slabs_met(const slab_case *c, real *enter) {
    const slab_ray s = slab_ray_of(c->r);
    return aabb_hit(&c->box, &s, c->t_min, c->t_max, enter);
}

// ---- the reference --------------------------------------------------------------------

// Where the ray meets the planes of one axis: from / speed and to / speed, as fractions.
typedef struct {
    exact from, to, speed;
} slab;

static slab slab_of(const slab_case *c, int axis) {
    const exact d = along(c->r.d, axis), O = along(c->r.O, axis);
    const exact low = along(c->box.min, axis) - O, high = along(c->box.max, axis) - O;
    return d < 0 ? (slab){-high, -low, -d} : (slab){low, high, d};
}

// Is there a t in all three slabs and in [t_min, t_max], 0 <= t_min? Nothing is divided, fractions
// are compared crosswise, so that in float this is exact. `later` makes every end later.
static bool exactly_met(const slab_case *c, exact later) {
    const slab s[4] = {slab_of(c, 0), slab_of(c, 1), slab_of(c, 2), {c->t_min, c->t_max, 1}};
    const int ends = isfinite(c->t_max) ? 4 : 3;
    for (int i = 0; i < 3; i++) {
        if (s[i].speed == 0 && (s[i].from > 0 || s[i].to < 0)) return false;
        if (s[i].speed != 0 && s[i].to < 0) return false;
    }
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < ends; k++)
            if (s[i].speed != 0 && s[k].speed != 0 &&
                s[i].from * s[k].speed > s[k].to * s[i].speed * later)
                return false;
    return true;
}

typedef struct {
    double from, to; // in double: right to 1e-15
} span;

static span span_of(const slab_case *c) {
    span t = {(double)c->t_min, (double)c->t_max};
    for (int axis = 0; axis < 3; axis++) {
        const double d = along(c->r.d, axis), O = along(c->r.O, axis);
        const double low = along(c->box.min, axis) - O, high = along(c->box.max, axis) - O;
        if (d == 0 && (low > 0 || high < 0)) t.to = -1;
        if (d == 0) continue;
        t.from = fmax(t.from, (d < 0 ? high : low) / d);
        t.to = fmin(t.to, (d < 0 ? low : high) / d);
    }
    return t;
}

// What double is sure of need not be asked again.
static bool truly_met(const slab_case *c, span t, double slack) {
    const double sure = 1e-14, to = t.to * (1 + slack);
    if (t.from < to * (1 - sure)) return true;
    if (t.from > to * (1 + sure) || to < 0) return false;
    return exactly_met(c, 1 + (exact)slack);
}

// By so much a box may be passed: 32 roundings. Both ends have three, and an answer may make the
// interval longer at both by eight.
#define SLAB_SLACK (16 * (double)REAL_EPSILON)

// An answer by s / d - O / d rounds at the size of O and s: so a box may also be taken for one that
// is larger by as many roundings of its sides and of O.
static real slack_of(real O, real side) {
    return (real)(2e-12 + SLAB_SLACK * fabs((double)O) + SLAB_SLACK * fabs((double)side));
}
static slab_case enlarged(slab_case c) {
    const vec3 O = c.r.O, low = c.box.min, high = c.box.max;
    if (low.x > high.x || low.y > high.y || low.z > high.z) return c; // empty
    c.box.min =
        sub(low, (vec3){slack_of(O.x, low.x), slack_of(O.y, low.y), slack_of(O.z, low.z)});
    c.box.max =
        add(high, (vec3){slack_of(O.x, high.x), slack_of(O.y, high.y), slack_of(O.z, high.z)});
    return c;
}

#define SLAB_CALL "aabb_hit(box, r, t_min, t_max, &enter)"
#define NOT_WRITTEN ((real)-12345) // what *enter is before the call

// The latest that is allowed is where the ray is in the box.
static void check_not_late(real enter, double want) {
    const bool nearly = enter <= want * (1 + SLAB_SLACK);
    if (!nearly) return;
    hint_instead("*enter is too late by its roundings, and a hit just there would be given up: "
                 "move it outwards by what they may be (near_scale and near_offset do so; or a "
                 "factor 1 - 2 rounding_bound(…) on it).");
    suspect_value("the entry is not moved outwards by its roundings", (double)enter);
    check_at_most(__FILE__, __LINE__, "*enter of " SLAB_CALL, (double)enter, want,
                  "the ray is in the box from there on");
}

static void check_enter(const slab_case *c, real enter, double want, const char *note) {
    const slab_case larger = enlarged(*c);
    const double earliest = span_of(&larger).from * (1 - SLAB_SLACK);
    if (enter <= want * (1 + 1e-14) && enter >= earliest) return;
    given_slabs(c, note);
    if (enter == NOT_WRITTEN) {
        hint_instead("*enter must be written whenever the answer is true.");
        suspect_value("*enter was not written", (double)NOT_WRITTEN);
    }
    if (enter > want) check_not_late(enter, want);
    suspect_value("t_min, though the ray enters later", (double)c->t_min);
    suspect_value("where the ray leaves the box", span_of(c).to);
    check_real(__FILE__, __LINE__, "*enter of " SLAB_CALL, (double)enter, want,
               absolute_of(want - earliest, "a few roundings of t and of the coordinates"));
}

static void check_slabs(const slab_case *c, const char *note) {
    real enter = NOT_WRITTEN;
    const bool got = slabs_met(c, &enter);
    const span t = span_of(c);
    if (truly_met(c, t, 0)) {
        if (got) {
            check_enter(c, enter, t.from, note);
            return;
        }
        given_slabs(c, note);
        check_bool(__FILE__, __LINE__, SLAB_CALL, got, true);
    }
    const slab_case larger = enlarged(*c);
    if (!got || truly_met(&larger, span_of(&larger), SLAB_SLACK)) return;
    given_slabs(c, note);
    hint_instead("The ray passes this box. Are all three axes asked, t_min and t_max too? Made "
                 "longer by how much? The bound on the roundings is relative to t.");
    check_bool(__FILE__, __LINE__, SLAB_CALL, got, false);
}

// ---- data -------------------------------------------------------------------------------

static long whole_between(rng *g, long low, long high) {
    return low + (long)(rng_bits(g) % (uint32_t)(high - low + 1));
}

static bool chance(rng *g, double p) {
    return rng_double(g) < p;
}

// A box and a point of it, one component at a time.
typedef struct {
    real min, max, p, O, d;
} strip;

typedef struct {
    int sides;       // of the point that the ray goes to: 1 in a face, 2 on an edge, 3 a corner
    double flat;     // share of the axes along which the box is flat
    double zero;     // share of the components of d that are ±0
    long far;        // where the box is, in units of its size
    int size, speed; // powers of two around 1 of the box and of |d|
} slab_kind;

// Whole numbers: the ray goes through the point without any rounding.
static strip whole_strip(rng *g, const slab_kind *k, bool on_side, long t) {
    const long at = whole_between(g, -k->far, k->far);
    const long min = 8 * whole_between(g, -8, 8),
               size = chance(g, k->flat) ? 0 : 8 * whole_between(g, 1, 8);
    const long share = whole_between(g, 0, 8);
    const long p = min + (on_side ? (share % 2) * size : share * size / 8);
    const bool still = chance(g, k->zero), back = chance(g, 0.5);
    const long step = still ? 0 : whole_between(g, 1, 9);
    const real d = back ? -(real)step : (real)step;
    return (strip){(real)(at + min), (real)(at + min + size), (real)(at + p),
                   (real)(at + p - (back ? -t : t) * step), d};
}

// Any numbers: the ray goes through the point but for the rounding of d.
static strip rounded_strip(rng *g, const slab_kind *k, bool on_side, real distance) {
    const real at = (real)whole_between(g, -k->far, k->far);
    const real min = at + 8 * rng_real(g) - 4;
    const real max = chance(g, k->flat) ? min : min + 4 * rng_real(g);
    const real share = on_side ? (real)(rng_bits(g) % 2) : rng_real(g);
    const real p = share == 1 ? max : min + share * (max - min);
    const real O = chance(g, k->zero) ? p : p + distance * (2 * rng_real(g) - 1);
    const real d = p - O;
    return (strip){min, max, p, O, d == 0 && chance(g, 0.5) ? -d : d};
}

static slab_case case_of(const strip s[3], real size, real speed) {
    const vec3 min = {s[0].min, s[1].min, s[2].min}, max = {s[0].max, s[1].max, s[2].max};
    const vec3 O = {s[0].O, s[1].O, s[2].O}, d = {s[0].d, s[1].d, s[2].d};
    return (slab_case){{scale(size, min), scale(size, max)},
                       {scale(size, O), scale(size * speed, d)},
                       0,
                       NO_HIT};
}

// Now and then the interval ends or begins where the ray is at its point, or near it.
static void cut(rng *g, slab_case *c, real t) {
    const real ends[] = {NO_HIT, t, t / 2, 2 * t, t * (1 - REAL_EPSILON)};
    const real starts[] = {0, t, t / 2, 2 * t};
    if (!(t >= 0)) return;
    if (chance(g, 0.3)) c->t_max = ends[rng_bits(g) % COUNT(ends)];
    if (chance(g, 0.2)) c->t_min = starts[rng_bits(g) % COUNT(starts)];
    if (c->t_min > c->t_max) c->t_min = 0;
}

static slab_case slab_drawn(rng *g, const slab_kind *k) {
    const bool whole = chance(g, 0.5);
    const long t = whole_between(g, -1, 6);
    const real distance = (real)pow(10, between(g, -3, 2));
    const int first = (int)whole_between(g, 0, 2);
    strip s[3];
    for (int i = 0; i < 3; i++) {
        const int axis = (first + i) % 3;
        const bool on_side = i < k->sides;
        s[axis] =
            whole ? whole_strip(g, k, on_side, t) : rounded_strip(g, k, on_side, distance);
    }
    const long size = whole_between(g, -k->size, k->size),
               speed = whole_between(g, -k->speed, k->speed);
    slab_case c = case_of(s, (real)ldexp(1, (int)size), (real)ldexp(1, (int)speed));
    cut(g, &c, (real)ldexp(whole ? (double)t : 1.0, -(int)speed));
    return c;
}

static void check_kind(rng *g, int rays, slab_kind k, const char *note) {
    for (int i = 0; i < rays; i++) {
        const slab_case c = slab_drawn(g, &k);
        if (c.r.d.x == 0 && c.r.d.y == 0 && c.r.d.z == 0) continue;
        check_slabs(&c, note);
    }
}

// ---- tests ------------------------------------------------------------------------------

static void check_by_hand(slab_case c, bool met_there, double enter, const char *note) {
    real got = NOT_WRITTEN;
    const bool met = slabs_met(&c, &got);
    given_slabs(&c, note);
    check_bool(__FILE__, __LINE__, SLAB_CALL, met, met_there);
    if (met_there) check_enter(&c, got, enter, note);
}

static void slabs_worked_out(void) {
    const aabb box = {{1, 2, -3}, {4, 6, -1}};
    check_by_hand((slab_case){box, {{-2, 1, -5}, {3, 2, 2}}, 0, NO_HIT}, true, 1,
                  "\nby hand: x in [1, 2], y in [0.5, 2.5], z in [1, 2]: together [1, 2]");
    check_by_hand((slab_case){box, {{7, 9, 1}, {-3, -3, -2}}, 0, NO_HIT}, true, 1,
                  "\nby hand: x in [1, 2], y in [1, 2.33], z in [1, 2]: together [1, 2]");
    check_by_hand((slab_case){box, {{-2, 1, -5}, {3, 1, 2}}, 0, NO_HIT}, true, 1,
                  "\nby hand: x in [1, 2], y in [1, 5], z in [1, 2]: together [1, 2]");
    check_by_hand((slab_case){box, {{-2, 1, -5}, {3, 0.25f, 2}}, 0, NO_HIT}, false, 0,
                  "\nby hand: x in [1, 2], y in [4, 20]: nothing in common");
    check_by_hand((slab_case){box, {{2, 3, -2}, {3, -1, 2}}, 0, NO_HIT}, true, 0,
                  "\nby hand: O is inside, where the ray is at t_min");
    check_by_hand((slab_case){box, {{7, 9, 1}, {3, 3, 2}}, 0, NO_HIT}, false, 0,
                  "\nby hand: x in [-2, -1]: the box is behind");
    check_by_hand((slab_case){box, {{-2, 1, -5}, {3, 2, 2}}, 0, 0.75f}, false, 0,
                  "\nby hand: together [1, 2], which begins beyond t_max");
    check_by_hand((slab_case){box, {{-2, 1, -5}, {3, 2, 2}}, 2.5f, NO_HIT}, false, 0,
                  "\nby hand: together [1, 2], which ends before t_min");
    check_by_hand((slab_case){box, {{-2, 1, -5}, {3, 2, 2}}, 1.5f, NO_HIT}, true, 1.5,
                  "\nby hand: together [1, 2], begun at t_min");
}

static void slabs_generic(void) {
    rng g = check_rng(1220);
    check_kind(&g, 300000, (slab_kind){0, 0, 0, 4, 0, 0}, "");
    for (int i = 0; i < 300000; i++) { // any ray and any box: most miss
        const vec3 p = in_cube(&g), q = in_cube(&g);
        const aabb box = aabb_join((aabb){p, p}, (aabb){q, q});
        const vec3 O = scale(3, in_cube(&g)), d = in_cube(&g);
        const slab_case c = {box, {O, d}, 0, chance(&g, 0.5) ? NO_HIT : rng_real(&g)};
        check_slabs(&c, "");
    }
}

static void slabs_zero(void) {
    rng g = check_rng(1221);
    for (int sides = 0; sides <= 3; sides++)
        check_kind(&g, 60000, (slab_kind){sides, 0, 0.45, 4, 0, 0},
                   "\nsome components of d are ±0");
}

static void slabs_flat(void) {
    rng g = check_rng(1222);
    for (int sides = 0; sides <= 2; sides++) {
        check_kind(&g, 60000, (slab_kind){sides, 0.5, 0, 4, 0, 0}, "\nthe box may be flat");
        check_kind(&g, 60000, (slab_kind){sides, 0.5, 0.4, 4, 0, 0},
                   "\nthe box may be flat, or a point, and some components of d ±0");
    }
    check_kind(&g, 20000, (slab_kind){0, 1, 0.2, 4, 0, 0}, "\nthe box is a point");
}

static void slabs_edges(void) {
    rng g = check_rng(1223);
    check_kind(&g, 200000, (slab_kind){2, 0, 0, 4, 0, 0}, "\nthe ray is aimed at an edge");
    check_kind(&g, 200000, (slab_kind){3, 0, 0, 4, 0, 0}, "\nthe ray is aimed at a corner");
}

static void slabs_sizes(void) {
    rng g = check_rng(1224);
    for (int sides = 0; sides <= 3; sides++) {
        check_kind(&g, 30000, (slab_kind){sides, 0.1, 0.1, 1000000, 0, 33},
                   "\nboxes far from the origin; |d| from 1e-10 to 1e10");
        check_kind(&g, 30000, (slab_kind){sides, 0.1, 0.1, 4, 20, 33},
                   "\nboxes from 1e-6 to 1e6; |d| from 1e-10 to 1e10");
    }
}

static void slabs_empty(void) {
    rng g = check_rng(1225);
    for (int i = 0; i < 20000; i++) {
        const vec3 O = in_cube(&g), d = in_cube(&g);
        const bool x = chance(&g, 0.7), y = chance(&g, 0.7);
        const slab_case c = {aabb_empty, {O, {x ? d.x : 0, y ? d.y : 0, d.z}}, 0, NO_HIT};
        check_by_hand(c, false, 0, "\nthe box is empty: min > max");
    }
}

#endif
