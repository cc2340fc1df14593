// Tests of 03-plane: plane_hit, disc_hit, checks_average, and the hit record.
#include "chapters/03-plane/plane.h"
#include "common/exact3.h"
#include "common/wide3.h"
#include "tests/check.h"

static void given_plane(plane P, ray r) {
    given("plane through x = " VEC ", n = " VEC "; ray O = " VEC ", d = " VEC, ARG(P.x),
          ARG(P.n), ARG(r.O), ARG(r.d));
}

// t in higher precision: the reference.
static exact plane_t(plane P, ray r) {
    const exact3 n = exact_of(P.n);
    return exact_dot(exact_sub(P.x, r.O), n) / exact_dot(exact_of(r.d), n);
}

// Σ |a_i b_i| / |Σ a_i b_i|: how much of a dot product cancels.
static double cancelled(wide3 a, wide3 b) {
    return (fabs(a.x * b.x) + fabs(a.y * b.y) + fabs(a.z * b.z)) / fabs(wide_dot(a, b));
}

// What an answer in double may be off by, and one rounding to real: in float the
// first is nothing, with REAL=double all that there is.
static allowance double_inside(plane P, ray r) {
    const double above = cancelled(wide_sub(P.x, r.O), widen(P.n));
    const double along = cancelled(widen(r.d), widen(P.n));
    return relative_to(0.51 * REAL_EPSILON + 3 * DBL_EPSILON * (above + along),
                       "double inside, one rounding out");
}

// The whole line is asked for: what a miss looks like then.
static void suspect_miss(void) {
    suspect_value(
        "a miss, but t_min is -infinity here: t < 0 counts too, and a plane is hit from "
        "both sides",
        NO_HIT);
}

static void suspect_threshold(void) {
    suspect_value("a miss: only d·n == 0, exactly, is parallel, whatever it is measured by",
                  NO_HIT);
}

// A plane and a ray in generic positions, |x|, |O| up to `size`, |d| about `speed`.
static void generic(rng *g, real size, real speed, plane *P, ray *r) {
    P->x = scale(size, in_cube(g));
    P->n = in_cube(g);
    r->O = scale(size, in_cube(g));
    r->d = scale(speed, in_cube(g));
}

// ---- plane_hit ----------------------------------------------------------------

static void by_hand(void) {
    // 2x - y + 3z = 6 through (1, 2, 2); from O = (4, -1, 5) along (1, 2, -3):
    // above = (-3, 3, -3)·n = -18, along = 2 - 2 - 9 = -9, so t = 2.
    const plane P = {{1, 2, 2}, {2, -1, 3}};
    const ray r = {{4, -1, 5}, {1, 2, -3}};
    given_plane(P, r);
    suspect_miss();
    suspect_value("O - x in place of x - O", -2);
    suspect_value("d·n over (x - O)·n: upside down", 0.5);
    suspect_value("n made a unit vector on one side of the fraction only", 2 / sqrt(14.0));
    CHECK_REAL(plane_hit(P, r, -NO_HIT, NO_HIT), 2, exactly());
}

static void generic_planes(void) {
    rng g = rng_seed(3, 1);
    for (int i = 0; i < 2000; i++) {
        plane P;
        ray r;
        generic(&g, 5, 2, &P, &r);
        const exact t = plane_t(P, r);
        given_plane(P, r);
        suspect_miss();
        suspect_value("the distance from O, not t: t counts in |d|", (double)t * length(r.d));
        suspect_value("a plane through the origin: x is missing",
                      -(double)(dot(r.O, P.n) / dot(r.d, P.n)));
        CHECK_REAL(plane_hit(P, r, -NO_HIT, NO_HIT), t, double_inside(P, r));
    }
}

static void behind(void) {
    const plane P = {{0.25f, -1, 0.5f}, {0.5f, 2, -0.25f}};
    const ray r = {{1, 3, 2}, {0.5f, 0.75f, -1}};
    given_plane(P, r);
    suspect_miss();
    CHECK_REAL(plane_hit(P, r, -NO_HIT, NO_HIT), plane_t(P, r), double_inside(P, r));
    CHECK_REAL(plane_hit(P, r, 0, NO_HIT), NO_HIT, exactly());
}

static void interval(void) {
    const plane P = {{0, 0, -4}, {0, 0, 1}};
    const ray r = {{1, 2, 0}, {0, 0, -1}};
    given("a plane that the ray meets at t = 4, exactly");
    CHECK_REAL(plane_hit(P, r, 0, 5), 4, exactly());
    CHECK_REAL(plane_hit(P, r, 4, 5), NO_HIT, exactly());
    CHECK_REAL(plane_hit(P, r, 0, 4), NO_HIT, exactly());
    CHECK_REAL(plane_hit(P, r, 3, 3.5f), NO_HIT, exactly());
    // In double t is above t_min; rounded to real, as it is returned, it is t_min.
    const ray near = {{1, 2, (real)(REAL_EPSILON / 16)}, {0, 0, -1}};
    given("O.z = %g: t is 4 + %g, and 4 when it is rounded to real", (double)near.O.z,
          (double)near.O.z);
    CHECK_REAL(plane_hit(P, near, 4, 5), NO_HIT, exactly());
}

static void either_side(void) {
    const plane P = {{1, 2, 2}, {2, -1, 3}}, turned = {{1, 2, 2}, {-2, 1, -3}};
    const ray r = {{4, -1, 5}, {1, 2, -3}};
    given("the plane of before with its normal turned round: t must not change");
    CHECK_REAL(plane_hit(turned, r, 0, NO_HIT), plane_hit(P, r, 0, NO_HIT), exactly());
}

static void parallel(void) {
    const plane P = {{0, 1, 0}, {0, 3, 0}};
    given("a ray above the plane and parallel to it: O = (0, 2, 0), d = (1, 0, 2)");
    CHECK_REAL(plane_hit(P, (ray){{0, 2, 0}, {1, 0, 2}}, 0, NO_HIT), NO_HIT, exactly());
    given("a ray inside the plane: O = (0, 1, 0), d = (1, 0, 2)");
    CHECK_REAL(plane_hit(P, (ray){{0, 1, 0}, {1, 0, 2}}, -1, NO_HIT), NO_HIT, exactly());
    given("d = 0: no direction");
    CHECK_REAL(plane_hit(P, (ray){{0, 2, 0}, {0, 0, 0}}, 0, NO_HIT), NO_HIT, exactly());
}

// From 1e-20 to 1e20 times as long.
static vec3 some_length(vec3 n, rng *g) {
    return scale((real)pow(10, (int)(rng_bits(g) % 5) * 10 - 20), n);
}

// d·n far below any epsilon is still a hit, where d or n is short.
static void no_epsilon(void) {
    rng g = rng_seed(3, 2);
    for (int i = 0; i < 2500; i++) {
        plane P;
        ray r;
        generic(&g, 5, (real)pow(10, i % 25 - 12), &P, &r);
        P.n = some_length(P.n, &g);
        given_plane(P, r);
        suspect_threshold();
        CHECK_REAL(plane_hit(P, r, -NO_HIT, NO_HIT), plane_t(P, r), double_inside(P, r));
    }
}

// And where both are of length 1, but the ray all but parallel.
static void nearly_parallel(void) {
    const plane P = {{0, 0, 0}, {0, 1, 0}};
    for (int k = 3; k <= 30; k += 3) {
        const ray r = {{0, 1, 0}, {1, (real)-pow(10, -k), 0}};
        given_plane(P, r);
        suspect_threshold();
        CHECK_REAL(plane_hit(P, r, 0, NO_HIT), plane_t(P, r), double_inside(P, r));
    }
}

// Grazing rays: d·n / (|d| |n|) is `slope`, and the dot product cancels.
static vec3 at_slope(vec3 d, vec3 normal, real slope) {
    const vec3 n = normalize(normal);
    return add(sub(d, scale(dot(d, n), n)), scale(slope * length(d), n));
}

static void grazing(void) {
    rng g = rng_seed(3, 3);
    const real slopes[] = {(real)1e-3, (real)1e-5, (real)1e-6};
    for (int k = 0; k < COUNT(slopes); k++) {
        for (int i = 0; i < 1000; i++) {
            plane P;
            ray r;
            generic(&g, 5, 1, &P, &r);
            r.d = at_slope(r.d, P.n, slopes[k]);
            if (dot(r.d, P.n) == 0) continue;
            given_plane(P, r);
            suspect_threshold();
            CHECK_REAL(plane_hit(P, r, -NO_HIT, NO_HIT), plane_t(P, r), double_inside(P, r));
        }
    }
}

static void far_away(void) {
    rng g = rng_seed(3, 4);
    for (int i = 0; i < 1000; i++) {
        plane P;
        ray r;
        generic(&g, 1, 1, &P, &r);
        const vec3 there = scale((real)1e6, in_cube(&g)); // both shifted: x - O must not suffer
        P.x = add(P.x, there);
        r.O = add(r.O, there);
        const exact t = plane_t(P, r);
        if (t == 0) continue;
        given_plane(P, r);
        CHECK_REAL(plane_hit(P, r, -NO_HIT, NO_HIT), t, double_inside(P, r));
    }
}

static void not_a_number(void) {
    const plane P = {{0, -1, 0}, {0, 1, 0}};
    given("a ray with a direction that is not a number");
    CHECK_REAL(plane_hit(P, (ray){{0, 0, 0}, {0, (real)NAN, 0}}, 0, NO_HIT), NO_HIT, exactly());
}

// ---- hit_at ----------------------------------------------------------------------

// The surface passes through the box p ± error: judged in higher precision, and with
// n as it was given, not as it was rounded to unit length.
static void check_bound(plane P, ray r, hit h) {
    const exact off = exact_dot(exact_sub(h.p, P.x), exact_of(P.n));
    given_plane(P, r);
    CHECK_AT_MOST(fabs((double)off), (1 + 8 * REAL_EPSILON) * dot(h.error, absolute(P.n)),
                  "hit.error bounds |(p - x)·n|");
    CHECK_AT_MOST(fabs(length(h.n) - 1), 2 * REAL_EPSILON, "n is a unit vector");
    CHECK_BOOL(h.front, dot(r.d, P.n) < 0);
}

static void error_bound(void) {
    rng g = rng_seed(3, 5);
    for (int i = 0; i < 8000; i++) {
        plane P;
        ray r;
        const real size = (real)pow(10, i % 9 - 2);
        generic(&g, size, 1, &P, &r);
        if (i % 2) { // both far away
            const vec3 there = scale(1000 * size, in_cube(&g));
            P.x = add(P.x, there);
            r.O = add(r.O, there);
        }
        const real t = plane_hit(P, r, 0, NO_HIT);
        if (t == NO_HIT) continue;
        check_bound(P, r, plane_surface(P, r, t));
    }
}

// ---- equations -------------------------------------------------------------------

// As double_inside: here D and n·O are what is subtracted.
static allowance by_equation(plane P, ray r, double D) {
    const wide3 n = widen(P.n), O = widen(r.O);
    const double on = fabs(n.x * O.x) + fabs(n.y * O.y) + fabs(n.z * O.z);
    const double above = (fabs(D) + on) / fabs(D - wide_dot(n, O));
    const double along = cancelled(widen(r.d), n);
    return relative_to(0.51 * REAL_EPSILON + 3 * DBL_EPSILON * (above + along),
                       "double inside, one rounding out");
}

typedef struct {
    real size;        // of everything
    real from_origin; // how far away all of it is
    real along;       // how far each x is from the rest, in its plane
    real slope;       // of the ray to the first plane; 0: any
    real speed;       // |d|, about
} layout;

static ray fill_planes(layout l, plane *P, int count, rng *g) {
    ray r;
    const vec3 there = scale(l.from_origin, in_cube(g));
    for (int k = 0; k < count; k++) {
        generic(g, l.size, l.speed, &P[k], &r);
        P[k].n = some_length(P[k].n, g);
        P[k].x = add(add(P[k].x, there), scale(l.along, at_slope(in_cube(g), P[k].n, 0)));
    }
    r.O = add(r.O, there);
    if (l.slope > 0) r.d = at_slope(r.d, P[0].n, l.slope);
    return r;
}

static void check_equation(plane P, const plane_equations *E, int k, ray r, real t) {
    const double D = E->D[k];
    given_plane(P, r);
    CHECK_REAL(D, exact_dot(exact_of(P.x), exact_of(P.n)),
               relative_to(0.501 * DBL_EPSILON, "one rounding"));
    CHECK_REAL(t, plane_t(P, r), by_equation(P, r, D));
    if (!(t > 0 && t < REAL_MAX)) return;
    check_bound(P, r, equations_surface(E, k, r, t));
    check_bound(P, r, plane_surface(P, r, t));
}

static void equations_at(layout l, rng *g) {
    plane P[EQUATIONS];
    const int count = 1 + (int)(rng_bits(g) % EQUATIONS);
    const ray r = fill_planes(l, P, count, g);
    const plane_equations E = plane_equations_of(P, count);
    real t[EQUATIONS];
    equations_hit(&E, r, -NO_HIT, t);
    for (int k = 0; k < count; k++) check_equation(P[k], &E, k, r, t[k]);
    for (int k = count; k < EQUATIONS; k++) {
        given("%d planes, and of the equations that are left over the one in place %d", count,
              k);
        CHECK_REAL(t[k], NO_HIT, exactly());
    }
}

static void equations_generic(void) {
    rng g = rng_seed(3, 11);
    for (int i = 0; i < 2000; i++)
        equations_at((layout){(real)pow(10, i % 9 - 2), 0, 0, 0, 1}, &g);
}

static void equations_far(void) {
    rng g = rng_seed(3, 12);
    for (int i = 0; i < 2000; i++) {
        const real far = (real)pow(10, i % 7);
        equations_at((layout){1, i & 1 ? far : 0, i & 2 ? far : 0, 0, 1}, &g);
    }
}

static void equations_no_epsilon(void) {
    rng g = rng_seed(3, 14);
    for (int i = 0; i < 2500; i++)
        equations_at((layout){5, 0, 0, 0, (real)pow(10, i % 25 - 12)}, &g);
}

static void equations_grazing(void) {
    rng g = rng_seed(3, 13);
    for (int i = 0; i < 3000; i++)
        equations_at((layout){5, 0, 0, (real)pow(10, -3 - i % 4), 1}, &g);
}

static void equations_miss(void) {
    const plane P[] = {{{0, 1, 0}, {0, 3, 0}}, {{0, 2, 0}, {0, -2, 0}}};
    const plane_equations E = plane_equations_of(P, 2);
    const struct {
        const char *what;
        ray r;
        real t_min, first, second;
    } cases[] = {
        {"down from between two floors", {{5, 1.5f, 7}, {0, -1, 0}}, 0, 0.5f, NO_HIT},
        {"the same, when t = -0.5 counts", {{5, 1.5f, 7}, {0, -1, 0}}, -1, 0.5f, -0.5f},
        {"the same, t_min = 0.5: excluded", {{5, 1.5f, 7}, {0, -1, 0}}, 0.5f, NO_HIT, NO_HIT},
        {"parallel to both", {{5, 1.5f, 7}, {1, 0, 2}}, -NO_HIT, NO_HIT, NO_HIT},
        {"within the first", {{5, 1, 7}, {1, 0, 2}}, -NO_HIT, NO_HIT, NO_HIT},
        {"d = 0", {{5, 1.5f, 7}, {0, 0, 0}}, -NO_HIT, NO_HIT, NO_HIT},
        {"a d that is no number", {{5, 1.5f, 7}, {0, (real)NAN, 0}}, 0, NO_HIT, NO_HIT},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        real t[EQUATIONS];
        equations_hit(&E, cases[i].r, cases[i].t_min, t);
        given("planes y = 1 and y = 2, a ray %s", cases[i].what);
        CHECK_REAL(t[0], cases[i].first, exactly());
        CHECK_REAL(t[1], cases[i].second, exactly());
    }
}

// ---- disc_hit --------------------------------------------------------------------

static void disc_generic(void) {
    rng g = rng_seed(3, 6);
    int hits = 0;
    for (int i = 0; i < 4000; i++) {
        disc D;
        ray r;
        generic(&g, 3, 2, &D.P, &r);
        D.radius = 4 * rng_real(&g);
        const exact t = plane_t(D.P, r);
        const double x = (double)(r.O.x + t * r.d.x - D.P.x.x);
        const double y = (double)(r.O.y + t * r.d.y - D.P.x.y);
        const double z = (double)(r.O.z + t * r.d.z - D.P.x.z);
        const double distance = sqrt(x * x + y * y + z * z);
        if (fabs(distance - D.radius) < 1e-4) continue; // too close to call in float
        const bool inside = distance < D.radius;
        hits += inside;
        given("disc at " VEC ", n = " VEC ", radius %g; ray O = " VEC ", d = " VEC
              "; meets the plane %g from the centre",
              ARG(D.P.x), ARG(D.P.n), (double)D.radius, ARG(r.O), ARG(r.d), distance);
        CHECK_REAL(disc_hit(D, r, -NO_HIT, NO_HIT), inside ? (double)t : (double)NO_HIT,
                   double_inside(D.P, r));
    }
    CHECK(hits > 500, "the test itself: enough of its rays hit");
}

// An eye so far away that a rounded t is off by a good part of the disc.
static void disc_far(void) {
    rng g = rng_seed(3, 9);
    int hits = 0;
    for (int i = 0; i < 4000; i++) {
        disc D;
        ray r;
        generic(&g, 1, 1, &D.P, &r);
        D.radius = 1;
        r.d = sub(D.P.x, scale((real)3e5, r.d)); // from there towards the disc
        r.O = neg(r.d);
        r.d = add(r.d, scale((real)0.7, in_cube(&g)));
        const exact t = plane_t(D.P, r);
        const exact x = r.O.x + t * r.d.x - D.P.x.x, y = r.O.y + t * r.d.y - D.P.x.y;
        const exact z = r.O.z + t * r.d.z - D.P.x.z;
        const double distance = sqrt((double)(x * x + y * y + z * z));
        if (fabs(distance - 1) < 1e-4) continue; // what double may get wrong, and a little more
        hits += distance < 1;
        given("disc at " VEC ", n = " VEC ", radius 1; ray O = " VEC ", d = " VEC
              "; meets the plane %g from the centre",
              ARG(D.P.x), ARG(D.P.n), ARG(r.O), ARG(r.d), distance);
        CHECK_BOOL(disc_hit(D, r, 0, NO_HIT) != NO_HIT, distance < 1);
    }
    CHECK(hits > 500, "the test itself: enough of its rays hit");
}

static void disc_rim(void) {
    const disc D = {{{1, 2, -5}, {0, 0, 2}}, 5};
    given("disc at (1, 2, -5), n = (0, 0, 2), radius 5; ray to (4, 6, -5), exactly on the rim");
    CHECK_REAL(disc_hit(D, (ray){{4, 6, 0}, {0, 0, -1}}, 0, NO_HIT), 5, exactly());
    given("the same disc, a ray to (4, 6.125, -5), outside the rim");
    CHECK_REAL(disc_hit(D, (ray){{4, 6.125f, 0}, {0, 0, -1}}, 0, NO_HIT), NO_HIT, exactly());
    given("the same disc from behind t_max = 4");
    CHECK_REAL(disc_hit(D, (ray){{4, 5, 0}, {0, 0, -1}}, 0, 4), NO_HIT, exactly());
}

static void disc_of_nothing(void) {
    const disc D = {{{1, 2, -5}, {0, 0, 1}}, 0};
    given("a disc of radius 0, and a ray through its centre");
    CHECK_REAL(disc_hit(D, (ray){{1, 2, 0}, {0, 0, -1}}, 0, NO_HIT), NO_HIT, exactly());
}

// ---- checks_average ----------------------------------------------------------------

// The share of [x - w/2, x + w/2] that lies in odd squares: overlap by overlap.
static exact odd_share(exact x, exact w) {
    const exact lo = x - w / 2, hi = x + w / 2;
    exact sum = 0;
    for (double k = floor((double)lo) - 1; k <= (double)hi; k += 1) {
        if (fmod(fabs(k), 2) != 1) continue;
        const exact from = lo > k ? lo : k, to = hi < k + 1 ? hi : k + 1;
        if (to > from) sum += to - from;
    }
    return sum / w;
}

static double mean_of_checks(real x, real z, double w) {
    const exact p = odd_share(x, w), q = odd_share(z, w);
    return (double)(p * (1 - q) + (1 - p) * q);
}

static void average(real x, real z, real w) {
    const double mean = mean_of_checks(x, z, w);
    given("x = %.9g, z = %.9g, w = %.9g", (double)x, (double)z, (double)w);
    suspect_value("1 minus the answer: which square is 1?", 1 - mean);
    suspect_value("the sum over the box, not divided by w", mean * (double)w);
    suspect_value("a box with sides 2w", mean_of_checks(x, z, 2 * (double)w));
    suspect_value("the square of the centre, not a mean", checks(x, z));
    // x ± w/2 in double is off by a rounding of x, the mean by that over w.
    const double rounded = 4 * DBL_EPSILON * (1 + (fabs(x) + fabs(z)) / w);
    CHECK_REAL(checks_average(x, z, w), mean,
               absolute_of(rounded + REAL_EPSILON, "double inside, one rounding out"));
}

static void average_generic(void) {
    rng g = rng_seed(3, 7);
    for (int i = 0; i < 2000; i++) {
        const real x = 20 * rng_real(&g) - 10, z = 20 * rng_real(&g) - 10;
        average(x, z, (real)0.05 + 5 * rng_real(&g));
    }
}

// Boxes of a pixel's size on a border between squares, up to 1000 away.
static void average_small(void) {
    rng g = rng_seed(3, 10);
    for (int i = 0; i < 2000; i++) {
        const real w = (real)pow(10, -(i % 6));
        const real x = floor(2000 * rng_real(&g) - 1000) + w * (rng_real(&g) - (real)0.5);
        const real z = 2000 * rng_real(&g) - 1000;
        average(x, z, w);
    }
}

static void average_limits(void) {
    given("a small box inside a square: x = 3.5, z = -1.25, w = 0.25");
    CHECK_REAL(checks_average(3.5f, -1.25f, 0.25f), 1, exactly());
    given("a small box inside a square: x = 3.5, z = -2.75, w = 0.25");
    CHECK_REAL(checks_average(3.5f, -2.75f, 0.25f), 0, exactly());
    given("a box of two whole periods: x = 0.3, z = 0.7, w = 4: as much of each");
    CHECK_REAL(checks_average(0.3f, 0.7f, 4), 0.5, absolute_of(4e-7, "float coordinates"));
    rng g = rng_seed(3, 8);
    for (int i = 0; i < 1000; i++) {
        const real x = (real)1e6 * rng_real(&g), w = (real)1e3 * rng_real(&g) + 1;
        const real share = checks_average(x, -x / 3, w);
        given("x = %.9g, z = %.9g, w = %.9g", (double)x, (double)(-x / 3), (double)w);
        CHECK(share >= -1e-6 && share <= 1 + 1e-6,
              "a mean of zeros and ones lies between 0 and 1");
    }
}

static void board(void) {
    given("checks at the corners of squares, negative coordinates included");
    CHECK_INT(checks(0, 0), 0);
    CHECK_INT(checks(-0.5f, 0.5f), 1);
    CHECK_INT(checks(-0.5f, -0.5f), 0);
    CHECK_INT(checks(1, 0.5f), 1);
    CHECK_INT(checks(-1, 0.5f), 1);
    CHECK_INT(checks((real)3e9, 0.5f), 0);
}

int main(void) {
    static const char *const solve =
        "Solve (O + t d - x)·n = 0 for t, by hand, for these numbers.";
    static const char *const solve_in_double =
        "Is the formula right? Then both dot products in double, by wide_dot(widen(..), ..): "
        "a double that holds dot(..) comes too late.";
    static const char *const only_zero = "If you got a miss: only d·n == 0, exactly, is "
                                         "parallel; a threshold throws away short d. "
                                         "If only the last digits differ: double inside.";
    static const char *const double_inside =
        "Float products cancel here. Work out both dot products in double.";
    static const test tests[] = {
        {"plane_hit: worked out by hand", by_hand, solve},
        {"plane_hit: 2000 generic planes", generic_planes, solve_in_double},
        {"plane_hit: what t < 0 means", behind,
         "The plane lies behind the eye: not above t_min."},
        {"plane_hit: t_min < t < t_max", interval,
         "Both ends are excluded, and t is compared as it is returned: rounded to real."},
        {"plane_hit: either side of the plane", either_side,
         "A plane has no back that is invisible."},
        {"plane_hit: parallel rays", parallel, "d·n = 0: 0/0 or ±infinity must become NO_HIT."},
        {"plane_hit: tiny and huge d and n", no_epsilon, only_zero},
        {"plane_hit: all but parallel", nearly_parallel, only_zero},
        {"plane_hit: grazing rays", grazing, double_inside},
        {"plane_hit: far from the origin", far_away,
         "Subtract first, and in double: (x - O)·n, not x·n - O·n."},
        {"plane_hit: NaN is no hit", not_a_number,
         "Write t > t_min && t < t_max: NaN fails both."},
        {"plane_surface: the error bound holds", error_bound, solve},
        {"equations_hit: generic planes", equations_generic, "Given code: did it change?"},
        {"equations_hit: far away, and x far from the ray", equations_far,
         "Given code: did it change?"},
        {"equations_hit: grazing rays", equations_grazing, "Given code: did it change?"},
        {"equations_hit: tiny and huge d", equations_no_epsilon, "Given code: did it change?"},
        {"equations_hit: misses", equations_miss, "Given code: did it change?"},
        {"disc_hit: 4000 generic discs", disc_generic, "How far is O + t d from the centre?"},
        {"disc_hit: seen from far away", disc_far,
         "The t of plane_hit is rounded to real: far away its point is off by more than you "
         "think."},
        {"disc_hit: the rim and the interval", disc_rim, "The rim belongs to the disc."},
        {"disc_hit: radius 0", disc_of_nothing, "A disc without area is never hit."},
        {"checks_average: boxes of 0.05 to 5 squares", average_generic,
         "Average each wave, then multiply."},
        {"checks_average: small boxes far out", average_small,
         "x + w/2 needs more digits than a float has: double, from the first operation."},
        {"checks_average: limits", average_limits, "Which squares does the box cover?"},
        {"checks: the board itself", board, "floor, not a cast: -0.5 lies in square -1."},
    };
    return run_tests("03-plane", tests, COUNT(tests));
}
