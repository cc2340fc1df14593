// Tests of 04-sphere: the two quadratics, nearest_root, far_discriminant, the sphere and
// the cylinder. References are worked out in 113 bits.
#include "chapters/04-sphere/sphere.h"
#include "common/exact3.h"
#include "tests/check.h"

static const double u64 = DBL_EPSILON / 2; // one rounding of a double

// ---- vectors in higher precision, generic data ------------------------------------

static double error_of(double got, exact want) {
    return relative_error(got, want) * (double)REAL_EPSILON;
}

static vec3 in_ball(rng *g) {
    for (;;) {
        const vec3 p = in_cube(g);
        if (dot(p, p) <= 1) return p;
    }
}

// 1 to 2 times 10^k, either sign.
static double of_size(rng *g, double k) {
    const double x = (1 + rng_double(g)) * pow(10, k);
    return rng_bits(g) & 1 ? x : -x;
}

static void given_roots(roots q, real t_min, real t_max) {
    given("%d root%s: %.17g and %.17g; t_min = %.9g, t_max = %.9g", q.count,
          q.count == 1 ? "" : "s", q.t0, q.t1, (double)t_min, (double)t_max);
}

static void given_quadratic(double a, double b, double c) {
    given("a = %.17g, b = %.17g, c = %.17g", a, b, c);
}

static void given_sphere(sphere S, ray r) {
    given("sphere c = " VEC ", r = %.9g; ray O = " VEC ", d = " VEC, ARG(S.c), (double)S.r,
          ARG(r.O), ARG(r.d));
}

static void given_cylinder(cylinder C, ray r) {
    given("tube from a = " VEC " to b = " VEC ", r = %.9g; ray O = " VEC ", d = " VEC, ARG(C.a),
          ARG(C.b), (double)C.r, ARG(r.O), ARG(r.d));
}

// ---- nearest_root -------------------------------------------------------------------

typedef struct {
    roots q;
    real t_min, t_max, want;
} choice_of_root;

// A root that does not count, and why. False for NaN.
static void suspect_root(double root, real t_min, real t_max) {
    if ((real)root <= t_min)
        suspect_value(root > (double)t_min
                          ? "a root above t_min, but t_min itself once rounded"
                          : "a root that is not above t_min: it does not count",
                      root);
    if ((real)root >= t_max)
        suspect_value(root < (double)t_max
                          ? "a root below t_max, but t_max itself once rounded"
                          : "a root that is not below t_max: it does not count",
                      root);
}

static void check_choice(const choice_of_root *c) {
    const roots q = c->q;
    const real t_min = c->t_min, t_max = c->t_max;
    given_roots(q, t_min, t_max);
    suspect_root(q.t0, t_min, t_max);
    suspect_root(q.t1, t_min, t_max);
    if (c->want == (real)q.t0 && q.count == 2) suspect_value("the larger root", q.t1);
    CHECK_REAL(nearest_root(q, t_min, t_max), c->want, exactly());
}

static void check_choices(const choice_of_root *rows, int count) {
    for (int i = 0; i < count; i++) check_choice(&rows[i]);
}

static void which_root(void) {
    static const choice_of_root rows[] = {
        {{2, 1.5, 4.25}, 0, NO_HIT, 1.5f},     // both before the eye
        {{2, -1.5, 4.25}, 0, NO_HIT, 4.25f},   // from inside
        {{2, -4.25, -1.5}, 0, NO_HIT, NO_HIT}, // both behind
        {{2, 1.5, 4.25}, 2, NO_HIT, 4.25f},    // the nearer one too near
        {{2, 3.5, 3.5}, 0, NO_HIT, 3.5f},      // a tangent
    };
    check_choices(rows, COUNT(rows));
}

static void root_interval(void) {
    static const choice_of_root rows[] = {
        {{2, 1.5, 4.25}, 0, 4, 1.5f},       {{2, 1.5, 4.25}, 0, 1.25f, NO_HIT},
        {{2, 1.5, 4.25}, 2, 4, NO_HIT},     {{2, 1.5, 4.25}, 1.5f, NO_HIT, 4.25f},
        {{2, 1.5, 4.25}, 2, 4.25f, NO_HIT}, {{2, 1.5, 4.25}, 4.25f, NO_HIT, NO_HIT},
        {{2, 1.5, 4.25}, 0, 1.5f, NO_HIT},  {{2, -3, -2}, -2.5f, NO_HIT, -2},
        {{2, 0, 4.25}, 0, NO_HIT, 4.25f},
    };
    check_choices(rows, COUNT(rows));
}

static void fewer_roots(void) {
    static const choice_of_root rows[] = {
        {{0, 0, 0}, -1, NO_HIT, NO_HIT},
        {{0, 2, 3}, 0, NO_HIT, NO_HIT},
        {{1, 2.5, 2.5}, 0, NO_HIT, 2.5f},
        {{1, -2.5, -2.5}, 0, NO_HIT, NO_HIT},
        {{2, (double)NAN, (double)NAN}, 0, NO_HIT, NO_HIT},
    };
    check_choices(rows, COUNT(rows));
}

static void root_by_search(void) {
    rng g = rng_seed(4, 1);
    for (int i = 0; i < 5000; i++) {
        const double x = 4 * rng_double(&g) - 2, y = 4 * rng_double(&g) - 2;
        const roots q = {2, fmin(x, y), fmax(x, y)};
        const real t_min = 2 * rng_real(&g) - 1, t_max = t_min + 2 * rng_real(&g);
        real want = NO_HIT;
        for (int k = 1; k >= 0; k--) { // the larger first, so that the smaller wins
            const real t = (real)(k ? q.t1 : q.t0);
            if (t_min < t && t < t_max) want = t;
        }
        check_choice(&(choice_of_root){q, t_min, t_max, want});
    }
}

// A double just above t_min may round to t_min itself: then it is no hit.
static void root_rounded(void) {
    rng g = rng_seed(4, 2);
    for (int i = 0; i < 200; i++) {
        const real t = 1 + rng_real(&g);
        const double tiny = (double)REAL_EPSILON / 16;
        const double above = t * (1 + tiny), below = t * (1 - tiny);
        check_choice(&(choice_of_root){{1, above, above}, t, NO_HIT, NO_HIT});
        check_choice(&(choice_of_root){{1, below, below}, 0, t, NO_HIT});
        check_choice(&(choice_of_root){{2, above, 4.25}, t, NO_HIT, 4.25f});
    }
}

// ---- the quadratics -----------------------------------------------------------------

static exact discriminant_of(double a, double b, double c) {
    return (exact)b * b - 4 * (exact)a * c;
}

static allowance double_roundings(double n) {
    return relative_to(n * u64, "double arithmetic without cancellation");
}

static const double worst_of_quadratic = 4; // roundings: 1.5 in the discriminant, q, a quotient

typedef struct {
    exact discriminant, t0, t1; // t0 <= t1
} pair;

// By q, without cancellation. a != 0.
static pair exact_roots(double a, double b, double c) {
    const exact discriminant = discriminant_of(a, b, c), s = exact_sqrt(discriminant);
    const exact q = b > 0 ? -b - s : -b + s;
    const exact x = q / (2 * (exact)a), y = q == 0 ? x : 2 * (exact)c / q;
    return (pair){discriminant, x < y ? x : y, x < y ? y : x};
}

// Which of the two roots a check is about.
static double end_of(double x, double y, bool larger) {
    return larger ? fmax(x, y) : fmin(x, y);
}

static void suspect_slide(double a, double b, double c, bool larger) {
    const roots slide = solve_quadratic(a, b, c);
    suspect_value("what the slide's formula gives: digits cancelled in -b ± sqrt(..), in "
                  "b² - 4ac, or in both",
                  larger ? slide.t1 : slide.t0);
}

// The classic slips, worked out as they would be in double. got is a, b, c with its mistake.
static void suspect_q(double a, double b, double c, bool larger) {
    const double h = b / 2, s = sqrt(h * h - a * c), S = sqrt(b * b - a * c);
    const double q = -(h + copysign(s, h)), Q = -(b + copysign(S, b));
    const double cancelled = -h + copysign(s, h);
    suspect_value("h² - ac from two rounded products: the loss is there, not in q",
                  end_of(q / a, c / q, larger));
    suspect_slide(a, b, c, larger);
    suspect_value("q with the sign that cancels, -h + sign(h) sqrt(..)",
                  end_of(cancelled / a, c / cancelled, larger));
    suspect_value("q with the wrong sign: minus the other root",
                  end_of(-q / a, -c / q, larger));
    suspect_value("h = b: it is half of b", end_of(Q / a, c / Q, larger));
    suspect_value("twice q: q = -(b + sign(b) sqrt(b² - 4ac)) / 2",
                  end_of(2 * q / a, c / (2 * q), larger));
}

static void given_root(double a, double b, double c, pair want, bool larger) {
    given_quadratic(a, b, c);
    if (b == 0) { // q = 0, and c / q is infinite or was avoided
        suspect_value("a root for b = 0: is your sign(0) 0? It must be 1", 0);
        suspect_value("a root for b = 0: is your sign(0) 0? It must be 1", HUGE_VAL);
        suspect_value("a root for b = 0: is your sign(0) 0? It must be 1", -HUGE_VAL);
    }
    suspect_value("the two roots in the wrong order", (double)(larger ? want.t0 : want.t1));
    suspect_q(a, b, c, larger);
}

// The count that rounded products lead to, and the one with h = b, where they are wrong.
static void given_count(double a, double b, double c, int want) {
    const int rounded = b / 2 * (b / 2) - a * c >= 0 ? 2 : 0,
              whole = b * b - a * c >= 0 ? 2 : 0;
    given_quadratic(a, b, c);
    if (rounded != want)
        suspect_value("h² - ac from two rounded products: its sign is wrong", rounded);
    else if (whole != want)
        suspect_value("b² - ac: a quarter of the discriminant is (b/2)² - ac", whole);
}

// Count and roots of stable_quadratic against higher precision. a != 0. Returns the error.
static double check_stable(double a, double b, double c) {
    const pair want = exact_roots(a, b, c);
    const int count = want.discriminant < 0 ? 0 : 2;
    given_count(a, b, c, count);
    CHECK_INT(stable_quadratic(a, b, c).count, count);
    if (count == 0) return 0;
    const allowance allowed = double_roundings(worst_of_quadratic);
    given_root(a, b, c, want, false);
    CHECK_REAL(stable_quadratic(a, b, c).t0, (double)want.t0, allowed);
    given_root(a, b, c, want, true);
    CHECK_REAL(stable_quadratic(a, b, c).t1, (double)want.t1, allowed);
    const roots q = stable_quadratic(a, b, c);
    return fmax(error_of(q.t0, want.t0), error_of(q.t1, want.t1));
}

static void check_slide(double a, double b, double c, double rounded) {
    const pair want = exact_roots(a, b, c);
    given_quadratic(a, b, c);
    CHECK_INT(solve_quadratic(a, b, c).count, 2);
    CHECK_REAL(solve_quadratic(a, b, c).t0, (double)want.t0, double_roundings(rounded));
    CHECK_REAL(solve_quadratic(a, b, c).t1, (double)want.t1, double_roundings(rounded));
}

static void slide_quadratic(void) {
    rng g = rng_seed(4, 3);
    check_slide(2, -12, 10, 4); // 1 and 5
    for (int i = 0; i < 2000;
         i++) { // c of the other sign: the roots differ in sign, no cancellation
        const double a = of_size(&g, 0), b = of_size(&g, 0), c = copysign(of_size(&g, 0), -a);
        check_slide(a, b, c, 64);
    }
    given("a = 0, b = 4, c = -6: a line");
    CHECK_INT(solve_quadratic(0, 4, -6).count, 1);
    CHECK_REAL(solve_quadratic(0, 4, -6).t0, 1.5, exactly());
    CHECK_INT(solve_quadratic(0, 0, -6).count, 0);
}

static void quadratic_by_hand(void) {
    check_stable(2, -12, 10);
    check_stable(-2, 12, -10);
    check_stable(3, 1, -10);
    check_stable(1, 2, 3);
}

static void quadratic_generic(void) {
    enum { N = 20000 };
    static double error[N];
    rng g = rng_seed(4, 4);
    for (int i = 0; i < N; i++) {
        const double a = of_size(&g, 0), b = of_size(&g, 0), c = of_size(&g, -1);
        error[i] = check_stable(a, b, c);
    }
    given("20000 quadratics with coefficients between 0.1 and 2");
    CHECK_AT_MOST(quantile(error, N, 0.99), 3e-16, "99 of 100 within 1.5 steps of a double");
}

static void quadratic_cancels(void) {
    rng g = rng_seed(4, 5);
    for (int k = 1; k <= 30; k++)
        for (int i = 0; i < 100; i++) {
            const double a = of_size(&g, 0), b = of_size(&g, 0), c = of_size(&g, -k);
            check_stable(a, b, c);
            check_stable(c, b, a);
        }
}

// b a few steps from 2 sqrt(ac): b² and 4ac agree in all the digits that a double keeps.
static void quadratic_nearly_double(void) {
    rng g = rng_seed(4, 6);
    int none = 0;
    for (int i = 0; i < 20000; i++) {
        const double a = fabs(of_size(&g, 0)), c = fabs(of_size(&g, 0));
        const double b = 2 * sqrt(a * c) * (1 + ((int)(rng_bits(&g) % 7) - 3) * DBL_EPSILON);
        none += discriminant_of(a, b, c) < 0;
        check_stable(a, b, c);
    }
    CHECK(none > 4000 && none < 16000, "the test itself: both kinds occur");
    for (int i = 1; i < 1000; i++) { // (m t - n)² = 0
        const double m = 3 * i, n = 1000 - i;
        const double a = m * m, b = -2 * m * n, c = n * n;
        check_stable(a, b, c);
        given("a = %.17g, b = %.17g, c = %.17g: a double root is two equal ones", a, b, c);
        CHECK_REAL(stable_quadratic(a, b, c).t1, stable_quadratic(a, b, c).t0, exactly());
    }
}

static void quadratic_sizes(void) {
    rng g = rng_seed(4, 7);
    for (int i = 0; i < 20000; i++) {
        const double ka = 294 * rng_double(&g) - 145, kb = 294 * rng_double(&g) - 145;
        const double kc = 294 * rng_double(&g) - 145; // at most 2e149
        const double a = of_size(&g, ka), b = of_size(&g, kb), c = of_size(&g, kc);
        check_stable(a, b, c);
    }
    for (int k = -145; k <= 149; k += 7)
        for (int i = 0; i < 100; i++) { // all of one size: neither term can be neglected
            const double a = of_size(&g, k), b = of_size(&g, k), c = of_size(&g, k);
            check_stable(a, b, c);
        }
}

static void quadratic_zeros(void) {
    given("a = 0, b = 4, c = -6: a line, with one root");
    CHECK_INT(stable_quadratic(0, 4, -6).count, 1);
    CHECK_REAL(stable_quadratic(0, 4, -6).t0, 1.5, exactly());
    CHECK_REAL(stable_quadratic(0, 4, -6).t1, 1.5, exactly());
    given("a = 0, b = 0: no root, or every t");
    CHECK_INT(stable_quadratic(0, 0, -6).count, 0);
    CHECK_INT(stable_quadratic(0, 0, 0).count, 0);
    check_stable(2, -3, 0);
    check_stable(2, 3, 0);
    check_stable(-2, 3, 0);
    check_stable(2, 0, -18);
    check_stable(-2, 0, 18);
    check_stable(7, 0, 0);
    check_stable(2, 0, 18); // no root
    const double nan = (double)NAN;
    given("a discriminant that is NaN");
    CHECK_INT(stable_quadratic(1, nan, 1).count, 0);
    CHECK_INT(stable_quadratic(nan, 3, 1).count, 0);
    CHECK_INT(stable_quadratic(1, 3, nan).count, 0);
}

// ---- spheres: the reference ----------------------------------------------------------

typedef struct {
    exact quarter;    // (b² - 4ac) / 4
    exact t0, t1;     // t0 <= t1, when quarter >= 0
    double sensitive; // what a rounding inside is magnified by in t
} solution;

static solution meet(sphere S, ray r) {
    const exact3 v = exact_sub(r.O, S.c), d = exact_of(r.d);
    const exact a = exact_dot(d, d), half_b = exact_dot(v, d), vv = exact_dot(v, v);
    const exact rr = (exact)S.r * S.r, c = vv - rr;
    solution s = {.quarter = half_b * half_b - a * c};
    if (s.quarter < 0) return s;
    const exact root = exact_sqrt(s.quarter), q = half_b > 0 ? -half_b - root : -half_b + root;
    const exact x = q / a, y = q == 0 ? x : c / q;
    s.t0 = x < y ? x : y;
    s.t1 = x < y ? y : x;
    // c cancels near the surface; the half chord h loses near the rim; both are divided by
    // or added to q. With all of them as lengths:
    const double V = sqrt((double)vv), R = S.r, A = sqrt((double)a);
    const double h = (double)root / A, Q = fabs((double)q) / A;
    s.sensitive = (V * V + R * R) / fabs((double)c) + (4 * V * R + R * R) / (h * Q) + 3 * V / Q;
    return s;
}

static exact nearest(solution s, real t_min) {
    if (s.quarter < 0) return NO_HIT;
    return s.t0 > t_min ? s.t0 : s.t1 > t_min ? s.t1 : (exact)NO_HIT;
}

// One rounding out, and what double inside loses: nothing to speak of in a build with float.
static allowance of_t(solution s) {
    return relative_to((double)REAL_EPSILON / 2 + 8 * u64 * (1 + s.sensitive),
                       "double inside, 8u(1 + condition), one rounding out");
}

static double check_sphere(sphere S, ray r) {
    const solution s = meet(S, r);
    const exact want = nearest(s, 0);
    given_sphere(S, r);
    if (s.quarter >= 0) {
        suspect_value("the other root", (double)(want == s.t0 ? s.t1 : s.t0));
        suspect_value("the distance, not t: t counts in |d|",
                      (double)want * (double)length(r.d));
    }
    CHECK_REAL(sphere_hit(S, r, 0, NO_HIT), (double)want, of_t(s));
    return want == NO_HIT ? 0 : error_of(sphere_hit(S, r, 0, NO_HIT), want);
}

// A sphere within `offset` of the origin; the eye `reach` radii from its centre; the ray
// aimed at a ball 1.25 times as large, |d| about `speed`.
static void generic(rng *g, real radius, real offset, real reach, real speed, sphere *S,
                    ray *r) {
    S->c = scale(offset, in_cube(g));
    S->r = radius * ((real)0.5 + rng_real(g));
    r->O = add(S->c, scale(reach * S->r, normalize(in_ball(g))));
    const vec3 target = add(S->c, scale((real)1.25 * S->r, in_ball(g))), d = sub(target, r->O);
    r->d = scale(speed * ((real)0.5 + rng_real(g)) / length(d), d);
}

// ---- sphere_hit ----------------------------------------------------------------------

static void sphere_by_hand(void) {
    // v = (1, 2, 6), d = (0, -1, -3): a = 10, b = -40, c = 41 - 9 = 32:
    // 10 t² - 40 t + 32 = 0, t = 2 ± sqrt(0.8).
    const sphere S = {{1, 2, -6}, 3};
    const ray r = {{2, 4, 0}, {0, -1, -3}};
    given_sphere(S, r);
    suspect_value("the larger root", 2 + sqrt(0.8));
    CHECK_REAL(sphere_hit(S, r, 0, NO_HIT), 2 - sqrt(0.8), roundings(2, "one rounding out"));
    CHECK_REAL(sphere_hit(S, r, 2, NO_HIT), 2 + sqrt(0.8), roundings(2, "one rounding out"));
    CHECK_REAL(sphere_hit(S, r, 0, 1), NO_HIT, exactly());
    CHECK_REAL(sphere_hit(S, r, 3, NO_HIT), NO_HIT, exactly());
}

static void sphere_generic(void) {
    enum { N = 20000 };
    static double error[N];
    rng g = rng_seed(4, 8);
    for (int i = 0; i < N; i++) {
        sphere S;
        ray r;
        generic(&g, 1, 10, 2 + 8 * rng_real(&g), 1, &S, &r);
        error[i] = check_sphere(S, r);
    }
    given("20000 spheres, 1 to 9 radii away");
    CHECK_AT_MOST(quantile(error, N, 0.99), sizeof(real) == 4 ? 6e-8 : 5e-16,
                  "99 of 100 within half a step of a float, or 2.5 of a double");
}

static void sphere_inside(void) {
    rng g = rng_seed(4, 9);
    for (int i = 0; i < 5000; i++) {
        sphere S;
        ray r;
        generic(&g, 3, 10, (real)0.99 * rng_real(&g), 1, &S, &r);
        check_sphere(S, r);
        CHECK(sphere_hit(S, r, 0, NO_HIT) != NO_HIT, "from inside every ray hits");
    }
    const sphere S = {{1, -2, 3}, 5};
    given("O = c: from the centre, t |d| = r");
    CHECK_REAL(sphere_hit(S, (ray){{1, -2, 3}, {2, -1, 2}}, 0, NO_HIT), 5 / 3.0,
               roundings(2, "one rounding out"));
}

// The decision hit or miss, and t, as far as 10^6 radii: every ray, none too close to call
// in a build with float. A build with double may err where |discriminant| is its noise.
static void sphere_far(void) {
    rng g = rng_seed(4, 10);
    for (int k = 0; k <= 6; k++)
        for (int i = 0; i < (k < 6 ? 10000 : 60000); i++) { // mistakes are rare, but for 10^6
            sphere S;
            ray r;
            generic(&g, 1, 1, 1 + (real)pow(10, k), 1, &S, &r);
            const exact noise = (exact)(64 * u64 * pow(10, k)) * S.r * S.r;
            const exact quarter = meet(S, r).quarter;
            if (sizeof(real) == 8 && quarter < noise && -quarter < noise) continue;
            check_sphere(S, r);
        }
}

static void sphere_ground(void) {
    rng g = rng_seed(4, 11);
    for (int k = 3; k <= 9; k += 3)
        for (int i = 0; i < 5000; i++) {
            const sphere S = {{0, -(real)pow(10, k), 0}, (real)pow(10, k)};
            vec3 d = in_ball(&g);
            d.y = -fabs(d.y) - (real)0.1;
            check_sphere(S, (ray){{rng_real(&g), 1, (real)0.25}, d});
        }
}

static void sphere_speed(void) {
    rng g = rng_seed(4, 12);
    const int top = sizeof(real) == 4 ? 20 : 145; // |d|² must fit a double
    for (int k = -top; k <= top; k += top / 5)
        for (int i = 0; i < 1000; i++) {
            sphere S;
            ray r;
            generic(&g, 1, 10, 5, (real)pow(10, k), &S, &r);
            check_sphere(S, r);
        }
}

static void sphere_size(void) {
    rng g = rng_seed(4, 13);
    for (int k = -6; k <= 9; k++)
        for (int i = 0; i < 1000; i++) {
            sphere S;
            ray r;
            const real size = (real)pow(10, k);
            generic(&g, size, 10 * size, 5, 1, &S, &r);
            check_sphere(S, r);
        }
}

static void sphere_near_surface(void) {
    rng g = rng_seed(4, 14);
    for (int k = -6; k <= -1; k++)
        for (int i = 0; i < 2000; i++) {
            sphere S;
            ray r;
            generic(&g, 1, 0, 1 + (real)pow(10, k), 1, &S, &r);
            check_sphere(S, r);
        }
    given(
        "O on the sphere, exactly: c = 0, r = 7, O = (2, 3, 6), inwards: t = 0 is not above 0");
    const sphere S = {{0, 0, 0}, 7};
    const ray inwards = {{2, 3, 6}, {-1, -2, -3}}; // t = 2 · 26 / 14
    CHECK_REAL(sphere_hit(S, inwards, 0, NO_HIT), 26 / 7.0, roundings(2, "one rounding out"));
    given("the same point, outwards");
    CHECK_REAL(sphere_hit(S, (ray){{2, 3, 6}, {1, 2, 3}}, 0, NO_HIT), NO_HIT, exactly());
}

// l = (2, 1, -2) is perpendicular to d = (1, 2, 2) and as long as the radius, 3.
static void sphere_tangent(void) {
    rng g = rng_seed(4, 15);
    for (int i = 0; i < 200; i++) {
        const real t = (real)(1 + rng_bits(&g) % 1000), speed = (real)(1 << rng_bits(&g) % 8);
        const vec3 c = {(real)(rng_bits(&g) % 100), -7, 11}, d = {1, 2, 2}, l = {2, 1, -2};
        const sphere S = {c, 3};
        const ray r = {sub(add(c, l), scale(t, d)), scale(speed, d)};
        given_sphere(S, r);
        CHECK_REAL(sphere_hit(S, r, 0, NO_HIT), t / speed, roundings(2, "one rounding out"));
    }
}

static void sphere_nothing(void) {
    const ray r = {{1, 2, 9}, {0, 0, -2}};
    given("radius 0, and a ray through the centre");
    CHECK_REAL(sphere_hit((sphere){{1, 2, 3}, 0}, r, 0, NO_HIT), NO_HIT, exactly());
    CHECK_REAL(sphere_hit_slide((sphere){{1, 2, 3}, 0}, r, 0, NO_HIT), NO_HIT, exactly());
    given("a negative radius");
    CHECK_REAL(sphere_hit((sphere){{1, 2, 3}, -1}, r, 0, NO_HIT), NO_HIT, exactly());
    given("d = 0, outside and inside");
    CHECK_REAL(sphere_hit((sphere){{1, 2, 3}, 1}, (ray){{4, 5, 6}, {0, 0, 0}}, 0, NO_HIT),
               NO_HIT, exactly());
    CHECK_REAL(sphere_hit((sphere){{4, 5, 6}, 1}, (ray){{4, 5, 6}, {0, 0, 0}}, 0, NO_HIT),
               NO_HIT, exactly());
    given("a direction that is not a number");
    CHECK_REAL(
        sphere_hit((sphere){{1, 2, 3}, 1}, (ray){{1, 2, 9}, {0, (real)NAN, -2}}, 0, NO_HIT),
        NO_HIT, exactly());
}

// Turned by 3-4-5 about z, shifted, scaled: t must follow.
static vec3 turned(vec3 a) {
    return (vec3){(real)0.6 * a.x - (real)0.8 * a.y, (real)0.8 * a.x + (real)0.6 * a.y, a.z};
}

static void sphere_moved(void) {
    rng g = rng_seed(4, 16);
    for (int i = 0; i < 2000; i++) {
        sphere S;
        ray r;
        generic(&g, 1, 4, 3, 1, &S, &r);
        const solution s = meet(S, r);
        if (s.quarter < (exact)0.01 * S.r * S.r)
            continue; // at the rim a rounded position decides
        const real t = sphere_hit(S, r, 0, NO_HIT);
        given_sphere(S, r);
        const sphere doubled = {scale(8, S.c), 8 * S.r};
        CHECK_REAL(sphere_hit(doubled, (ray){scale(8, r.O), r.d}, 0, NO_HIT), 8 * t, exactly());
        CHECK_REAL(sphere_hit(S, (ray){r.O, scale(16, r.d)}, 0, NO_HIT), t / 16, exactly());
        const sphere permuted = {{S.c.z, S.c.x, S.c.y}, S.r};
        const ray follows = {{r.O.z, r.O.x, r.O.y}, {r.d.z, r.d.x, r.d.y}};
        CHECK_REAL(sphere_hit(permuted, follows, 0, NO_HIT), t, of_t(s));
        const double close = 1000 * (double)REAL_EPSILON; // the moved data are rounded
        const vec3 shift = {(real)3.7, (real)-1.9, (real)2.3};
        CHECK_REAL(
            sphere_hit((sphere){add(S.c, shift), S.r}, (ray){add(r.O, shift), r.d}, 0, NO_HIT),
            t, relative_to(close, "the shifted data are rounded"));
        CHECK_REAL(
            sphere_hit((sphere){turned(S.c), S.r}, (ray){turned(r.O), turned(r.d)}, 0, NO_HIT),
            t, relative_to(close, "the turned data are rounded"));
    }
}

// The slide's formula is right where its terms do not cancel.
static void slide_nearby(void) {
    rng g = rng_seed(4, 17);
    for (int i = 0; i < 5000; i++) {
        sphere S;
        ray r;
        generic(&g, 1, 2, 2, 1, &S, &r);
        const solution s = meet(S, r);
        if (s.quarter < (exact)0.01 * S.r * S.r && -s.quarter < (exact)0.01 * S.r * S.r)
            continue;
        given_sphere(S, r);
        CHECK_REAL(
            sphere_hit_slide(S, r, 0, NO_HIT), (double)nearest(s, 0),
            relative_to(8 * (double)REAL_EPSILON * (1 + s.sensitive), "16u(1 + condition)"));
    }
}

// ---- sphere_surface --------------------------------------------------------------------

static void check_surface(sphere S, ray r) {
    const real t = sphere_hit(S, r, 0, NO_HIT);
    if (t == NO_HIT) return;
    const hit h = sphere_surface(S, r, t);
    const exact p[] = {h.p.x, h.p.y, h.p.z}, e[] = {h.error.x, h.error.y, h.error.z};
    const exact c[] = {S.c.x, S.c.y, S.c.z};
    exact near2 = 0, far2 = 0; // from c to the nearest and farthest point of the box p ± error
    for (int i = 0; i < 3; i++) {
        const exact off = p[i] < c[i] ? c[i] - p[i] : p[i] - c[i];
        const exact near = off > e[i] ? off - e[i] : 0, far = off + e[i];
        near2 += near * near;
        far2 += far * far;
    }
    const exact rr = (exact)S.r * S.r;
    given_sphere(S, r);
    CHECK(near2 <= rr && rr <= far2, "the box p ± error reaches the sphere");
    const double step = (double)REAL_EPSILON * (double)length(h.p);
    const double inside = 16 * DBL_EPSILON * ((double)length(S.c) + (double)S.r);
    CHECK_AT_MOST(
        length(h.error), 1.5 * step + inside,
        "a rounding or two of p itself: the size of c and r, and the way from O do not "
        "matter");
    CHECK_REAL(length(h.n), 1, roundings(6, "a unit vector, rounded"));
    CHECK_BOOL(h.front, dot(r.d, h.n) < 0);
    CHECK_REAL(h.t, t, exactly());
}

static void surface_error(void) {
    rng g = rng_seed(4, 18);
    for (int k = -6; k <= 9; k++) // the size, and the distance of the eye
        for (int far = 0; far <= 9; far += 3)
            for (int i = 0; i < 200; i++) {
                sphere S;
                ray r;
                const real size = (real)pow(10, k);
                generic(&g, size, 10 * size, 1 + (real)pow(10, far), 1, &S, &r);
                check_surface(S, r);
            }
    for (int i = 0; i < 2000; i++) { // a small sphere far from the origin; from inside
        sphere S;
        ray r;
        generic(&g, (real)1e-6, 1000, 3, 1, &S, &r);
        check_surface(S, r);
        generic(&g, 1, 10, rng_real(&g), 1, &S, &r);
        check_surface(S, r);
    }
    for (int k = 0; k <= 9; k += 3)
        for (int i = 0; i < 1000; i++) {
            const sphere S = {{0, -(real)pow(10, k), 0}, (real)pow(10, k)};
            vec3 d = in_ball(&g);
            d.y = -fabs(d.y) - (real)0.1;
            check_surface(S, (ray){{rng_real(&g), 1, (real)0.25}, d});
        }
}

// Variants with rounding errors report hits just outside: the rim is what they get.
static void surface_outside(void) {
    const sphere S = {{1, -2, 3}, 2};
    const ray r = {{(real)3.001, -2, 9}, {0, 0, -2}};
    given_sphere(S, r);
    const hit h = sphere_surface(S, r, 3);
    CHECK_VEC3(h.n, ((vec3){1, 0, 0}), roundings(4, "one rounding out"));
    CHECK_VEC3(h.p, ((vec3){3, -2, 3}), roundings(4, "one rounding out"));
}

// n against (O + t d - c) / r with the exact t.
static void surface_normal(void) {
    rng g = rng_seed(4, 19);
    for (int k = 0; k <= 6; k++)
        for (int i = 0; i < 1000; i++) {
            sphere S;
            ray r;
            const bool inside = k == 0;
            const real reach = inside ? (real)0.9 * rng_real(&g) : 1 + (real)pow(10, k);
            generic(&g, 1, 1, reach, 1, &S, &r);
            const solution s = meet(S, r);
            const exact a = exact_dot(exact_of(r.d), exact_of(r.d));
            if (s.quarter < (exact)0.01 * a * S.r * S.r)
                continue; // at the rim n is ill-conditioned
            const exact3 n =
                exact_along(exact_sub(r.O, S.c), inside ? s.t1 : s.t0, exact_of(r.d));
            const vec3 want = {(real)(n.x / S.r), (real)(n.y / S.r), (real)(n.z / S.r)};
            const hit h = sphere_surface(S, r, sphere_hit(S, r, 0, NO_HIT));
            given_sphere(S, r);
            CHECK_VEC3(h.n, want,
                       relative_to(2 * (double)REAL_EPSILON + 200 * u64 * pow(10, k),
                                   "double inside, rounded once"));
            CHECK_BOOL(h.front, !inside);
        }
}

// ---- far_discriminant ---------------------------------------------------------------

static void far_by_hand(void) {
    const sphere S = {{1, 2, -6}, 3}; // as sphere_by_hand: (40² - 4·10·32) / 4 = 80
    const ray r = {{2, 4, 0}, {0, -1, -3}};
    given_sphere(S, r);
    suspect_value("b² - 4ac itself: a quarter of it is asked for", 320);
    suspect_value("r² - l² without the factor a = d·d", 8);
    suspect_value("a remainder that takes d for a unit vector", 10 * (9.0 - 3241));
    suspect_value("(r² - l²) / a in place of a (r² - l²)", 0.8);
    suspect_value("-a (r² - l²): positive must mean a hit", -80);
    CHECK_REAL(far_discriminant(S, r), 80, roundings(16, "small whole numbers"));
}

// |v - (v·d/a) d| is off by a few roundings of |v|; its square by that times 2 |l|.
static void far_generic(void) {
    rng g = rng_seed(4, 20);
    for (int k = 0; k <= 5; k++)
        for (int i = 0; i < 2000; i++) {
            sphere S;
            ray r;
            generic(&g, 1, 1, 1 + (real)pow(10, k), 2, &S, &r);
            const exact want = meet(S, r).quarter;
            const double a = dot(r.d, r.d), rr = (double)S.r * (double)S.r;
            const double l = sqrt(fmax(rr - (double)want / a, 0));
            const double slip = 8 * (double)REAL_EPSILON / 2 * (double)length(sub(r.O, S.c));
            given_sphere(S, r);
            suspect_value("b² - 4ac itself: a quarter of it is asked for", 4 * (double)want);
            suspect_value("r² - l² without the factor a = d·d", (double)want / a);
            suspect_value("minus the discriminant", -(double)want);
            CHECK_REAL(
                far_discriminant(S, r), (double)want,
                absolute_of(a * (2 * l * slip + slip * slip + 8 * (double)REAL_EPSILON * rr),
                            "a remainder within 8 roundings of |v|"));
        }
}

static void check_wrong_decisions(int k, double share) {
    enum { N = 100000 };
    rng g = rng_seed(4, 21);
    int wrong = 0;
    for (int i = 0; i < N; i++) {
        sphere S;
        ray r;
        generic(&g, 1, 1, (real)pow(10, k), 1, &S, &r);
        wrong += (far_discriminant(S, r) >= 0) != (meet(S, r).quarter >= 0);
    }
    const double relative = (double)REAL_EPSILON / (double)FLT_EPSILON; // 1 for float
    given("100000 rays aimed at spheres 10^%d radii away, one in five of them past", k);
    CHECK_AT_MOST(wrong, N * share * relative + 5 * sqrt(N * share * relative),
                  "rounding l decides wrongly only at the very rim; 5 standard errors above "
                  "what is usual, exceeded by chance once in a million");
}

static void far_decisions(void) {
    check_wrong_decisions(3, 2e-5);
    check_wrong_decisions(4, 2.6e-4);
    check_wrong_decisions(6, 2.2e-2);
}

static void far_speed(void) {
    rng g = rng_seed(4, 22);
    for (int k = -12; k <= 12; k += 4)
        for (int i = 0; i < 200; i++) {
            sphere S;
            ray r;
            generic(&g, 1, 1, 5, (real)pow(10, k), &S, &r);
            const exact want = meet(S, r).quarter;
            const double a = dot(r.d, r.d), rr = (double)S.r * (double)S.r;
            given_sphere(S, r);
            suspect_value("r² - l² without the factor a = d·d", (double)want / a);
            CHECK_REAL(
                far_discriminant(S, r), (double)want,
                absolute_of(a * 200 * (double)REAL_EPSILON * rr, "roundings of 5 radii"));
        }
}

// ---- cylinder_hit --------------------------------------------------------------------

typedef struct {
    exact t[2], along[2]; // along: 0 at a, 1 at b
    exact share;          // quarter of the discriminant over that of a ray through the axis
    double sensitive;     // what a rounding inside is magnified by in t
} tube_solution;

// By projection onto the plane perpendicular to the axis. Not for parallel rays.
static tube_solution meet_tube(cylinder C, ray r) {
    const exact3 u = exact_sub(C.b, C.a), v = exact_sub(r.O, C.a), d = exact_of(r.d);
    const exact uu = exact_dot(u, u), vu = exact_dot(v, u) / uu, du = exact_dot(d, u) / uu;
    const exact3 flat_v = exact_along(v, -vu, u), flat_d = exact_along(d, -du, u);
    const exact a = exact_dot(flat_d, flat_d), half_b = exact_dot(flat_v, flat_d);
    const exact vv = exact_dot(flat_v, flat_v), rr = (exact)C.r * C.r, c = vv - rr;
    const exact quarter = half_b * half_b - a * c;
    tube_solution s = {.share = quarter / (a * rr)};
    if (quarter < 0) return s;
    const exact root = exact_sqrt(quarter), q = half_b > 0 ? -half_b - root : -half_b + root;
    const exact x = q / a, y = c / q;
    s.t[0] = x < y ? x : y;
    s.t[1] = x < y ? y : x;
    for (int i = 0; i < 2; i++) s.along[i] = vu + s.t[i] * du;
    const double V = sqrt((double)exact_dot(v, v)), R = C.r, A = sqrt((double)a);
    const double h = (double)root / A, Q = fabs((double)q) / A;
    const double slant = sqrt((double)exact_dot(d, d)) / A; // 1 / the sine of ray and axis
    // V²: of a discriminant by subtraction too, which is good enough in double.
    s.sensitive =
        slant * ((V * V + R * R) / fabs((double)c) + (V * V + R * R) / (h * Q) + 3 * V / Q);
    return s;
}

// Is a decision of this ray too close to call?
static bool close_call(tube_solution s) {
    const exact margin = 1e-6;
    if (s.share < margin) return s.share > -margin;
    for (int i = 0; i < 2; i++)
        for (int end = 0; end < 2; end++)
            if (s.along[i] > end - margin && s.along[i] < end + margin) return true;
    return false;
}

static void check_tube(cylinder C, ray r) {
    const tube_solution s = meet_tube(C, r);
    if (close_call(s)) return;
    exact want = NO_HIT;
    given_cylinder(C, r);
    for (int i = 1; i >= 0 && s.share >= 0; i--) {
        const bool between = s.along[i] >= 0 && s.along[i] <= 1;
        if (s.t[i] > 0 && between) want = s.t[i];
        if (s.t[i] > 0 && !between)
            suspect_value("a point beyond the ends of the tube", (double)s.t[i]);
    }
    if (want == s.t[0]) suspect_value("the farther root", (double)s.t[1]);
    CHECK_REAL(cylinder_hit(C, r, 0, NO_HIT), (double)want,
               relative_to((double)REAL_EPSILON / 2 + 32 * u64 * (1 + s.sensitive),
                           "double inside, one rounding out"));
}

// A tube about 2 long; the eye `reach` away; rays aimed at points about the tube.
static void generic_tube(rng *g, real reach, cylinder *C, ray *r) {
    C->a = scale(3, in_cube(g));
    C->b = add(C->a, scale(2, in_cube(g)));
    C->r = (real)0.1 + rng_real(g);
    r->O = add(C->a, scale(reach, in_cube(g)));
    const vec3 inside = add(lerp(C->a, C->b, rng_real(g)), scale(C->r, in_cube(g)));
    r->d = scale((real)0.5 + rng_real(g), sub(inside, r->O));
}

static void tube_by_hand(void) {
    // Axis along z from (1, 2, 0) to (1, 2, 8), r = 5. In the x, y plane from (-9, 2) along
    // (2, 1.5): v = (-10, 0), 6.25 t² - 40 t + 75 = 0: t = 3.2 ± sqrt(10.24 - 12) < 0: a miss;
    // along (2, 0): (2t - 10)² = 25: t = 2.5 and 7.5.
    const cylinder C = {{1, 2, 0}, {1, 2, 8}, 5};
    given_cylinder(C, (ray){{-9, 2, 4}, {2, 1.5f, 0}});
    CHECK_REAL(cylinder_hit(C, (ray){{-9, 2, 4}, {2, 1.5f, 0}}, 0, NO_HIT), NO_HIT, exactly());
    const ray r = {{-9, 2, 4}, {2, 0, -0.25f}};
    given_cylinder(C, r);
    suspect_value("the farther root", 7.5);
    CHECK_REAL(cylinder_hit(C, r, 0, NO_HIT), 2.5, roundings(2, "one rounding out"));
    CHECK_REAL(cylinder_hit(C, r, 3, NO_HIT), 7.5, roundings(2, "one rounding out"));
    CHECK_REAL(cylinder_hit(C, r, 0, 2), NO_HIT, exactly());
    CHECK_REAL(cylinder_hit(C, r, 3, 7), NO_HIT, exactly());
}

static void tube_generic(void) {
    rng g = rng_seed(4, 23);
    int hits = 0;
    for (int i = 0; i < 20000; i++) {
        cylinder C;
        ray r;
        generic_tube(&g, 5, &C, &r);
        check_tube(C, r);
        hits += cylinder_hit(C, r, 0, NO_HIT) != NO_HIT;
        const cylinder swapped = {C.b, C.a, C.r};
        check_tube(swapped, r);
    }
    CHECK(hits > 8000 && hits < 19000, "the test itself: rays that hit and rays that miss");
}

// Through the open end to the wall behind: the nearer root lies beyond the end.
static void tube_from_its_end(void) {
    const cylinder C = {{0, 0, 0}, {0, 0, -8}, 1};
    const ray r = {{-2, 0, 4}, {1, 0, -2}}; // x = ±1 at t = 1 (z = 2) and t = 3 (z = -2)
    given_cylinder(C, r);
    suspect_value("a point beyond the ends of the tube", 1);
    CHECK_REAL(cylinder_hit(C, r, 0, NO_HIT), 3, roundings(2, "one rounding out"));
    CHECK_REAL(cylinder_hit(C, r, 0, 2), NO_HIT, exactly());
    const cylinder shorter = {{0, 0, 0}, {0, 0, -1}, 1};
    given_cylinder(shorter, r);
    suspect_value("a point beyond the ends of the tube", 1);
    CHECK_REAL(cylinder_hit(shorter, r, 0, NO_HIT), NO_HIT, exactly());
    rng g = rng_seed(4, 24);
    for (int i = 0; i < 5000; i++) { // from within
        cylinder D;
        ray inside;
        generic_tube(&g, 0, &D, &inside);
        inside.O = lerp(D.a, D.b, rng_real(&g));
        inside.d = in_cube(&g);
        check_tube(D, inside);
    }
}

static void tube_rims(void) {
    const cylinder C = {{0, 0, 0}, {0, 0, -8}, 1};
    given("a tube from z = 0 to z = -8, r = 1; rays that meet it exactly on its rims");
    CHECK_REAL(cylinder_hit(C, (ray){{-4, 0, 0}, {2, 0, 0}}, 0, NO_HIT), 1.5, exactly());
    CHECK_REAL(cylinder_hit(C, (ray){{-4, 0, -8}, {2, 0, 0}}, 0, NO_HIT), 1.5, exactly());
    given("the same tube, a ray just above it: z = 0.001");
    CHECK_REAL(cylinder_hit(C, (ray){{-4, 0, 0.001f}, {2, 0, 0}}, 0, NO_HIT), NO_HIT,
               exactly());
    given("the same tube, a tangent: y = 1");
    CHECK_REAL(cylinder_hit(C, (ray){{-4, 1, -3}, {2, 0, 0}}, 0, NO_HIT), 2, exactly());
}

static void tube_nothing(void) {
    const cylinder C = {{1, 2, 3}, {2, 4, 7}, 1};
    given("a tube from (1, 2, 3) to (2, 4, 7), r = 1; a ray inside, parallel to the axis");
    CHECK_REAL(cylinder_hit(C, (ray){{1, 2, 1}, {-3, -6, -12}}, 0, NO_HIT), NO_HIT, exactly());
    given("the same tube; a parallel ray outside");
    CHECK_REAL(cylinder_hit(C, (ray){{5, 2, 1}, {3, 6, 12}}, 0, NO_HIT), NO_HIT, exactly());
    given("the same tube, d = 0");
    CHECK_REAL(cylinder_hit(C, (ray){{1, 2, 3}, {0, 0, 0}}, 0, NO_HIT), NO_HIT, exactly());
    const ray across = {{-4, 3, 5}, {1, 0, 0}};
    given("radius 0, and a ray through the axis");
    CHECK_REAL(cylinder_hit((cylinder){C.a, C.b, 0}, across, 0, NO_HIT), NO_HIT, exactly());
    given("a = b: no axis");
    CHECK_REAL(cylinder_hit((cylinder){C.a, C.a, 1}, across, 0, NO_HIT), NO_HIT, exactly());
    given("a direction that is not a number");
    CHECK_REAL(cylinder_hit(C, (ray){{-4, 3, 5}, {(real)NAN, 0, 0}}, 0, NO_HIT), NO_HIT,
               exactly());
}

static void tube_extremes(void) {
    rng g = rng_seed(4, 25);
    for (int k = 1; k <= 5; k++)
        for (int i = 0; i < 1000; i++) {
            cylinder C;
            ray r;
            generic_tube(&g, (real)pow(10, k), &C, &r); // far away
            check_tube(C, r);
            generic_tube(&g, 2, &C, &r); // nearly parallel to the axis
            const vec3 aside = scale((real)pow(10, -k), in_cube(&g));
            r = (ray){lerp(C.a, C.b, rng_real(&g)), add(sub(C.b, C.a), aside)};
            C.r = scale((real)pow(10, -k), in_cube(&g)).x;
            if (C.r > 0) check_tube(C, r);
            generic_tube(&g, 5, &C, &r); // short and long d
            check_tube(C, (ray){r.O, scale((real)pow(10, 3 * k), r.d)});
            check_tube(C, (ray){r.O, scale((real)pow(10, -3 * k), r.d)});
        }
    for (int i = 0; i < 20000; i++) { // a rounded t misplaces the point by hundredths here
        cylinder C;
        ray r;
        generic_tube(&g, 100000, &C, &r);
        check_tube(C, r);
    }
}

int main(void) {
    static const char *const which = "From outside, from inside, from behind: which root does "
                                     "the eye see? t_min and t_max say which ones count.";
    static const char *const cancels =
        "Digits are lost in two subtractions. -b and the root of almost the same size cancel: "
        "only one sign is safe, and the other root follows from t0 t1 = c/a. b² and 4ac cancel "
        "too: see fma. Smaller root first.";
    static const char *const digits =
        "Both products are rounded before they are subtracted, and near a double root only the "
        "rounding is left. fma(x, y, z) rounds only once: what does fma(-a, c, a c) tell?";
    static const char *const remainder =
        "Do not subtract large numbers: how long is the part of v that is perpendicular to d? "
        "d need not have unit length.";
    static const char *const tube =
        "Look along the axis: what do you see of the tube and of the "
        "ray? Each root has its own point.";
    static const char *const wide =
        "Products of floats cancel here: work in double (common/wide3.h).";
    static const char *const module =
        "sphere_hit only uses nearest_root: test that first (T=nearest_root).";
    static const test tests[] = {
        {"nearest_root: which of the two", which_root, which},
        {"nearest_root: t_min < t < t_max", root_interval,
         "Only roots between t_min and t_max count. Both ends are excluded."},
        {"nearest_root: no root, one, not a number", fewer_roots,
         "count says how many there are; t0 and t1 mean nothing for 0. NaN lies in no "
         "interval: NaN > t_min is false."},
        {"nearest_root: 5000 cases, by search", root_by_search, which},
        {"nearest_root: compared as it is returned", root_rounded,
         "Round the root to real first, then compare: the answer must lie in the interval."},
        {"stable_quadratic: worked out by hand", quadratic_by_hand,
         "Halve b: (b/2)² - ac is a quarter of the discriminant. Smaller root first, also for "
         "a < 0."},
        {"stable_quadratic: 20000 generic ones", quadratic_generic, cancels},
        {"stable_quadratic: b² far above 4ac", quadratic_cancels, cancels},
        {"stable_quadratic: nearly double roots", quadratic_nearly_double, digits},
        {"stable_quadratic: sizes from 1e-145 to 1e150", quadratic_sizes,
         "Smaller root first, whatever the signs. If a root or the count is wrong here only: "
         "which product of yours overflows, which vanishes? No threshold is needed."},
        {"stable_quadratic: zeros and NaN", quadratic_zeros,
         "a = 0 is a line; sign(0) is 1; NaN has no roots, and is not >= 0. When q = 0, both "
         "roots are 0."},
        {"far_discriminant: worked out by hand", far_by_hand, remainder},
        {"far_discriminant: 12000 generic spheres", far_generic, remainder},
        {"far_discriminant: wrong decisions far away", far_decisions, remainder},
        {"far_discriminant: short and long d", far_speed, remainder},
        {"cylinder_hit: worked out by hand", tube_by_hand, tube},
        {"cylinder_hit: 40000 generic tubes", tube_generic, tube},
        {"cylinder_hit: through the open end, and from inside", tube_from_its_end,
         "When the first point lies beyond the end, the second may still lie on the tube."},
        {"cylinder_hit: rims and tangents", tube_rims,
         "The rims belong to the tube, and a tangent is a hit."},
        {"cylinder_hit: parallel, d = 0, r = 0, a = b", tube_nothing,
         "Which coefficient is 0 then, or NaN? Test for exactly 0, so that NaN ends in NO_HIT "
         "too."},
        {"cylinder_hit: far, grazing, short and long d", tube_extremes, wide},
        {"solve_quadratic: the slide's formula", slide_quadratic, "See sphere.c."},
        {"sphere_hit: worked out by hand", sphere_by_hand, module},
        {"sphere_hit: 20000 generic spheres", sphere_generic, module},
        {"sphere_hit: from inside", sphere_inside, module},
        {"sphere_hit: far away", sphere_far, module},
        {"sphere_hit: the ground is a sphere", sphere_ground, module},
        {"sphere_hit: short and long d", sphere_speed, module},
        {"sphere_hit: small and large", sphere_size, module},
        {"sphere_hit: near and on the surface", sphere_near_surface, module},
        {"sphere_hit: a tangent is a hit", sphere_tangent, module},
        {"sphere_hit: nothing to hit", sphere_nothing, module},
        {"sphere_hit: moved, turned, scaled", sphere_moved, module},
        {"sphere_hit_slide: right nearby", slide_nearby, module},
        {"sphere_surface: the error bound holds", surface_error, module},
        {"sphere_surface: the normal", surface_normal, module},
        {"sphere_surface: a ray just outside", surface_outside, module},
    };
    return run_tests("04-sphere", tests, COUNT(tests));
}
