// check-directions.h: what tests of random directions need: generic normals, generators that
// draw the rarest numbers, and chi² over cells of equal probability.
#ifndef TESTS_CHECK_DIRECTIONS_H
#define TESTS_CHECK_DIRECTIONS_H

#include "common/measure.h"
#include "tests/check-generic.h"
#include "tests/check.h"

#define FALSE_ALARM 1e-6 // of a chi² test of a right answer

// A cosine that is 0 but for the rounding of the two directions.
#define BELOW_BY_ROUNDING (-4 * (double)REAL_EPSILON)

// ---- generic data, beside that of check-generic.h ------------------------------------

// The rounding of the result, and what double loses before that: little, times `condition`.
static inline allowance double_inside(double condition) {
    return relative_to(2 * REAL_EPSILON + 16 * DBL_EPSILON * condition,
                       "double inside: only the result is rounded");
}

static inline double cosine(vec3 a, vec3 b) {
    return wide_dot(widen(a), widen(b));
}

// The angle of v about n, as a share of the full turn.
static inline double turn(vec3 v, vec3 n) {
    const vec3 across = perpendicular(n);
    const double x = cosine(v, across);
    const double y = wide_dot(wide_cross(widen(n), widen(across)), widen(v));
    return atan2(y, x) / (2 * PI) + 0.5;
}

// The first ones defeat a basis that divides by 1 + n.z, or by n.x² + n.y².
enum { NORMALS = 8 };
static inline vec3 test_normal(int i, rng *g) {
    const vec3 special[] = {{0, 0, -1}, {0, 0, 1}, {(real)1e-4, (real)-2e-4, -1}, {0, -1, 0}};
    return i < COUNT(special) ? normalize(special[i]) : generic_unit(g);
}

// ---- generators that draw what is rare ---------------------------------------------

static const uint64_t multiplier = 6364136223846793005u; // of common/rng.c

// Newton's method modulo 2^64: each step doubles the right bits.
static inline uint64_t inverse_of(uint64_t odd) {
    uint64_t x = odd;
    for (int i = 0; i < 6; i++) x *= 2 - odd * x;
    return x;
}

// The generator whose draws number `after` and after + 1 (0, 1, ...) are exactly 0.
static inline rng drawing_zero(int after, uint64_t stream) {
    rng g = {0, 2 * (stream % 1000) + 1}; // small: the state 0 and the next both give 0
    for (int i = 0; i < after; i++) g.state = (g.state - g.increment) * inverse_of(multiplier);
    return g;
}

// The generator whose draw number `after` is the largest number below 1 (double: within 2^-27).
static inline rng drawing_most(int after, uint64_t stream) {
    const uint64_t y = (uint64_t)0xffffffff << 27;
    rng g = {y ^ y >> 18 ^ y >> 36 ^ y >> 54, 2 * (stream % 1000) + 1};
    for (int i = 0; i < after; i++) g.state = (g.state - g.increment) * inverse_of(multiplier);
    return g;
}

enum { RARE = 400 };
static inline rng drawing_rare(int i) {
    const int after = i / 2 % 8; // bits: a real of a double build takes two
    return i % 2 ? drawing_zero(after, (uint64_t)i) : drawing_most(after, (uint64_t)i);
}

// ---- chi² --------------------------------------------------------------------------

// Cells of equal probability: `height` and `turn` are uniform in [0, 1) for a right sampler.
enum { BANDS = 8, SECTORS = 12, CELLS = BANDS * SECTORS };

typedef struct {
    long cells[CELLS], count;
} tally;

static inline int slot(double x, int count) {
    return (int)fmin(count - 1, fmax(0, floor(count * x))); // NaN goes to the first
}

static inline void tally_add(tally *t, double height, double around) {
    t->cells[slot(height, BANDS) * SECTORS + slot(around, SECTORS)]++;
    t->count++;
}

// chi² of `count` draws in `cells` cells of equal probability.
static inline double chi2_of(const long *cell, int cells, long count) {
    const double expected = (double)count / cells;
    double chi2 = 0;
    for (int i = 0; i < cells; i++)
        chi2 += (cell[i] - expected) * (cell[i] - expected) / expected;
    return chi2;
}

#define CHECK_UNIFORM(t)                                                                      \
    check_at_most(__FILE__, __LINE__, "chi² of the counts in the cells",                      \
                  chi2_of((t)->cells, CELLS, (t)->count), chi2_limit(CELLS - 1, FALSE_ALARM), \
                  "chi² that a right answer exceeds once in a million")

// Of a tally of directions: is about half of the angle empty?
#define CHECK_ALL_ROUND(t)                                                                  \
    check_that(                                                                             \
        __FILE__, __LINE__, "there are draws in most of the 12 sectors", !half_is_empty(t), \
        "draws on all sides: the cells of one half of the angle are empty: φ goes to 2π")

static inline bool half_is_empty(const tally *t) {
    int empty = 0;
    for (int k = 0; k < SECTORS; k++) {
        long count = 0;
        for (int i = 0; i < BANDS; i++) count += t->cells[i * SECTORS + k];
        empty += count == 0;
    }
    return empty >= SECTORS / 3 && empty <= SECTORS * 2 / 3;
}

// The mean of what was added, called `what`: within 5 standard errors and `grain`. NaN among
// the numbers is one in the mean, and would be one in its standard error too.
#define CHECK_MEAN(what, s, expected, grain) \
    check_mean(__FILE__, __LINE__, what, s, expected, grain)

static inline void check_mean(const char *file, int line, const char *what, const running *s,
                              double expected, double grain) {
    const double error = running_standard_error(s);
    const allowance allowed = isfinite(error)
                                  ? standard_errors(5, error + grain)
                                  : relative_to(0.01, "no number has no standard error");
    check_real(file, line, what, s->mean, expected, allowed);
}

// Draws must differ: a sampler that seeds its own generator repeats itself.
typedef struct {
    vec3 first;
    long draws, alike;
} repeats;

static inline void count_repeat(repeats *r, vec3 v) {
    if (r->draws++ == 0) r->first = v;
    r->alike += v.x == r->first.x && v.y == r->first.y && v.z == r->first.z;
}

// ---- draws come from g -----------------------------------------------------------------

static inline bool same_state(rng a, rng b) {
    return a.state == b.state && a.increment == b.increment;
}

static inline bool same_number(real a, real b) {
    return a == b || (isnan(a) && isnan(b)); // NaN is another test's
}

// The same numbers, the same picture, on any number of threads. `first` and `second` were drawn
// with g in the same state, of what is given.
#define ASKED_TWICE "asked twice with g in the same state: " VEC " and then " VEC
static inline void check_from_g(vec3 first, vec3 second) {
    suspect_slip("numbers that do not come from g: rand(), a generator of your own, or "
                 "something kept from the call before? Then every run, and every number of "
                 "threads, draws another picture");
    const bool the_same_draw_twice = same_number(first.x, second.x) &&
                                     same_number(first.y, second.y) &&
                                     same_number(first.z, second.z);
    CHECK(the_same_draw_twice, "the same draw, bit for bit: g alone decides");
}

#endif
