// Tests of 11-fresnel: Snell's law, what glass and metals reflect, absorption, and the
// paths through glass.
#include "chapters/11-fresnel/claims.h"
#include "chapters/11-fresnel/proofs.h"
#include "common/exact3.h"
#include "common/wide3.h"
#include "tests/check-directions.h"
#include "tests/check-generic.h"
#include "tests/check.h"

#include <stdio.h>

static double decades(rng *g, double low, double high) { // 10^low to 10^high
    return pow(10, between(g, low, high));
}

static vec3 combine(double a, vec3 u, double b, vec3 v) {
    return narrow((wide3){a * (double)u.x + b * (double)v.x, a * (double)u.y + b * (double)v.y,
                          a * (double)u.z + b * (double)v.z});
}

// Unit, perpendicular to the unit vector n, turned at random.
static vec3 across(vec3 n, rng *g) {
    const vec3 v = unit_vector(g), w = cross(n, v);
    return dot(w, w) > (real)0.01 ? normalize(w) : across(n, g);
}

// The unit direction that meets a surface at this cosine; `along` is the unit
// direction in the surface.
static vec3 arriving(vec3 n, vec3 along, double cosine) {
    return combine(sqrt((1 - cosine) * (1 + cosine)), along, -cosine, n);
}

static double cosine_of(vec3 d, vec3 n) {
    return -wide_dot(widen(d), widen(n));
}

// ---- the formulas in higher precision ----------------------------------------------

static double square(double x) {
    return x * x;
}

// The slides of every optics course: r_s and r_p by both cosines.
typedef struct {
    double s, p; // r_s², r_p²
} polarised;

static polarised polarised_exact(double cosine, double index) {
    const exact c = cosine, eta = index, cos2 = 1 - (1 - c * c) / (eta * eta);
    if (cos2 <= 0) return (polarised){1, 1};
    const exact t = exact_sqrt(cos2);
    const exact s = (c - eta * t) / (c + eta * t), p = (eta * c - t) / (eta * c + t);
    return (polarised){(double)(s * s), (double)(p * p)};
}

static double fresnel_exact(double cosine, double eta) {
    const polarised r = polarised_exact(cosine, eta);
    return eta == 1 ? 0 : (r.s + r.p) / 2;
}

// d and n taken apart, both brought to length 1: what lies in the surface, P = d + cos θ n.
typedef struct {
    exact3 n, P;
    exact cosine, eta;
} incidence;

static incidence incidence_of(vec3 d, vec3 n, double eta) {
    const exact3 D = exact_of(d), N = exact_of(n), none = {0, 0, 0};
    const exact3 u = exact_along(none, 1 / exact_sqrt(exact_dot(D, D)), D);
    const exact3 v = exact_along(none, 1 / exact_sqrt(exact_dot(N, N)), N);
    const exact cosine = -exact_dot(u, v);
    return (incidence){v, exact_along(u, cosine, v), cosine, eta};
}

static exact far_square(incidence i) { // (eta cos θ_t)²; below 0: total reflection
    return i.eta * i.eta - exact_dot(i.P, i.P);
}

// P / eta - cos θ_t n
static vec3 refracted(vec3 d, vec3 n, double eta) {
    const incidence i = incidence_of(d, n, eta);
    const exact3 t = exact_along(i.P, -exact_sqrt(far_square(i)), i.n);
    return (vec3){(real)(t.x / i.eta), (real)(t.y / i.eta), (real)(t.z / i.eta)};
}

static vec3 mirrored(vec3 d, vec3 n) {
    const incidence i = incidence_of(d, n, 1);
    const exact3 r = exact_along(i.P, i.cosine, i.n);
    return (vec3){(real)r.x, (real)r.y, (real)r.z};
}

static double straight_on(double eta, double k) {
    return (square(eta - 1) + k * k) / (square(eta + 1) + k * k);
}

static double schlick_formula(double cosine, double eta) {
    const double R0 = straight_on(eta, 0);
    return R0 + (1 - R0) * pow(1 - cosine, 5);
}

// The cosine on the far side; 0 on total reflection.
static double far_cosine(double cosine, double eta) {
    const exact n = eta, g2 = (n - 1) * (n + 1) + (exact)cosine * cosine;
    return (double)(exact_sqrt(g2) / n);
}

static double schlick_exact(double cosine, double eta) {
    if (eta == 1) return 0;
    if (eta > 1) return schlick_formula(cosine, eta);
    const double far = far_cosine(cosine, eta);
    return far > 0 ? schlick_formula(far, eta) : 1;
}

// Complex numbers in higher precision.
typedef struct {
    exact re, im;
} complex_exact;

static exact ratio2(complex_exact a, complex_exact b) { // |a / b|²
    return (a.re * a.re + a.im * a.im) / (b.re * b.re + b.im * b.im);
}

static polarised polarised_conductor(double cosine, double index, double k) {
    const exact c = cosine, sin2 = 1 - c * c;
    const complex_exact N2 = {(exact)index * index - (exact)k * k, 2 * (exact)index * k};
    const exact re = N2.re - sin2, size = exact_sqrt(re * re + N2.im * N2.im);
    const complex_exact w = {exact_sqrt((size + re) / 2), exact_sqrt((size - re) / 2)};
    const complex_exact s0 = {c - w.re, -w.im}, s1 = {c + w.re, w.im};
    const complex_exact p0 = {N2.re * c - w.re, N2.im * c - w.im};
    const complex_exact p1 = {N2.re * c + w.re, N2.im * c + w.im};
    return (polarised){(double)ratio2(s0, s1), (double)ratio2(p0, p1)};
}

static double conductor_exact(double cosine, double eta, double k) {
    const polarised r = polarised_conductor(cosine, eta, k);
    return (r.s + r.p) / 2;
}

// ---- refract -----------------------------------------------------------------------

// sin θ = 3/5 and cos θ = 4/5, in a plane that lies askew.
static const vec3 hand_n = {(real)2 / 7, (real)-3 / 7, (real)6 / 7};
static const vec3 hand_along = {(real)6 / 7, (real)-2 / 7, (real)-3 / 7};

static vec3 by_angle(double sine, double sign) {
    return combine(sine, hand_along, -sign * sqrt(1 - sine * sine), hand_n);
}

static void suspect_refractions(vec3 d, double eta, double c) {
    const double sine = sqrt(1 - c * c), g = sqrt(eta * eta - sine * sine);
    const double theta = acos(c) / eta;
    suspect_vec3("d itself: not bent", d);
    suspect_vec3("d mirrored", reflect(d, hand_n));
    if (sine * eta < 1)
        suspect_vec3("eta upside down: sin θ_t = eta sin θ", by_angle(sine * eta, 1));
    suspect_vec3("n on the wrong side, or c + g in place of c - g before it: the light "
                 "comes back out",
                 by_angle(sine / eta, -1));
    suspect_vec3("the angle divided by eta, not its sine", by_angle(sin(theta), 1));
    suspect_vec3("eta t: not divided by eta, so not of unit length",
                 combine(sine, hand_along, -g, hand_n));
    const char *const sign = "c = d·n: the sign is missing, cos θ = -d·n";
    const vec3 turned = combine(1 / eta, d, (-c - g) / eta, hand_n);
    suspect_vec3(sign, turned);
    suspect_vec3(sign, normalize(turned));
    const char *const half = "cos θ in place of cos θ_t: only the part in the surface changed";
    suspect_vec3(half, combine(sine / eta, hand_along, -c, hand_n));
    suspect_vec3(half, normalize(combine(sine / eta, hand_along, -c, hand_n)));
}

static void snell_by_hand(void) {
    const double etas[] = {1.5, 0.8, 2.4, 0.75};
    const vec3 d = by_angle(0.6, 1);
    for (int i = 0; i < COUNT(etas); i++) {
        const double eta = (real)etas[i];
        vec3 t = {0, 0, 0};
        given("d = " VEC ", n = " VEC ", so sin θ = 0.6, cos θ = 0.8; eta = %g", ARG(d),
              ARG(hand_n), eta);
        CHECK_BOOL(refract(d, hand_n, (real)eta, &t), true);
        suspect_refractions(d, eta, 0.8);
        CHECK_VEC3(t, by_angle(0.6 / eta, 1),
                   roundings(16, "d and n are rounded, and out of glass that is magnified"));
    }
}

// What t may be off: its own roundings, and those of d and n, magnified: where g = eta cos θ_t
// is small, a change of g² changes g by that over 2 g.
static double magnified(double c, double eta) {
    const double g = eta * far_cosine(c, eta);
    return REAL_EPSILON * (3 + 5 * (1 + 1 / g) / eta);
}

// A surface, a direction and an index.
typedef struct {
    vec3 n, along, d;
    double c, eta;
} setting;

static setting setting_at(double c, double eta, rng *g) {
    const vec3 n = unit_vector(g), along = across(n, g);
    const vec3 d = arriving(n, along, c);
    return (setting){n, along, d, cosine_of(d, n), (double)(real)eta};
}

// Of a length 1, where refract may not have normalized.
static allowance out_of_glass(double count, double eta) {
    return roundings(count + ceil(8 / eta),
                     "a unit vector; out of glass roundings are magnified");
}

static double some_cosine(rng *g) {
    return rng_bits(g) & 1 ? between(g, 0.001, 1) : decades(g, -6, 0);
}

static void snell_generic(void) {
    rng g = check_rng(1);
    for (int i = 0; i < 20000; i++) {
        const setting k = setting_at(some_cosine(&g), exp(between(&g, -1.4, 1.4)), &g);
        if (!(k.c > 0 && far_cosine(k.c, k.eta) > 0.01)) continue;
        const double fair = magnified(k.c, k.eta);
        const double sine = wide_length(cross(k.n, k.d));
        vec3 t = {0, 0, 0};
        given("d = " VEC ", n = " VEC ", eta = %.9g; cos θ = %.6g", ARG(k.d), ARG(k.n), k.eta,
              k.c);
        CHECK_BOOL(refract(k.d, k.n, (real)k.eta, &t), true);
        CHECK_REAL(wide_length(t), 1, out_of_glass(12, k.eta));
        const double t_out_of_the_plane =
            wide_dot(widen(t), wide_cross(widen(k.n), widen(k.along)));
        CHECK_REAL(t_out_of_the_plane, 0,
                   absolute_of(fair, "t lies in the plane of d and n, but for rounding"));
        const bool behind = wide_dot(widen(t), widen(k.n)) < 0;
        CHECK(behind, "t goes on behind the surface: t·n < 0");
        suspect_factor("eta upside down: sin θ_t = eta sin θ", k.eta * k.eta);
        suspect_factor("not bent", k.eta);
        const double t_along_the_surface = wide_dot(widen(t), widen(k.along));
        CHECK_REAL(t_along_the_surface, sine / k.eta,
                   absolute_of(fair, "sin θ_t = sin θ / eta; d and n are rounded"));
        CHECK_VEC3(t, refracted(k.d, k.n, k.eta), absolute_of(fair, "d and n are rounded"));
    }
}

static void check_total(setting k, double off) {
    const vec3 before = {7, 8, 9};
    vec3 t = before;
    given("d = " VEC ", n = " VEC ", eta = %.9g; %.2g radians beyond the critical angle",
          ARG(k.d), ARG(k.n), k.eta, off);
    const bool through = refract(k.d, k.n, (real)k.eta, &t);
    const bool t_is_a_number = !through || !isnan(t.x + t.y + t.z);
    CHECK(t_is_a_number,
          "no NaN: there is no root of a negative number, that is total reflection");
    const bool returned_false = !through;
    CHECK(returned_false, "false: nothing goes through, since sin θ / eta is above 1");
    const bool t_as_before = t.x == before.x && t.y == before.y && t.z == before.z;
    CHECK(t_as_before, "false must leave *t alone; it was (7, 8, 9) before");
}

// A surface that is met so much, in radians, beyond the critical angle; within it when
// `off` is negative. Certainly so, whatever the roundings of d and n: else eta is 0.
static setting near_critical(double eta, double off, rng *g) {
    setting k = setting_at(cos(asin(eta) + off), eta, g);
    const double g2 = (double)far_square(incidence_of(k.d, k.n, eta));
    if (!(off > 0 ? g2 < -6 * REAL_EPSILON : g2 > 6 * REAL_EPSILON)) k.eta = 0;
    return k;
}

static void check_not_total(setting k, double off) {
    vec3 t = {0, 0, 0};
    given("d = " VEC ", n = " VEC ", eta = %.9g; %.2g radians within the critical angle",
          ARG(k.d), ARG(k.n), k.eta, off);
    const bool returned_true = refract(k.d, k.n, (real)k.eta, &t);
    CHECK(returned_true, "true: some light goes through");
    const double g = sqrt((double)far_square(incidence_of(k.d, k.n, k.eta)));
    CHECK_VEC3(t, refracted(k.d, k.n, k.eta),
               absolute_of(REAL_EPSILON * (3 + 5 * (1 + 1 / g) / k.eta),
                           "the roundings of d and n, magnified by the root"));
}

// Radians off the critical angle.
static const double apart[] = {8.4 * REAL_EPSILON, 1e-5, 1e-3, 0.03, 0.1};

static void total_reflection(void) {
    rng g = check_rng(2);
    for (int i = 0; i < 4000; i++) {
        const double eta = (real)between(&g, 0.3, 0.9), off = apart[i % COUNT(apart)];
        const setting k = near_critical(eta, off, &g);
        if (k.eta > 0) check_total(k, off);
    }
}

static void nearly_total(void) {
    rng g = check_rng(19);
    for (int i = 0; i < 4000; i++) {
        const double eta = (real)between(&g, 0.3, 0.9), off = apart[i % COUNT(apart)];
        const setting k = near_critical(eta, -off, &g);
        if (k.eta > 0) check_not_total(k, off);
    }
}

static void refract_back(void) {
    rng g = check_rng(3);
    for (int i = 0; i < 5000; i++) {
        const setting k = setting_at(between(&g, 0.02, 1), exp(between(&g, -1.4, 1.4)), &g);
        if (!(far_cosine(k.c, k.eta) > 0.02)) continue;
        vec3 t = {0, 0, 0}, back = {0, 0, 0};
        given("d = " VEC ", n = " VEC ", eta = %.9g: in, and the same way back with -t, -n, "
              "1/eta",
              ARG(k.d), ARG(k.n), k.eta);
        CHECK_BOOL(refract(k.d, k.n, (real)k.eta, &t), true);
        CHECK_BOOL(refract(neg(t), neg(k.n), (real)(1 / k.eta), &back), true);
        const double far = far_cosine(k.c, k.eta);
        const double there = magnified(k.c, k.eta), here = magnified(far, 1 / k.eta);
        CHECK_VEC3(
            back, neg(k.d),
            absolute_of((1 + there / REAL_EPSILON) * here,
                        "the roundings of both ways, the first magnified by the second"));
    }
}

// Down to a ray along the surface.
static void same_index(void) {
    rng g = check_rng(4);
    for (int i = 0; i < 2000; i++) {
        const double c = i % 10 ? some_cosine(&g) : 0;
        const setting k = setting_at(c, 1, &g);
        if (!(k.c >= 0)) continue;
        vec3 t = {0, 0, 0};
        given("eta = 1: no boundary at all. d = " VEC ", n = " VEC ", cos θ = %.3g", ARG(k.d),
              ARG(k.n), k.c);
        suspect_slip(
            "a sine above 1: d and n are unit but for rounding, so their cross product, "
            "or |d + cos θ n|, may pass 1. 1 - cos² θ cannot; or take eta = 1 by itself");
        CHECK_BOOL(refract(k.d, k.n, 1, &t), true);
        CHECK_VEC3(t, k.d,
                   absolute_of(5 * REAL_EPSILON + 16 * DBL_EPSILON / fmax(k.c, 1e-8),
                               "a unit vector; and what a root in double loses"));
    }
}

// cos θ = 0, without a rounding.
static void along_surface(void) {
    const vec3 d = {1, 0, 0}, n = {0, 1, 0};
    vec3 t = {0, 0, 0};
    given("d = (1, 0, 0) along the surface, n = (0, 1, 0), eta = 2: the critical angle from "
          "the other side");
    CHECK_BOOL(refract(d, n, 2, &t), true);
    CHECK_VEC3(t, ((vec3){(real)0.5, (real)-sqrt(0.75), 0}), roundings(4, "a unit vector"));
    given("d = (1, 0, 0) along the surface, n = (0, 1, 0), eta = 1: sin θ / eta is 1, which "
          "is not above 1");
    CHECK_BOOL(refract(d, n, 1, &t), true);
    CHECK_VEC3(t, d, roundings(4, "a unit vector"));
    given("d = (1, 0, 0) along the surface, n = (0, 1, 0), eta = 0.5: total reflection");
    CHECK_BOOL(refract(d, n, (real)0.5, &t), false);
}

// ---- fresnel_dielectric --------------------------------------------------------------

// What wrong formulas give at this cosine.
static void suspect_reflectances(double c, double eta) {
    const polarised r = polarised_exact(c, eta);
    const double s = sqrt(r.s), p = sqrt(r.p), far = far_cosine(c, eta);
    const double R = (r.s + r.p) / 2;
    if (far > 0 && s > 0.9 && p > 0.9) { // near 1 the slips below are too much alike
        suspect_value("1, as on total reflection, which is near but not here: too few digits: "
                      "double inside?",
                      1);
        return;
    }
    suspect_value("r_s² alone: unpolarised light is half r_s², half r_p². Is your r_p "
                  "another r_s? In r_p eta stands with the cosine of this side",
                  r.s);
    suspect_value("r_p² alone: unpolarised light is half r_s², half r_p²", r.p);
    suspect_value("(|r_s| + |r_p|)/2: the amplitudes are not squared", (s + p) / 2);
    suspect_value("r_s² + r_p²: the mean of both is wanted, not their sum", r.s + r.p);
    suspect_value("r_p with the wrong sign below the line: it is turned upside down",
                  (r.s + 1 / r.p) / 2);
    suspect_value("1 - R: the share that goes through", 1 - (r.s + r.p) / 2);
    suspect_value("Schlick's approximation", schlick_exact(c, eta));
    suspect_value("eta upside down", fresnel_exact(c, 1 / eta));
    if (!(far > 0)) return;
    suspect_value("the cosine of the wrong side", fresnel_exact(far, eta));
    const double a = (c - far) / (c + far);
    suspect_value("both cosines are there, but eta is missing from r_s", (a * a + r.p) / 2);
    const double sum = c + eta * far; // r_s = (c - g)/sum = -m/sum²
    suspect_value("r_s = -m/(c + g): c + g stands there squared", R * sum * sum);
}

static const char *const above_1 =
    "NaN? By the root of 1 - cos² θ, or by acos: the cosine may be a rounding above 1.";

static void reflect_straight(void) {
    const double etas[] = {1.5, 1.33, 2.4, 1.02, 3, 1 / 1.5, 1 / 2.4, 0.3};
    for (int i = 0; i < COUNT(etas); i++) {
        const double eta = (real)etas[i], R0 = straight_on(eta, 0);
        given("straight on: cosine = 1, eta = %.9g", eta);
        suspect_value("(eta - 1)/(eta + 1): not squared", fabs(eta - 1) / (eta + 1));
        suspect_value("r_s² + r_p²: the mean of both is wanted, not their sum", 2 * R0);
        suspect_value("one of the two alone, and halved; or eta is missing from r_p", R0 / 2);
        suspect_value("(r_s + r_p)² / 4: straight on r_s = -r_p. Each is squared first", 0);
        suspect_value("r_s = -m/(c + g): c + g stands there squared", square(eta - 1));
        suspect_value("1 - R: the share that goes through", 1 - R0);
        const allowance fair =
            relative_to(0.6 * REAL_EPSILON + 64 * DBL_EPSILON / fabs(eta - 1),
                        "double inside, rounded once");
        CHECK_REAL(fresnel_dielectric(1, (real)eta), R0, fair);
        given("straight on, and a rounding took the cosine past 1, to %.17g; eta = %.9g",
              1 + REAL_EPSILON, eta);
        hint_instead(above_1);
        CHECK_REAL(fresnel_dielectric((real)(1 + REAL_EPSILON), (real)eta), R0,
                   relative_to(8 * REAL_EPSILON / fmin(eta, 1),
                               "r_s² and r_p² move by 4/eta times as much as the cosine"));
    }
}

// tan θ = eta: r_p is 0, and only the half r_s² / 2 is left.
static void brewster(void) {
    const double etas[] = {1.5, 1.33, 2.4, 1.1, 1 / 1.5, 1 / 2.4};
    for (int i = 0; i < COUNT(etas); i++) {
        const double eta = (real)etas[i], c = (real)(1 / sqrt(1 + eta * eta));
        const double s = (eta * eta - 1) / (eta * eta + 1);
        given("Brewster's angle, tan θ = eta: cosine = %.9g, eta = %.9g", c, eta);
        suspect_value("r_s² + r_p²: the half is missing? Or is it r_s² alone? r_p is 0 here",
                      s * s);
        suspect_reflectances(c, eta);
        CHECK_REAL(fresnel_dielectric((real)c, (real)eta), s * s / 2,
                   relative_to(16 * REAL_EPSILON, "the cosine was rounded"));
    }
}

static void grazing(void) {
    const double etas[] = {1.5, 1.02, 1 + 4 * REAL_EPSILON, 3, 0.7, 1 - 4 * REAL_EPSILON};
    for (int i = 0; i < COUNT(etas); i++) {
        const double eta = etas[i];
        given("along the surface: cosine = 0, eta = %.*g: everything is reflected%s",
              fabs(eta - 1) < 0.01 ? 17 : 9, eta, eta < 1 ? ". Total reflection" : "");
        suspect_value("r_p with eta at the wrong cosine", (1 + 1 / (eta * eta)) / 2);
        if (eta < 1) hint_instead("cos² θ_t = 1 - sin² θ / eta² is negative: what then?");
        CHECK_REAL(fresnel_dielectric(0, (real)eta), 1, roundings(4, "a quotient of equals"));
    }
}

static void no_boundary(void) {
    rng g = check_rng(5);
    for (int i = 0; i < 1000; i++) {
        const double c = i == 0 ? 0 : i == 1 ? 1 : decades(&g, -30, 0);
        given("eta = 1: no boundary at all; cosine = %.9g", c);
        suspect_value("all is reflected: for grazing light 0/0 was avoided the wrong way", 1);
        CHECK_REAL(fresnel_dielectric((real)c, 1), 0, exactly());
    }
}

// One rounding of the result, and what any right formula loses in double: near eta = 1
// the two terms of r_s cancel, and near the critical angle the root magnifies.
static allowance one_rounding(double c, double eta) {
    const double g = eta * far_cosine(c, eta), m = fabs((eta - 1) * (eta + 1));
    const double inside = 64 * DBL_EPSILON * (1 + 1 / g) * (c + g) / m;
    return relative_to(0.55 * REAL_EPSILON + inside,
                       "double inside, rounded once; and what cancels in double");
}

static void check_reflectance(double c, double eta) {
    const double far = far_cosine(c, eta);
    given("cosine = %.9g, eta = %.9g%s", c, eta, far > 0 ? "" : ": total reflection");
    suspect_reflectances(c, eta);
    if (!(far > 0)) hint_instead("cos² θ_t = 1 - sin² θ / eta² is negative: what then?");
    const real R = fresnel_dielectric((real)c, (real)eta);
    CHECK_REAL(R, fresnel_exact(c, eta), far > 0 ? one_rounding(c, eta) : exactly());
    CHECK(R <= 1, "R is a share: never above 1");
}

static void reflect_generic(void) {
    rng g = check_rng(6);
    for (int i = 0; i < 20000; i++) {
        const double c = (real)some_cosine(&g), eta = (real)exp(between(&g, -1.4, 1.4));
        if (fabs(eta - 1) > 0.001) check_reflectance(c, eta);
    }
}

static void reflect_nearly_nothing(void) {
    rng g = check_rng(7);
    for (int i = 0; i < 10000; i++) {
        const double off = decades(&g, sizeof(real) == sizeof(float) ? -6.5 : -9, -2);
        const double eta = (real)(rng_bits(&g) & 1 ? 1 + off : 1 - off);
        const double c = (real)(rng_bits(&g) & 1 ? between(&g, 0, 1) : sqrt(2 * off) * 1.2);
        check_reflectance((real)fmin(c, 1), eta);
    }
}

// Within a few roundings of a double nobody can tell on which side of the critical angle.
static bool certain_side(real c, double eta) {
    const exact g2 = ((exact)eta - 1) * ((exact)eta + 1) + (exact)c * c;
    return g2 > 8 * DBL_EPSILON || g2 < -8 * DBL_EPSILON;
}

// On both sides of the critical angle, down to the next number.
static void reflect_critical(void) {
    const double offs[] = {0, 1e-6, 1e-4, 1e-2};
    rng g = check_rng(8);
    for (int i = 0; i < 4000; i++) {
        const double eta = (real)between(&g, 0.25, 0.95), off = offs[i % COUNT(offs)];
        const real c = (real)sqrt((1 - eta) * (1 + eta));
        const real up = off > 0 ? (real)((double)c * (1 + off)) : nextafter(c, (real)1);
        const real down = off > 0 ? (real)((double)c * (1 - off)) : nextafter(c, (real)0);
        if (certain_side(up, eta)) check_reflectance(up, eta);
        if (certain_side(down, eta)) check_reflectance(down, eta);
    }
}

// Seen from behind: the ray that was refracted, back the same way.
static void reciprocity(void) {
    rng g = check_rng(9);
    for (int i = 0; i < 5000; i++) {
        const double eta = (real)between(&g, 1.1, 3), c = (real)between(&g, 0.05, 1);
        const double far = (real)far_cosine(c, eta);
        given("eta = %.9g: into glass at the cosine %.9g, and out of it the same way, at %.9g",
              eta, c, far);
        CHECK_REAL(fresnel_dielectric((real)far, (real)(1 / eta)),
                   fresnel_dielectric((real)c, (real)eta),
                   absolute_of(16 * REAL_EPSILON * eta * eta / c,
                               "the cosine and 1/eta are rounded, magnified by eta²/cos θ"));
    }
}

typedef double (*reflectance)(double cosine, double eta);

static double student_dielectric(double cosine, double eta) {
    return (double)fresnel_dielectric((real)cosine, (real)eta);
}

static double student_schlick(double cosine, double eta) {
    return (double)schlick((real)cosine, (real)eta);
}

// ∫ R 2 c dc over the cosines above c0, by Simpson's rule; c = c0 + (1 - c0) u², since R
// has a root's slope at the critical angle c0.
static double diffuse_albedo(reflectance R, double eta) {
    enum { STEPS = 4000 };
    const double c0 = eta < 1 ? sqrt((1 - eta) * (1 + eta)) : 0;
    double sum = 0;
    for (int i = 0; i <= STEPS; i++) {
        const double u = (double)i / STEPS, c = c0 + (1 - c0) * u * u;
        const double weight = i == 0 || i == STEPS ? 1 : i % 2 ? 4 : 2;
        sum += weight * R(c, eta) * 2 * c * 2 * u * (1 - c0);
    }
    return c0 * c0 + sum / (3 * STEPS);
}

static void diffuse_light(void) {
    const struct {
        double n, outside;
    } known[] = {{1.33, 0.065930849299}, {1.5, 0.091777959342}, {2.4, 0.210181302010}};
    for (int i = 0; i < COUNT(known); i++) {
        const double n = known[i].n, F = known[i].outside;
        given("diffuse light from outside on n = %g: the share reflected, ∫ R 2 cos θ d cos θ",
              n);
        suspect_value("Schlick's", straight_on(n, 0) + (1 - straight_on(n, 0)) / 21);
        CHECK_REAL(diffuse_albedo(student_dielectric, n), F,
                   relative_to(1e-11 + 2 * REAL_EPSILON, "closed form; R and n are rounded"));
        given("diffuse light from inside n = %g: 1 - (1 - F)/n², F the share from outside", n);
        suspect_value("the same as from outside: eta upside down?", F);
        CHECK_REAL(diffuse_albedo(student_dielectric, 1 / n), 1 - (1 - F) / (n * n),
                   relative_to(1e-8 + 8 * REAL_EPSILON, "closed form; R and n are rounded"));
    }
}

// ---- schlick -------------------------------------------------------------------------

static void suspect_schlicks(double c, double eta) {
    const double R0 = straight_on(eta, 0), m = 1 - c, r = sqrt(R0);
    suspect_value("the cosine inside: Schlick's is the one on the less dense side",
                  schlick_formula(c, eta));
    suspect_value("R0 + (1 - R0) cos^5 θ: it is 1 - cos θ that counts",
                  R0 + (1 - R0) * pow(c, 5));
    suspect_value("R0 + (1 - cos θ)^5: the factor 1 - R0 is missing", R0 + pow(m, 5));
    suspect_value("(1 - cos θ)^5 alone: R0 is missing", pow(m, 5));
    suspect_value("the power 4, not 5", R0 + (1 - R0) * pow(m, 4));
    suspect_value("R0 = (eta - 1)/(eta + 1), not squared", r + (1 - r) * pow(m, 5));
    suspect_value("the exact formula", fresnel_exact(c, eta));
    suspect_value("0, as for eta = 1: a boundary as weak as this one still reflects", 0);
    if (far_cosine(c, eta) > 0)
        suspect_value("the cosine of the far side, also from outside",
                      schlick_formula(far_cosine(c, eta), eta));
    if (eta < 1)
        suspect_value("cos θ_t with eta upside down: sin θ_t = sin θ / eta",
                      schlick_formula(far_cosine(c, 1 / eta), eta));
}

static void schlick_outside(void) {
    rng g = check_rng(10);
    for (int i = 0; i < 5000; i++) {
        const double c = (real)(i ? some_cosine(&g) : 0.37);
        const double eta = (real)(i == 0  ? 1.45
                                  : i % 4 ? between(&g, 1.01, 4)
                                          : 1 + decades(&g, -6, -2));
        given("from outside: cosine = %.9g, eta = %.9g", c, eta);
        suspect_schlicks(c, eta);
        CHECK_REAL(schlick((real)c, (real)eta), schlick_formula(c, eta),
                   absolute_of(8 * REAL_EPSILON * straight_on(eta, 0) +
                                   8 * REAL_EPSILON * pow(1 - c, 4),
                               "a few roundings of each term"));
    }
}

static void schlick_straight(void) {
    const double etas[] = {1.5, 1 / 1.5};
    for (int i = 0; i < COUNT(etas); i++) {
        const double eta = (real)etas[i], R0 = straight_on(eta, 0);
        given("straight on, and a rounding took the cosine past 1, to %.17g; eta = %.9g",
              1 + REAL_EPSILON, eta);
        hint_instead(above_1);
        CHECK_REAL(schlick((real)(1 + REAL_EPSILON), (real)eta), R0,
                   roundings(16, "a few roundings of R0"));
    }
}

// LECTURE: inside n = 1.5 at 41° exact 0.380, inside cosine 0.041, transmitted 0.401.
static void schlick_at_41(void) {
    const double c = (real)cos(41 * PI / 180), eta = (real)(1 / 1.5);
    given("inside glass, n = 1.5, at 41°: cosine = %.9g, eta = %.9g. The exact R is 0.380", c,
          eta);
    suspect_schlicks(c, eta);
    CHECK_REAL(schlick((real)c, (real)eta), 0.401,
               absolute_of(0.001, "the figure that the text gives, rounded"));
}

static void schlick_inside(void) {
    rng g = check_rng(11);
    for (int i = 0; i < 5000; i++) {
        const double eta = (real)(i % 4 ? between(&g, 0.25, 0.99) : 1 - decades(&g, -6, -2));
        const double critical = sqrt((1 - eta) * (1 + eta));
        const double c = (real)(critical + (1 - critical) * decades(&g, -4, 0));
        const double far = far_cosine(c, eta);
        if (!(far > 0)) continue;
        given("from inside: cosine = %.9g, eta = %.9g, so cos θ_t = %.6g", c, eta, far);
        suspect_schlicks(c, eta);
        CHECK_REAL(schlick((real)c, (real)eta), schlick_exact(c, eta),
                   absolute_of(16 * REAL_EPSILON *
                                       (straight_on(eta, 0) + pow(1 - far, 4) * (1 + 1 / far)) +
                                   16 * DBL_EPSILON / (far * eta * eta),
                               "roundings, those of cos² θ_t magnified by the root"));
    }
}

static void schlick_total(void) {
    rng g = check_rng(12);
    for (int i = 0; i < 2000; i++) {
        const double eta = (real)between(&g, 0.25, 0.99);
        const double c = (real)(sqrt((1 - eta) * (1 + eta)) * (1 - decades(&g, -4, 0)));
        given("beyond the critical angle: cosine = %.9g, eta = %.9g", c, eta);
        suspect_value("total reflection was forgotten, and the cosine is the inside one",
                      schlick_formula(c, eta));
        CHECK_REAL(schlick((real)c, (real)eta), 1, exactly());
    }
}

static void schlick_nothing(void) {
    rng g = check_rng(13);
    for (int i = 0; i < 500; i++) {
        const double c = (real)(i == 0 ? 0 : rng_double(&g));
        given("eta = 1: no boundary at all; cosine = %.9g", c);
        suspect_value("(1 - cos θ)^5: the slide's formula reflects where there is nothing",
                      pow(1 - c, 5));
        CHECK_REAL(schlick((real)c, 1), 0, exactly());
    }
}

static void schlick_diffuse(void) {
    const double etas[] = {1.1, 1.33, 1.5, 2.4};
    for (int i = 0; i < COUNT(etas); i++) {
        const double R0 = straight_on(etas[i], 0);
        given("diffuse light from outside, eta = %g: ∫ R 2 cos θ d cos θ = R0 + (1 - R0)/21",
              etas[i]);
        suspect_value("the exact share, not Schlick's", diffuse_albedo(fresnel_exact, etas[i]));
        suspect_value("with the power 4", R0 + (1 - R0) / 15);
        CHECK_REAL(diffuse_albedo(student_schlick, etas[i]), R0 + (1 - R0) / 21,
                   relative_to(1e-11 + 8 * REAL_EPSILON, "closed form; R is rounded"));
    }
}

// The largest error over all angles, as the text prints it.
static void schlick_errors(void) {
    const struct {
        double eta, largest;
    } known[] = {{1.1, 0.210}, {1.2, 0.113}, {1.33, 0.060}, {1.5, 0.036},
                 {1.6, 0.032}, {2.0, 0.044}, {2.4, 0.074}};
    for (int i = 0; i < COUNT(known); i++) {
        double worst = 0, back = 0;
        for (int k = 0; k <= 4000; k++) {
            const double c = k / 4000.0, eta = known[i].eta, far = far_cosine(c, eta);
            const double R = fresnel_exact(c, eta);
            worst = fmax(worst, fabs(student_schlick(c, eta) - R));
            back = fmax(back, fabs(student_schlick(far, 1 / eta) - R));
        }
        given("the largest difference between schlick and the exact R, eta = %g", known[i].eta);
        CHECK_REAL(worst, known[i].largest, absolute_of(0.0006, "three decimals"));
        given("the same for light that leaves, eta = 1/%g", known[i].eta);
        CHECK_REAL(back, known[i].largest,
                   absolute_of(0.0006 + 5 * sqrt(8 * REAL_EPSILON),
                               "three decimals; the cosine inside is rounded"));
    }
}

// ---- glass_bounce --------------------------------------------------------------------

// Each draw is one of the two directions.
static void two_directions(void) {
    rng g = check_rng(14);
    for (int i = 0; i < 20000; i++) {
        const setting k = setting_at(between(&g, 0.02, 1), exp(between(&g, -1, 1)), &g);
        const double far = far_cosine(k.c, k.eta);
        if (!(far > 0.02)) continue;
        const vec3 v = glass_bounce(k.d, k.n, (real)k.eta, &g);
        const vec3 reflected = mirrored(k.d, k.n), through = refracted(k.d, k.n, k.eta);
        const bool back = wide_dot(widen(v), widen(k.n)) > 0;
        const real R = (real)fresnel_exact(k.c, k.eta);
        given("d = " VEC ", n = " VEC ", eta = %.9g, so R = %.6g: a draw on the side of the %s "
              "ray",
              ARG(k.d), ARG(k.n), k.eta, (double)R, back ? "mirrored" : "refracted");
        suspect_factor("R times the direction: R is the chance to be drawn, and cancels", R);
        suspect_factor("1 - R times the direction: it is the chance to be drawn, and cancels",
                       1 - R);
        suspect_factor("direction / R: the chance cancels, nothing is left of it", 1 / R);
        suspect_vec3("d itself: not bent", k.d);
        if (far_cosine(k.c, 1 / k.eta) > 0)
            suspect_vec3("refracted with eta upside down", refracted(k.d, k.n, 1 / k.eta));
        suspect_vec3("a mixture of both directions: one of them is to be drawn",
                     combine((double)R, reflected, 1 - (double)R, through));
        CHECK_VEC3(
            v, back ? reflected : through,
            absolute_of(8 * REAL_EPSILON + magnified(k.c, k.eta), "d and n are rounded"));
        const double length_of_v = wide_length(v);
        CHECK_REAL(length_of_v, 1, out_of_glass(12, k.eta));
    }
}

// How many of `count` are mirrored.
static long mirrored_of(setting k, long count, rng *g) {
    long back = 0;
    for (long i = 0; i < count; i++)
        back += dot(glass_bounce(k.d, k.n, (real)k.eta, g), k.n) > 0;
    return back;
}

// 5 standard errors and one draw: a share near 0 is not normally distributed.
static void share_mirrored(void) {
    const double settings[][2] = {
        {1 / 1.5, 0.76}, {0.5, 0.9},       {1.5, 0.9},  {1.5, 0.3},    {1.5, 0.1}, {2.4, 0.7},
        {1.33, 0.05},    {1 / 1.5, 0.755}, {0.8, 0.62}, {1.02, 0.015}, {3, 0.4}};
    rng g = check_rng(15);
    for (int i = 0; i < COUNT(settings); i++) {
        const setting k = setting_at(settings[i][1], settings[i][0], &g);
        const double R = fresnel_exact(k.c, k.eta);
        const long draws = i ? 50000 : 1000000; // many: to tell apart what is likely wrong
        const double share = (double)mirrored_of(k, draws, &g) / (double)draws;
        given("cos θ = %.6g, eta = %.6g: the share of %ld draws that is mirrored; R = %.6g",
              k.c, k.eta, draws, R);
        suspect_value("mirrored and refracted turn about: probability 1/2, not R", 0.5);
        suspect_value("1 - R: mirrored and refracted are exchanged", 1 - R);
        suspect_value("never mirrored: is R asked, and is g used?", 0);
        suspect_value(
            "always mirrored: is cosine = -d·n? Is g used? Does refract get eta as it is?", 1);
        suspect_value("Schlick's R, not the exact one", schlick_exact(k.c, k.eta));
        suspect_value("R with eta upside down", fresnel_exact(k.c, 1 / k.eta));
        suspect_value("R with the cosine of the wrong side",
                      fresnel_exact(far_cosine(k.c, k.eta), k.eta));
        suspect_value("(1 - R)/eta² goes through: paths count light, which loses none; it is "
                      "radiance that changes by eta²",
                      1 - (1 - R) / square(k.eta));
        suspect_value("R straight on, at every angle", straight_on(k.eta, 0));

        const double error = sqrt(R * (1 - R) / (double)draws);
        CHECK_REAL(share, R,
                   i ? standard_errors(5, error + 0.2 / (double)draws)
                     : absolute_of(0.006, "far more than 5 standard errors"));
    }
}

static void always_mirrored(void) {
    rng g = check_rng(16);
    for (int i = 0; i < 5000; i++) {
        const double eta = (real)between(&g, 0.3, 0.9);
        const double critical = sqrt((1 - eta) * (1 + eta));
        const setting k = setting_at(critical * between(&g, 0.01, 0.99), eta, &g);
        const vec3 v = glass_bounce(k.d, k.n, (real)k.eta, &g);
        given("total reflection: d = " VEC ", n = " VEC ", eta = %.9g", ARG(k.d), ARG(k.n),
              k.eta);
        suspect_vec3("d itself: it went straight through", k.d);
        CHECK_VEC3(v, mirrored(k.d, k.n), roundings(24, "d and n are rounded"));
    }
}

static void never_mirrored(void) {
    rng g = check_rng(17);
    for (int i = 0; i < 5000; i++) {
        const setting k = setting_at(between(&g, 0.001, 1), 1, &g);
        given("eta = 1: no boundary at all. d = " VEC ", n = " VEC, ARG(k.d), ARG(k.n));
        suspect_vec3("mirrored", mirrored(k.d, k.n));
        CHECK_VEC3(glass_bounce(k.d, k.n, 1, &g), k.d, roundings(16, "a unit vector"));
        rng zero = {0, 1};
        given("eta = 1, so R = 0, and the number drawn is 0. d = " VEC ", n = " VEC, ARG(k.d),
              ARG(k.n));
        suspect_vec3("mirrored, when the number is at most R: 0 is drawn too, once in 2^24 "
                     "times. Below R is the chance R",
                     mirrored(k.d, k.n));
        CHECK_VEC3(glass_bounce(k.d, k.n, 1, &zero), k.d, roundings(16, "a unit vector"));
    }
}

static void draws_from_g(void) {
    rng g = check_rng(22);
    for (int i = 0; i < 200; i++) {
        const setting k = setting_at(0.9, 0.5, &g); // R is 0.16
        rng one = rng_seed(1, (uint64_t)i), other = one;
        const vec3 first = glass_bounce(k.d, k.n, (real)k.eta, &one);
        const vec3 second = glass_bounce(k.d, k.n, (real)k.eta, &other);
        given("d = " VEC ", n = " VEC ", eta = 0.5, " ASKED_TWICE, ARG(k.d), ARG(k.n),
              ARG(first), ARG(second));
        check_from_g(first, second);
    }
}

// Two numbers for one choice are none too few: the chances would not add up to 1.
static void draws_once(void) {
    rng g = check_rng(20);
    for (int i = 0; i < 2000; i++) {
        const setting k = setting_at(between(&g, 0.02, 1), exp(between(&g, -1, 1)), &g);
        rng one = g, other = g;
        const rng none = g;
        rng_real(&one);
        rng_double(&other);
        glass_bounce(k.d, k.n, (real)k.eta, &g);
        const bool at_most_one_number =
            same_state(g, none) || same_state(g, one) || same_state(g, other);
        given("d = " VEC ", n = " VEC ", eta = %.9g, and the generator g before and after",
              ARG(k.d), ARG(k.n), k.eta);
        CHECK(at_most_one_number, "one number of g decides, or none on total reflection");
    }
}

// So near the critical angle that in double it is total reflection, while the cosine,
// rounded to real, still says R < 1. Rare: eta and d are tried until it is so.
static setting nearly_through(rng *g) {
    for (int i = 0; i < 1000; i++) {
        const double eta = (real)between(g, 0.3, 0.9);
        const setting k = setting_at(sqrt((1 - eta) * (1 + eta)), eta, g);
        vec3 t;
        const bool through = refract(k.d, k.n, (real)k.eta, &t);
        if (!through && fresnel_dielectric(-dot(k.d, k.n), (real)k.eta) < 1) return k;
    }
    return (setting){.eta = 0};
}

static void nearly_total_bounce(void) {
    rng g = check_rng(21);
    for (int i = 0; i < 40; i++) {
        const setting k = nearly_through(&g);
        const vec3 back = mirrored(k.d, k.n), along = normalize(add(k.d, back));
        for (int draw = 0; k.eta > 0 && draw < 4000; draw++) {
            const vec3 v = glass_bounce(k.d, k.n, (real)k.eta, &g);
            const bool is_along = wide_length(sub(v, along)) < 0.01;
            given("d = " VEC ", n = " VEC ", eta = %.9g: the critical angle, but for a "
                  "rounding. refract returns false, and R is a little below 1: draw %d",
                  ARG(k.d), ARG(k.n), k.eta, draw + 1);
            suspect_vec3("d itself: it went straight through. What did refract return?", k.d);
            suspect_vec3("nothing: what did refract return?", (vec3){0, 0, 0});
            if (!is_along) CHECK_VEC3(v, back, roundings(24, "d and n are rounded"));
        }
    }
}

// A cosine that rounding has made larger than 1, or negative.
static void rounded_cosines(void) {
    rng g = check_rng(18);
    for (int i = 0; i < 20000; i++) {
        const vec3 n = unit_vector(&g);
        const double c = i % 2 ? 1 : (1 - 2.0 * rng_double(&g)) * REAL_EPSILON;
        const vec3 d = arriving(n, across(n, &g), fmax(c, -1));
        const real eta = (real)exp(between(&g, -1, 1));
        const vec3 v = glass_bounce(d, n, eta, &g);
        given("cos θ = %.9g, which rounding moved: d = " VEC ", n = " VEC ", eta = %.9g",
              cosine_of(d, n), ARG(d), ARG(n), (double)eta);
        const double R = fresnel_exact(fmin(fmax(c, 0), 1), (double)eta);
        suspect_value("R times the direction: R is the chance to be drawn, and cancels", R);
        suspect_value("1 - R times the direction: it is the chance to be drawn, and cancels",
                      1 - R);
        const double length_of_v = wide_length(v);
        CHECK_REAL(length_of_v, 1, out_of_glass(16, (double)eta));
    }
}

// ---- fresnel_conductor ---------------------------------------------------------------

static color three(double (*f)(double cosine, double eta, double k), double c, color eta,
                   color k) {
    return (color){(real)f(c, (double)eta.x, (double)k.x),
                   (real)f(c, (double)eta.y, (double)k.y),
                   (real)f(c, (double)eta.z, (double)k.z)};
}

static double only_s(double c, double eta, double k) {
    return polarised_conductor(c, eta, k).s;
}

static double only_p(double c, double eta, double k) {
    return polarised_conductor(c, eta, k).p;
}

static double without_k(double c, double eta, double k) {
    (void)k;
    return fresnel_exact(c, eta);
}

static double without_angle(double c, double eta, double k) {
    (void)c;
    return straight_on(eta, k);
}

static double by_schlick(double c, double eta, double k) {
    return straight_on(eta, k) + (1 - straight_on(eta, k)) * pow(1 - c, 5);
}

// Without the sine: large |eta + i k| bends everything to the normal.
static double large_index(double c, double eta, double k) {
    const double size = eta * eta + k * k, v = 2 * eta * c;
    const double s = (size - v + c * c) / (size + v + c * c);
    const double p = (size * c * c - v + 1) / (size * c * c + v + 1);
    return (s + p) / 2;
}

static double swapped(double c, double eta, double k) {
    return conductor_exact(c, k, eta);
}

static void suspect_conductors(double c, color eta, color k) {
    suspect_vec3("k is ignored: that is glass of the index eta", three(without_k, c, eta, k));
    suspect_vec3("eta and k are exchanged", three(swapped, c, eta, k));
    suspect_vec3("r_s² alone: unpolarised light is half r_s², half r_p²",
                 three(only_s, c, eta, k));
    suspect_vec3("r_p² alone: unpolarised light is half r_s², half r_p²",
                 three(only_p, c, eta, k));
    suspect_vec3("r_s² + r_p²: the mean of both is wanted, not their sum",
                 add(three(only_s, c, eta, k), three(only_p, c, eta, k)));
    suspect_vec3("R straight on, at every angle", three(without_angle, c, eta, k));
    suspect_vec3("Schlick's approximation", three(by_schlick, c, eta, k));
    suspect_vec3("the approximation for a large index, without the sine",
                 three(large_index, c, eta, k));
    const real R = (real)conductor_exact(c, (double)eta.x, (double)k.x);
    suspect_vec3("the red share for all colours", (color){R, R, R});
}

// To a rounding of 1; what is lost inside, in double, is magnified by the complex root
// a + i b, most of all where a is small beside b.
static double conductor_slack(double c, color eta, color k) {
    const double e[] = {(double)eta.x, (double)eta.y, (double)eta.z};
    const double i[] = {(double)k.x, (double)k.y, (double)k.z};
    double smallest = 1;
    for (int j = 0; j < 3; j++) {
        const double re = (e[j] - 1) * (e[j] + 1) - i[j] * i[j] + c * c;
        const double size = hypot(re, 2 * e[j] * i[j]), b = sqrt((size + fabs(re)) / 2);
        smallest = fmin(smallest, re < 0 && i[j] > 0 ? e[j] * i[j] / b : sqrt(size));
    }
    return 2 * REAL_EPSILON + 32 * DBL_EPSILON / smallest;
}

static void check_conductor(double c, color eta, color k, const char *what) {
    given("%s: cosine = %.9g, eta = " VEC ", k = " VEC, what, c, ARG(eta), ARG(k));
    suspect_conductors(c, eta, k);
    CHECK_VEC3(fresnel_conductor((real)c, eta, k), three(conductor_exact, c, eta, k),
               absolute_of(conductor_slack(c, eta, k),
                           "double inside, rounded once: to a rounding of 1"));
}

static void conductor_straight(void) {
    const color eta = {(real)0.2, (real)1.4, (real)2.7}, k = {(real)3.9, (real)2.2, (real)0.6};
    check_conductor(1, eta, k, "straight on, ((eta - 1)² + k²)/((eta + 1)² + k²)");
    for (const metal *m = metals; m->name; m++) check_conductor(1, m->eta, m->k, m->name);
}

static void conductor_metals(void) {
    rng g = check_rng(19);
    for (const metal *m = metals; m->name; m++)
        for (int i = 0; i < 300; i++)
            check_conductor((real)some_cosine(&g), m->eta, m->k, m->name);
}

static color some_index(rng *g, double low, double high) {
    const double x = decades(g, low, high), y = decades(g, low, high),
                 z = decades(g, low, high);
    return (color){(real)x, (real)y, (real)z};
}

static void conductor_generic(void) {
    rng g = check_rng(20);
    for (int i = 0; i < 5000; i++) {
        const color eta = some_index(&g, -2, 1.5), k = some_index(&g, -3, 2);
        check_conductor((real)some_cosine(&g), eta, k, "some conductor");
    }
}

static void conductor_without_k(void) {
    rng g = check_rng(21);
    for (int i = 0; i < 5000; i++) {
        const color eta = some_index(&g, -0.5, 0.5), none = {0, 0, 0};
        const double c = (real)some_cosine(&g);
        const color R = {fresnel_dielectric((real)c, eta.x), fresnel_dielectric((real)c, eta.y),
                         fresnel_dielectric((real)c, eta.z)};
        given("k = 0: that is glass, total reflection included. cosine = %.9g, eta = " VEC, c,
              ARG(eta));
        suspect_conductors(c, eta, none);
        CHECK_VEC3(
            fresnel_conductor((real)c, eta, none), R,
            absolute_of(2 * conductor_slack(c, eta, none),
                        "to a rounding of 1; at the critical angle a root magnifies it"));
    }
}

static void conductor_grazing(void) {
    for (const metal *m = metals; m->name; m++) {
        given("%s, along the surface: cosine = 0: everything is reflected", m->name);
        CHECK_VEC3(fresnel_conductor(0, m->eta, m->k), ((color){1, 1, 1}),
                   roundings(4, "a quotient of equals"));
    }
}

// ---- absorb --------------------------------------------------------------------------

static color each(double (*f)(double sigma, double t), color sigma, double t) {
    return (color){(real)f((double)sigma.x, t), (real)f((double)sigma.y, t),
                   (real)f((double)sigma.z, t)};
}

static double beer(double sigma, double t) {
    return exp(-sigma * t);
}

static double amplified(double sigma, double t) {
    return exp(sigma * t);
}

static double base_10(double sigma, double t) {
    return pow(10, -sigma * t);
}

static double base_2(double sigma, double t) {
    return pow(2, -sigma * t);
}

static double linear(double sigma, double t) {
    return 1 - sigma * t;
}

static double no_way(double sigma, double t) {
    (void)t;
    return exp(-sigma);
}

static double over_way(double sigma, double t) {
    return exp(-sigma / t);
}

static double absorbed(double sigma, double t) {
    return 1 - exp(-sigma * t);
}

static double squared_way(double sigma, double t) {
    return exp(-sigma * t * t);
}

static void suspect_absorptions(color sigma, double t) {
    const real red = (real)beer((double)sigma.x, t);
    suspect_vec3("e^(+sigma t): the sign; the light grows on its way",
                 each(amplified, sigma, t));
    suspect_vec3("10^(-sigma t): chemists' base; sigma is for base e", each(base_10, sigma, t));
    suspect_vec3("2^(-sigma t): sigma is for base e", each(base_2, sigma, t));
    suspect_vec3("1 - sigma t: right for short ways only", each(linear, sigma, t));
    suspect_vec3("e^(-sigma): the way t is missing", each(no_way, sigma, t));
    suspect_vec3("e^(-sigma / t): the longer the way the more light", each(over_way, sigma, t));
    suspect_vec3("e^(-sigma t²)", each(squared_way, sigma, t));
    suspect_vec3("1 - e^(-sigma t): what is absorbed, not what is left",
                 each(absorbed, sigma, t));
    suspect_vec3("red for all colours", (color){red, red, red});
}

// sigma t may be rounded before the power is taken.
static allowance beer_allowance(double sigma_t) {
    return roundings(4 + 2 * fabs(sigma_t), "sigma t and the power, each rounded");
}

static void absorb_by_hand(void) {
    rng g = check_rng(22);
    for (int i = 0; i < 500; i++) {
        const color sigma =
            i ? some_index(&g, -2, 1) : (color){(real)0.3, (real)1.7, (real)0.05};
        const double t = (real)(i ? decades(&g, -1, 0.5) : 2.3);
        const double most = fmax((double)sigma.x, fmax((double)sigma.y, (double)sigma.z)) * t;
        given("sigma = " VEC ", t = %.9g", ARG(sigma), t);
        suspect_absorptions(sigma, t);
        CHECK_VEC3(absorb(sigma, (real)t), each(beer, sigma, t), beer_allowance(most));
    }
}

static void absorb_nothing(void) {
    const real ways[] = {0, (real)1e-30, 3, (real)1e30, INFINITY};
    for (int i = 0; i < COUNT(ways); i++) {
        given("a clear medium, sigma = 0; t = %g", (double)ways[i]);
        CHECK_VEC3(absorb((color){0, 0, 0}, ways[i]), ((color){1, 1, 1}), exactly());
    }
    const color some = {0, (real)0.7, 0};
    given("green is absorbed, red and blue are not; t = INFINITY");
    CHECK_VEC3(absorb(some, INFINITY), ((color){1, 0, 1}), exactly());
    given("t = 0: no way at all");
    CHECK_VEC3(absorb((color){(real)0.3, 9, (real)1e30}, 0), ((color){1, 1, 1}), exactly());
}

static void absorb_in_parts(void) {
    rng g = check_rng(23);
    for (int i = 0; i < 3000; i++) {
        const color sigma = some_index(&g, -3, 1);
        const double a = (real)decades(&g, -3, 0.5), b = (real)decades(&g, -3, 0.5);
        const real both = (real)a + (real)b;
        const double most = fmax((double)sigma.x, fmax((double)sigma.y, (double)sigma.z));
        given("sigma = " VEC ": the ways %.9g and then %.9g, and both at once", ARG(sigma), a,
              b);
        CHECK_VEC3(
            mul(absorb(sigma, (real)a), absorb(sigma, (real)b)), absorb(sigma, both),
            roundings(10 + 6 * most * (a + b), "each sigma t and each power is rounded"));
        given("sigma = " VEC ", t = %.9g: twice as dense, half as far", ARG(sigma), a);
        CHECK_VEC3(absorb(scale(2, sigma), (real)(a / 2)), absorb(sigma, (real)a),
                   roundings(4, "a rounding of each"));
    }
}

static void absorb_extremes(void) {
    const struct {
        double sigma, t, left;
    } rows[] = {{1e30, 1e30, 0},      {1e-30, 1e30, exp(-1)}, {1e30, 1e-30, exp(-1)},
                {1e-30, 1e-30, 1},    {1e-3, 1e-30, 1},       {5, 1e6, 0},
                {1e-7, 1e7, exp(-1)}, {1e30, INFINITY, 0},    {1e-30, INFINITY, 0}};
    for (int i = 0; i < COUNT(rows); i++) {
        const real s = (real)rows[i].sigma, t = (real)rows[i].t;
        given("sigma = %g in red, green and blue, t = %g", (double)s, (double)t);
        CHECK_VEC3(absorb((color){s, s, s}, t),
                   ((color){(real)rows[i].left, (real)rows[i].left, (real)rows[i].left}),
                   roundings(8, "sigma t and the power, each rounded"));
    }
}

// ---- metals, and Schlick for them: given ---------------------------------------------

// At 550 nm: eta and k lie between those of the published neighbours; and the largest
// error of Schlick's formula.
static void metal_table(void) {
    const struct {
        const char *name;
        double eta[2], k[2], error;
    } known[] = {{"Au", {0.29, 0.43}, {2.455, 2.863}, 0.010},
                 {"Ag", {0.05, 0.06}, {3.586, 3.858}, 0.006},
                 {"Cu", {0.70, 1.02}, {2.577, 2.704}, 0.037},
                 {"Al", {0.8734, 1.0728}, {6.2418, 6.7839}, 0.092},
                 {"Fe", {2.94, 2.95}, {2.93, 2.99}, 0.174},
                 {"Cr", {3.18, 3.22}, {3.30, 3.33}, 0.198},
                 {"W", {3.522, 3.524}, {2.739, 2.787}, 0.203}};
    for (int i = 0; i < COUNT(known); i++) {
        const metal *m = &metals[i];
        const double eta = (double)m->eta.y, k = (double)m->k.y;
        given("metal %d is %s, at 550 nm %g + %g i", i, m->name, eta, k);
        CHECK(m->name[0] == known[i].name[0] && m->name[1] == known[i].name[1],
              "the metals stand in this order: Au Ag Cu Al Fe Cr W");
        CHECK(eta > known[i].eta[0] - 0.006 && eta < known[i].eta[1] + 0.006,
              "eta lies between its published neighbours, rounded to two decimals");
        CHECK(k > known[i].k[0] - 0.006 && k < known[i].k[1] + 0.006,
              "k lies between its published neighbours, rounded to two decimals");
        double worst = 0;
        for (int j = 0; j <= 2000; j++) {
            const double R = conductor_exact(j / 2000.0, eta, k);
            const color approximate = schlick_conductor((real)(j / 2000.0), m->eta, m->k);
            worst = fmax(worst, fabs((double)approximate.y - R));
        }
        given("%s at 550 nm: the largest error of schlick_conductor", m->name);
        CHECK_REAL(worst, known[i].error,
                   absolute_of(0.006, "published indices differ by some hundredths"));
    }
    CHECK(metals[COUNT(known)].name == NULL, "the list ends with a name of NULL");
}

static void slide_formula(void) {
    rng g = check_rng(24);
    for (int i = 0; i < 1000; i++) {
        const double c = (real)rng_double(&g), eta = (real)exp(between(&g, -1, 1));
        given("cosine = %.9g, eta = %.9g", c, eta);
        CHECK_REAL(schlick_slide((real)c, (real)eta), schlick_formula(c, eta),
                   absolute_of(8 * REAL_EPSILON, "a few roundings"));
    }
    given("inside n = 1.5 at 41°, the slide's formula with the inside cosine");
    CHECK_REAL(schlick_slide((real)cos(41 * PI / 180), (real)(1 / 1.5)), 0.041,
               absolute_of(0.0006, "three decimals"));
}

// ---- paths through glass: given --------------------------------------------------------

enum { LONG = 100000, BODIES = 8 };

static color grey(double x) {
    return (color){(real)x, (real)x, (real)x};
}

static color white_sky(vec3 d) {
    (void)d;
    return (color){1, 1, 1};
}

static color small_sun(vec3 d) { // straight up, 0.1 radians
    return grey(d.y > cos(0.1) ? 1 : 0);
}

static color sky_above(vec3 d) {
    return grey(dot(d, hand_n) > 0 ? 1 : 0);
}

// A room to be filled: spheres first, then meshes; each body has a surface and a substance.
typedef struct {
    sphere spheres[BODIES];
    mesh meshes[BODIES];
    vec3 points[BODIES][8];
    surface surfaces[2 * BODIES];
    substance substances[2 * BODIES];
    int sphere_count, mesh_count;
    glass_room room;
} workshop;

static int body_count(const workshop *w) {
    return w->sphere_count + w->mesh_count;
}

static substance *add_sphere(workshop *w, vec3 c, double r, substance s) {
    w->spheres[w->sphere_count++] = (sphere){c, (real)r};
    substance *of = &w->substances[body_count(w) - 1];
    *of = s;
    return of;
}

static const int box_corners[12][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6},
                                       {0, 1, 4}, {1, 5, 4}, {2, 6, 3}, {3, 6, 7},
                                       {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};

// After all spheres. The box c ± half, outward by orientation.
static void add_box(workshop *w, vec3 c, vec3 half, substance s) {
    vec3 *p = w->points[w->mesh_count];
    for (int i = 0; i < 8; i++)
        p[i] = add(c, (vec3){i & 1 ? half.x : -half.x, i & 2 ? half.y : -half.y,
                             i & 4 ? half.z : -half.z});
    w->meshes[w->mesh_count++] = (mesh){.points = p, .corners = box_corners, .count = 12};
    w->substances[body_count(w) - 1] = s;
}

// Call it when all bodies are in; workshop_close afterwards.
static const glass_room *workshop_open(workshop *w, color (*sky)(vec3 d)) {
    const scene bodies = {.spheres = w->spheres,
                          .sphere_count = w->sphere_count,
                          .meshes = w->meshes,
                          .mesh_count = w->mesh_count,
                          .sky = sky,
                          .start = START_BOUND};
    const media start = w->room.start;
    w->room = (glass_room){lit(bodies, w->surfaces, BY_BALANCE), w->substances, start};
    return &w->room;
}

static void workshop_close(workshop *w) {
    lit_free(&w->room.room);
}

static substance clear_glass(double n, int priority) {
    return (substance){.kind = GLASS, .n = (real)n, .priority = priority};
}

static ray towards(vec3 c, double reach, rng *g) {
    const vec3 O = add(c, scale((real)(4 * reach), unit_vector(g)));
    const vec3 p = add(c, scale((real)reach, in_cube(g)));
    return (ray){O, scale((real)decades(g, -2, 2), sub(p, O))};
}

// Every path through clear glass ends in the sky, and brings all of it.
static void check_clear(workshop *w, const char *what, vec3 c, double reach, int rays,
                        uint64_t stream) {
    rng g = check_rng(stream);
    const glass_room *sc = workshop_open(w, white_sky);
    for (int i = 0; i < rays; i++) {
        const ray r = towards(c, reach, &g);
        const color L = glass_trace(sc, r, LONG, &g);
        given("%s in a sky of 1; ray %d, O = " VEC ", d = " VEC, what, i, ARG(r.O), ARG(r.d));
        suspect_vec3("black: the path never came out", (color){0, 0, 0});
        CHECK_VEC3(L, ((color){1, 1, 1}), exactly());
    }
    workshop_close(w);
}

static void clear_spheres(void) {
    const double ns[] = {1, 1.02, 1.1, 1.33, 1.5, 2, 2.4, 3, 4};
    const vec3 c = {(real)0.3, (real)-1.2, (real)2.1};
    for (int i = 0; i < COUNT(ns); i++) {
        char what[40];
        snprintf(what, sizeof what, "a sphere of glass, n = %g,", ns[i]);
        workshop w = {0};
        add_sphere(&w, c, 0.8, clear_glass(ns[i], 0));
        check_clear(&w, what, c, 0.8, 1500, 30 + (uint64_t)i);
    }
}

static void clear_scales(void) {
    const double sizes[] = {1e-4, 1e-2, 1e2, 1e4};
    for (int i = 0; i < COUNT(sizes); i++) {
        const vec3 c = scale((real)sizes[i], (vec3){3, -2, 7});
        workshop w = {0};
        add_sphere(&w, c, sizes[i], clear_glass(1.5, 0));
        add_sphere(&w, add(c, grey(0.2 * sizes[i])), 0.5 * sizes[i], clear_glass(1, 1));
        check_clear(&w, "a glass sphere with an air bubble", c, sizes[i], 800,
                    40 + (uint64_t)i);
    }
}

static void clear_nested(void) {
    const vec3 c = {(real)0.3, (real)-1.2, (real)2.1};
    workshop w = {0};
    add_sphere(&w, c, 1, clear_glass(1.5, 0));
    add_sphere(&w, add(c, grey(0.05)), 0.7, clear_glass(2.4, 1));
    add_sphere(&w, add(c, grey(0.1)), 0.4, clear_glass(1, 2));
    add_sphere(&w, add(c, grey(0.12)), 0.1, clear_glass(1.33, 3));
    check_clear(&w, "water in air in diamond in glass", c, 1, 4000, 50);
}

static void clear_overlapping(void) {
    const vec3 c = {(real)0.3, (real)-1.2, (real)2.1};
    for (int i = 0; i < 3; i++) { // the priorities: larger first, last, or equal
        workshop w = {0};
        add_sphere(&w, c, 1, clear_glass(1.5, i));
        add_sphere(&w, add(c, (vec3){(real)0.9, (real)0.3, 0}), 0.8, clear_glass(1.33, 1));
        add_sphere(&w, add(c, (vec3){(real)0.4, (real)0.8, (real)0.2}), 0.5, clear_glass(2, 1));
        check_clear(&w, "three spheres of glass that overlap", c, 1.5, 2000, 51 + (uint64_t)i);
    }
}

static void clear_touching(void) {
    const vec3 c = {(real)0.3, (real)-1.2, (real)2.1}, half = {(real)0.4, (real)0.5, (real)0.6};
    workshop w = {0};
    add_sphere(&w, c, 0.5, clear_glass(1.5, 0));
    add_sphere(&w, add(c, (vec3){1, 0, 0}), 0.5, clear_glass(1.33, 0));
    check_clear(&w, "two spheres that touch in a point", c, 1, 3000, 55);
    workshop boxes = {0};
    add_box(&boxes, c, half, clear_glass(1.5, 0));
    add_box(&boxes, add(c, (vec3){(real)0.8, 0, 0}), half, clear_glass(1.33, 0));
    check_clear(&boxes, "two boxes that share a face", c, 1, 3000, 56);
    workshop filled = {0};
    add_sphere(&filled, c, 0.5, clear_glass(1.5, 0));
    add_sphere(&filled, c, 0.5, clear_glass(1.33, 1));
    check_clear(&filled, "two spheres in the same place", c, 0.6, 2000, 57);
}

static void clear_boxes(void) {
    const double ns[] = {1.02, 1.3, 1.5, 2.4};
    const vec3 c = {(real)0.3, (real)-1.2, (real)2.1}, half = {(real)0.4, (real)0.5, (real)0.6};
    for (int i = 0; i < COUNT(ns); i++) {
        workshop w = {0};
        add_box(&w, c, half, clear_glass(ns[i], 0));
        check_clear(&w, "a box of glass", c, 0.7, 1000, 60 + (uint64_t)i);
    }
    workshop w = {0};
    add_sphere(&w, add(c, (vec3){(real)0.1, 0, 0}), 0.25, clear_glass(1, 1));
    add_box(&w, c, half, clear_glass(1.33, 0));
    check_clear(&w, "a box of water with a bubble", c, 0.7, 1000, 65);
}

// From within: the radiance in a medium is n² that in air.
static void clear_from_inside(void) {
    const double ns[] = {1.33, 1.5, 2.4};
    rng g = check_rng(70);
    for (int i = 0; i < COUNT(ns); i++) {
        workshop w = {.room = {.start = {1, {0}}}};
        add_sphere(&w, (vec3){1, 2, 3}, 1, clear_glass(ns[i], 0));
        const glass_room *sc = workshop_open(&w, white_sky);
        for (int k = 0; k < 500; k++) {
            // Near the centre: further out some rays are trapped by total reflection.
            const vec3 O = add((vec3){1, 2, 3}, scale((real)0.2, in_cube(&g)));
            given("a ray that starts inside a glass sphere, n = %g, in a sky of 1: n²", ns[i]);
            suspect_vec3("the radiance in air: the factor n² is missing", (color){1, 1, 1});
            CHECK_VEC3(glass_trace(sc, (ray){O, unit_vector(&g)}, LONG, &g),
                       grey(ns[i] * ns[i]), relative_to(1e-5, "closed form"));
        }
        workshop_close(&w);
    }
}

// ---- paths that lose light -------------------------------------------------------------

// The mean of n paths along r, for each colour.
typedef struct {
    running of[3];
} colours;

static colours mean_light(const glass_room *sc, ray r, int s, int n, rng *g) {
    colours all = {0};
    for (int i = 0; i < n; i++) {
        const color L = glass_trace(sc, r, s, g);
        running_add(&all.of[0], (double)L.x);
        running_add(&all.of[1], (double)L.y);
        running_add(&all.of[2], (double)L.z);
    }
    return all;
}

static void check_truth(const char *what, const running *light, double expected) {
    given("%s: the mean of %ld paths", what, light->n);
    CHECK_REAL(light->mean, expected,
               standard_errors(5, running_standard_error(light) + 4e-7 +
                                      0.2 / (double)light->n * (light->m2 > 0)));
}

// Straight through, a parallel beam over the whole disc: ∫ e^(-2 sigma sqrt(R² - b²)) over
// it is 2 (1 - (1 + x) e^-x)/x², x = 2 sigma R.
static void coloured_sphere(void) {
    rng g = check_rng(71);
    const vec3 c = {1, -2, 3}, d = unit_vector(&g), s = across(d, &g), t = cross(d, s);
    const double R = 1.7, sigma[3] = {0.2, 1, 3};
    workshop w = {0};
    substance *of = add_sphere(&w, c, R, clear_glass(1, 0));
    of->sigma = (color){(real)sigma[0], (real)sigma[1], (real)sigma[2]};
    const glass_room *sc = workshop_open(&w, white_sky);
    colours all = {0};
    for (int i = 0; i < 20000; i++) {
        const double b = R * sqrt(rng_double(&g)), turn = 2 * PI * rng_double(&g);
        const vec3 aside = combine(b * cos(turn), s, b * sin(turn), t);
        const ray r = {add(c, sub(aside, scale(5, d))), d};
        const color L = glass_trace(sc, r, 2, &g);
        const double left = exp(-sigma[1] * 2 * sqrt(fmax(R * R - b * b, 0)));
        given("a sphere of index 1 that absorbs, seen at %.6g of its radius, green", b / R);
        CHECK_REAL(L.y, left,
                   absolute_of(4e-5 + 8 * sqrt(REAL_EPSILON) * (b > 0.99 * R),
                               "the way through is rounded, most at the rim"));
        running_add(&all.of[0], (double)L.x);
        running_add(&all.of[1], (double)L.y);
        running_add(&all.of[2], (double)L.z);
    }
    for (int k = 0; k < 3; k++) {
        const double x = 2 * sigma[k] * R;
        check_truth("a parallel beam through a sphere of index 1 that absorbs", &all.of[k],
                    2 * (1 - (1 + x) * exp(-x)) / (x * x));
    }
    workshop_close(&w);
}

// Two overlapping bodies of index 1: on each piece of the way the stronger one absorbs.
static void coloured_overlap(void) {
    for (int strong = 0; strong < 2; strong++) {
        rng g = check_rng(72);
        const vec3 d = unit_vector(&g), c = {1, -2, 3};
        workshop w = {0};
        add_sphere(&w, c, 1, clear_glass(1, strong ? 0 : 1))->sigma = grey(0.5);
        add_sphere(&w, add(c, scale((real)1.5, d)), 1, clear_glass(1, strong ? 1 : 0))->sigma =
            grey(2);
        const glass_room *sc = workshop_open(&w, white_sky);
        const ray r = {sub(c, scale(6, d)), d};
        given("along the axis through two spheres of radius 1, 1.5 apart, of index 1; sigma "
              "is 0.5, then 2; where they overlap, over 0.5, the %s one is there",
              strong ? "second" : "first");
        CHECK_VEC3(glass_trace(sc, r, 9, &g),
                   grey(strong ? exp(-1.5 * 0.5 - 2 * 2) : exp(-2 * 0.5 - 1.5 * 2)),
                   relative_to(1e-5, "the ways are rounded"));
        workshop_close(&w);
    }
}

// A ray into a sphere meets its surface at the same angle again and again: R on the way
// in, and each time the share 1 - R of what is left comes out.
static void tinted_glass(void) {
    const double n = 1.5, radius = 0.8, b[] = {0, 0.3, 0.7, 0.95}, sigma[] = {0, 0.4, 2};
    rng g = check_rng(73);
    for (int i = 0; i < COUNT(b); i++) {
        const vec3 c = {1, -2, 3}, d = unit_vector(&g), s = across(d, &g);
        workshop w = {0};
        substance *of = add_sphere(&w, c, radius, clear_glass(n, 0));
        of->sigma = (color){(real)sigma[0], (real)sigma[1], (real)sigma[2]};
        const glass_room *sc = workshop_open(&w, white_sky);
        const ray r = {add(c, combine(-3, d, b[i] * radius, s)), d};
        const colours L = mean_light(sc, r, LONG, 20000, &g);
        const double cosine = sqrt(1 - b[i] * b[i]), R = fresnel_exact(cosine, n);
        const double way = 2 * radius * far_cosine(cosine, n);
        for (int k = 0; k < 3; k++) {
            const double a = exp(-sigma[k] * way);
            check_truth("a glass sphere that absorbs, in a sky of 1: R + (1 - R)² a/(1 - R a)",
                        &L.of[k], R + (1 - R) * (1 - R) * a / (1 - R * a));
        }
        workshop_close(&w);
    }
}

// s counts what turns the path: every boundary that is seen.
static void glass_depths(void) {
    const double n = 1.8, R = straight_on(n, 0), T = 1 - R;
    const double inside = T * T, expected[] = {0, R, R + inside, R + inside * (1 + R),
                                               R + inside * (1 + R + R * R)};
    rng g = check_rng(74);
    workshop w = {0};
    add_sphere(&w, (vec3){1, 2, 3}, 1, clear_glass(n, 0));
    add_sphere(&w, (vec3){1, 2, 3}, 0.4, clear_glass(n, 1)); // a boundary that is not seen
    const glass_room *sc = workshop_open(&w, white_sky);
    const ray r = {{1, 2, 9}, {0, 0, -2}};
    for (int s = 0; s < COUNT(expected); s++) {
        const colours L = mean_light(sc, r, s, 20000, &g);
        char what[80];
        snprintf(what, sizeof what, "straight on a glass ball, n = 1.8, with s = %d", s);
        check_truth(what, &L.of[0], expected[s]);
    }
    workshop_close(&w);
}

// ---- lamps and metals in glass ---------------------------------------------------------

// A black ball that shines inside a glass ball, straight on: L (1 - R) / n² comes out.
static void lamp_in_glass(void) {
    const double n = 1.5, R = straight_on(n, 0), L = 3;
    rng g = check_rng(75);
    workshop w = {0};
    add_sphere(&w, (vec3){1, 2, 3}, 1, clear_glass(n, 0));
    add_sphere(&w, (vec3){1, 2, 3}, 0.3, (substance){.kind = OPAQUE});
    w.surfaces[1] = (surface){.lobe = LAMBERT, .emittance = grey(L)};
    const glass_room *sc = workshop_open(&w, white_sky);
    const colours seen = mean_light(sc, (ray){{1, 9, 3}, {0, -1, 0}}, LONG, 20000, &g);
    check_truth("a black ball of radiance 3 in glass, in a sky of 1, straight on: R + (1 - R) "
                "3/n²",
                &seen.of[0], R + (1 - R) * L / (n * n));
    workshop_close(&w);
}

// In balance: a body that shines (1 - albedo) n² in a medium of index n, under a sky of 1,
// cannot be told from it (Kirchhoff). In glass, in an air bubble, and in air.
static void in_balance(void) {
    const double n = 1.6, albedo = 0.6;
    rng g = check_rng(76);
    workshop w = {0};
    add_sphere(&w, (vec3){0, 0, 0}, 1, clear_glass(n, 0));
    add_sphere(&w, (vec3){(real)0.4, (real)0.1, 0}, 0.4, clear_glass(1, 1));
    add_sphere(&w, (vec3){(real)-0.5, 0, 0}, 0.3, (substance){.kind = OPAQUE});
    add_sphere(&w, (vec3){(real)0.4, (real)0.1, 0}, 0.2, (substance){.kind = OPAQUE});
    add_sphere(&w, (vec3){0, (real)1.6, 0}, 0.5, (substance){.kind = OPAQUE});
    for (int i = 2; i < 5; i++)
        w.surfaces[i] = (surface){.lobe = LAMBERT,
                                  .albedo = grey(albedo),
                                  .emittance = grey((1 - albedo) * (i == 2 ? n * n : 1))};
    const glass_room *sc = workshop_open(&w, white_sky);
    running light = {0};
    for (int i = 0; i < 30000; i++) {
        const color L = glass_trace(sc, towards((vec3){0, (real)0.3, 0}, 1.2, &g), LONG, &g);
        CHECK(is_finite(L) && L.x >= 0, "no light that is negative or not finite");
        running_add(&light, (double)L.x);
    }
    check_truth("bodies that shine (1 - albedo) n², in glass, in a bubble and in air, in a sky "
                "of 1: nothing to be seen",
                &light, 1);
    workshop_close(&w);
}

// A metal ball in the open, and in the middle of a glass ball, where its index counts
// relative to the glass: straight on R + (1 - R)² M/(1 - R M).
static void metals_in_glass(void) {
    rng g = check_rng(77);
    for (const metal *m = metals; m->name; m++) {
        workshop w = {0};
        add_sphere(&w, (vec3){1, 2, 3}, 1, (substance){.kind = METAL, .metal = m});
        const glass_room *sc = workshop_open(&w, white_sky);
        const ray r = {{1, (real)2.6, 9}, {0, 0, -3}};
        given("a ball of %s in a sky of 1, at sin θ = 0.6: R of the metal", m->name);
        CHECK_VEC3(glass_trace(sc, r, 3, &g), three(conductor_exact, 0.8, m->eta, m->k),
                   relative_to(1e-5, "sin θ is rounded"));
        workshop_close(&w);
    }
    const metal *copper = &metals[2];
    const double n = 1.5, R = straight_on(n, 0);
    workshop w = {0};
    add_sphere(&w, (vec3){1, 2, 3}, 1, clear_glass(n, 0));
    add_sphere(&w, (vec3){1, 2, 3}, 0.4, (substance){.kind = METAL, .metal = copper});
    const glass_room *sc = workshop_open(&w, white_sky);
    const colours L = mean_light(sc, (ray){{1, 2, 9}, {0, 0, -3}}, LONG, 20000, &g);
    const double M = straight_on((double)copper->eta.y / n, (double)copper->k.y / n);
    check_truth("copper inside glass, green: its index counts relative to the glass", &L.of[1],
                R + (1 - R) * (1 - R) * M / (1 - R * M));
    workshop_close(&w);
}

// ---- the list of media -----------------------------------------------------------------

// As the contract says it, by looking at everything.
static int now_by_hand(const int *entered, int count, const substance *of) {
    int best = -1;
    for (int i = 0; i < count; i++)
        if (best < 0 || of[entered[i]].priority >= of[entered[best]].priority) best = i;
    return best < 0 ? -1 : entered[best];
}

static void media_lists(void) {
    rng g = check_rng(78);
    for (int i = 0; i < 2000; i++) {
        substance of[6] = {{0}};
        for (int k = 0; k < 6; k++) of[k].priority = (int)(rng_bits(&g) % 3) - 1;
        media in = {0};
        int entered[6], count = 0;
        for (int step = 0; step < 12; step++) {
            const int body = (int)(rng_bits(&g) % 6);
            int at = 0;
            while (at < count && entered[at] != body) at++;
            in = media_pass(in, body, at == count);
            if (at == count)
                entered[count++] = body;
            else
                for (count--; at < count; at++) entered[at] = entered[at + 1];
            given("bodies entered and left at random; now inside of %d", count);
            CHECK_INT(in.count, count);
            CHECK_INT(media_now(&in, of), now_by_hand(entered, count, of));
        }
    }
}

static void media_limits(void) {
    media in = {0};
    substance of[MEDIA_MAX + 4] = {{0}};
    given("out of a body that the path never was in");
    CHECK_INT(media_pass(in, 3, false).count, 0);
    CHECK_INT(media_now(&in, of), -1);
    given("into the same body twice");
    CHECK_INT(media_pass(media_pass(in, 3, true), 3, true).count, 1);
    for (int i = 0; i < MEDIA_MAX + 4; i++) in = media_pass(in, i, true);
    given("%d bodies, one in the other: %d are seen", MEDIA_MAX + 4, MEDIA_MAX);
    CHECK_INT(in.count, MEDIA_MAX);
}

// ---- what the pictures claim: given ----------------------------------------------------

// From under a flat surface: below the critical angle n² (1 - R), beyond it nothing.
static void from_under_water(void) {
    const double n = 1.33, cosines[] = {1, 0.9, 0.8, 0.7, 0.67, 0.65, 0.4, 0.05};
    rng g = check_rng(80);
    const vec3 up = hand_n, x = {1, -2, 3};
    const plane surface_of_water = {x, up};
    const surface nothing = {.lobe = LAMBERT};
    const substance water = clear_glass(n, 0);
    const scene bodies = {.planes = &surface_of_water, .plane_count = 1, .sky = sky_above};
    glass_room sc = {lit(bodies, &nothing, BY_BALANCE), &water, {1, {0}}};
    for (int i = 0; i < COUNT(cosines); i++) {
        const double index = (double)water.n, c = cosines[i];
        const vec3 d = arriving(neg(up), across(up, &g), c);
        const double R = fresnel_exact(c, 1 / index);
        given("from under water, n = 1.33, at the cosine %g: n² (1 - R)", c);
        CHECK_REAL(window_light(index, c), index * index * (1 - R),
                   absolute_of(1e-9, "two ways to write it, in double"));
        const colours L = mean_light(&sc, (ray){sub(x, scale(2, up)), d}, 9, 20000, &g);
        check_truth("the sky of 1 from under water, and no light from below: n² (1 - R)",
                    &L.of[0], window_light(index, c));
    }
    lit_free(&sc.room);
}

// All the light that comes down: what came in from above.
static void window_balance(void) {
    enum { STEPS = 4000 };
    const double n = 1.5, critical = sqrt(1 - 1 / (n * n));
    double sum = 0;
    for (int i = 0; i < STEPS; i++) { // midpoints; c = critical + (1 - critical) u²
        const double u = (i + 0.5) / STEPS, c = critical + (1 - critical) * u * u;
        sum += window_light(n, c) * 2 * c * 2 * u * (1 - critical) / STEPS;
    }
    given("all light under the surface, n = 1.5, is what the sky sends in: 1 - 0.091777959342");
    CHECK_REAL(sum, 1 - 0.091777959342, absolute_of(1e-6, "midpoint rule"));
    given("the window's radius 2 below water: sin of its angle is 1/n");
    const double r = window_radius(1.33, 2);
    CHECK_REAL(r / hypot(r, 2), 1 / 1.33, absolute_of(1e-12, "double"));
}

// A ray near the axis, bent twice by refract, meets the axis in the focus.
static void focus_of_ball(void) {
    const double ns[] = {1.33, 1.5, 1.8};
    for (int i = 0; i < COUNT(ns); i++) {
        const double b = 0.01;
        const vec3 down = {0, -1, 0}, in = {(real)b, (real)sqrt(1 - b * b), 0};
        vec3 d = {0, 0, 0}, out = {0, 0, 0};
        refract(down, in, (real)ns[i], &d);
        const double chord = -2 * wide_dot(widen(in), widen(d));
        const vec3 at = combine(1, in, chord, d);
        refract(d, neg(at), (real)(1 / ns[i]), &out);
        given("a ray 0.01 off the axis of a ball of radius 1, n = %g, straight down", ns[i]);
        const double depth_of_the_crossing = (double)-at.y + (double)(at.x / out.x * out.y);
        CHECK_REAL(depth_of_the_crossing, ball_focus(ns[i]),
                   absolute_of(2e-3 + 1e3 * REAL_EPSILON,
                               "the ray is not on the axis; and 0.01 magnifies roundings"));
    }
}

// The caustic's light, forwards from the sun and backwards from the floor.
static void caustic_both_ways(void) {
    rng g = check_rng(81);
    const ball_lens B = {1.5, 2, 0.1};
    const double half = 0.6;
    running forwards = {0}, backwards = {0};
    for (int i = 0; i < 40; i++) {
        image map = caustic_forwards(&B, half, 8, 5000, &g);
        double sum = 0;
        for (int k = 0; k < 64; k++) sum += (double)map.pixels[k].y / 64;
        running_add(&forwards, sum);
        image_free(&map);
    }
    workshop w = {0};
    add_sphere(&w, (vec3){0, 0, 0}, 1, clear_glass(B.n, 0));
    const glass_room *sc = workshop_open(&w, small_sun);
    for (int i = 0; i < 200000; i++) {
        const double x = between(&g, -half, half), z = between(&g, -half, half);
        running_add(&backwards, caustic_backwards(sc, &B, x, z, &g));
    }
    workshop_close(&w);
    const double error =
        hypot(running_standard_error(&forwards), running_standard_error(&backwards));
    given("the mean light of a square under a ball of glass, forwards and backwards");
    CHECK_REAL(backwards.mean, forwards.mean, standard_errors(5.5, error));
}

// That of the caustic takes a while; the program makes it whenever it draws the picture.
static void window_proof(void) {
    rng g = check_rng(82);
    const options opt = {
        .width = 96, .height = 96, .samples = 64, .depth = 16, .seed = rng_bits(&g)};
    image window;
    given("a small picture of the sky from under water: how many of its claims fail");
    CHECK_INT(prove_window(&opt, &window), 0);
    image_free(&window);
}

static void rings(void) {
    image img = image_new(8, 8);
    for (int y = 0; y < 8; y++)
        for (int x = 0; x < 8; x++)
            *image_at(&img, x, y) =
                grey(hypot(x - 3.5, y - 3.5) < 2 ? 5 : 1 + (x > 3 ? 0.5 : 0));
    given("a disc of 5 in a ground of 1 and 1.5");
    CHECK_REAL(ring_mean(&img, 0, 2).value, 5, exactly());
    CHECK_REAL(ring_mean(&img, 0, 2).standard_error, 0, exactly());
    CHECK_REAL(ring_mean(&img, 2.5, 9).value, 1.25, exactly());
    given("5 ± 3 and 15 ± 4: 2 standard errors apart");
    CHECK_REAL(errors_apart((estimate){15, 4, 9}, (estimate){5, 3, 9}), 2, exactly());
    image_free(&img);
}

// ---- anything at all -------------------------------------------------------------------

static color some_color(rng *g, double most) {
    const double x = rng_double(g), y = rng_double(g), z = rng_double(g);
    return (color){(real)(most * x), (real)(most * y), (real)(most * z)};
}

static substance some_substance(rng *g, double size) {
    const uint32_t bits = rng_bits(g);
    if (bits % 8 == 0) return (substance){.kind = METAL, .metal = &metals[bits / 8 % 7]};
    if (bits % 4 == 1) return (substance){.kind = OPAQUE};
    substance s = clear_glass(1 + 2 * rng_double(g), (int)(bits / 64 % 3));
    if (bits & 1024) s.sigma = some_color(g, 2 / size);
    return s;
}

static surface some_surface(rng *g) {
    const uint32_t bits = rng_bits(g);
    surface s = {.lobe = bits & 1 ? GGX : LAMBERT,
                 .albedo = some_color(g, 1),
                 .alpha = (real)decades(g, -3, 0)};
    if (bits & 2) s.emittance = some_color(g, 5);
    return s;
}

static void fill(workshop *w, double size, rng *g) {
    const int spheres = 1 + (int)(rng_bits(g) % 5);
    for (int i = 0; i < spheres; i++) {
        const vec3 c = scale((real)size, in_cube(g));
        add_sphere(w, c, size * decades(g, -1.5, 0), some_substance(g, size));
    }
    const vec3 c = scale((real)size, in_cube(g)), half = absolute(in_cube(g));
    add_box(w, c, scale((real)size, add(half, grey(0.01))), some_substance(g, size));
    for (int i = 0; i < body_count(w); i++) w->surfaces[i] = some_surface(g);
}

static void random_rooms(void) {
    rng g = check_rng(79);
    for (int i = 0; i < 150; i++) {
        const double size = decades(&g, -4, 4);
        const int s = (int)(rng_bits(&g) % 60);
        workshop w = {0};
        fill(&w, size, &g);
        const glass_room *sc = workshop_open(&w, rng_bits(&g) & 1 ? white_sky : NULL);
        for (int k = 0; k < 150; k++) {
            const color L = glass_trace(sc, towards((vec3){0, 0, 0}, size, &g), s, &g);
            given("room %d: %d bodies, size %.3g, at most %d bounces; path %d brings " VEC, i,
                  body_count(&w), size, s, k, ARG(L));
            CHECK(is_finite(L), "light is finite");
            CHECK(L.x >= 0 && L.y >= 0 && L.z >= 0, "light is not negative");
        }
        workshop_close(&w);
    }
}

int main(void) {
    static const char *const snell = "Sines: sin θ_t = sin θ / eta, eta = n_t / n_i. t has a "
                                     "part in the surface, from d, and "
                                     "a part along -n, from cos θ_t.";
    static const char *const total =
        "What stands under the root of cos θ_t when sin θ / eta is above 1? Decide before you "
        "take it.";
    static const char *const digits = "Where are nearly equal numbers subtracted? eta² - sin² "
                                      "= (eta - 1)(eta + 1) + cos²; and "
                                      "double inside.";
    static const char *const fresnel = "r_s = (cos - eta cos_t)/(cos + eta cos_t), r_p = (eta "
                                       "cos - cos_t)/(eta cos + cos_t); R "
                                       "is the mean of their squares.";
    static const char *const slide =
        "R0 + (1 - R0)(1 - cos θ)^5: θ is the angle on the less dense side. Which side is that "
        "when eta < 1?";
    static const char *const decide =
        "One number decides: below R the mirrored direction, else the refracted one. The "
        "chance cancels against the share: the direction keeps its length.";
    static const char *const conductor =
        "As for glass, but cos θ_t is complex: (a + i b)² = (eta + i k)² - sin² θ.";
    static const char *const beer = "Half the light on a way, half of that on the next: which "
                                    "function of sigma t does that, and what is 0 times "
                                    "infinity?";
    static const char *const given_code =
        "Given code, and your exercises in it: did they pass?";
    static const test tests[] = {
        {"refract: worked out by hand", snell_by_hand, snell},
        {"refract: 20,000 generic surfaces", snell_generic, snell},
        {"refract: total reflection, to a millionth beyond the critical angle",
         total_reflection, total},
        {"refract: just within the critical angle", nearly_total,
         "Little is left under the root, but it is above 0: it wants all digits (double), and "
         "no epsilon."},
        {"refract: back the same way", refract_back, snell},
        {"refract: the same index on both sides", same_index,
         "With eta = 1 nothing is bent. Which number is subtracted from a nearly equal one?"},
        {"refract: along the surface", along_surface,
         "cos θ = 0 is an angle like any other. Only *above* 1 is a sine impossible: what if "
         "it is 1?"},
        {"fresnel_dielectric: straight on", reflect_straight, fresnel},
        {"fresnel_dielectric: Brewster's angle", brewster, fresnel},
        {"fresnel_dielectric: along the surface", grazing,
         "At cos θ = 0 everything is reflected; is your quotient 0/0 there?"},
        {"fresnel_dielectric: the same index on both sides", no_boundary,
         "No boundary reflects nothing, at any angle; 0/0 at cos θ = 0?"},
        {"fresnel_dielectric: higher precision, into and out of glass", reflect_generic,
         fresnel},
        {"fresnel_dielectric: eta near 1", reflect_nearly_nothing, digits},
        {"fresnel_dielectric: at the critical angle", reflect_critical,
         "Total reflection begins where sin θ / eta is above 1: is that decided before the "
         "root? "
         "Close to it little is left under the root: double inside."},
        {"fresnel_dielectric: the same from both sides", reciprocity, fresnel},
        {"fresnel_dielectric: diffuse light", diffuse_light, fresnel},
        {"schlick: from outside", schlick_outside, slide},
        {"schlick: straight on", schlick_straight, slide},
        {"schlick: inside glass at 41°", schlick_at_41, slide},
        {"schlick: from inside", schlick_inside, slide},
        {"schlick: total reflection", schlick_total,
         "Beyond the critical angle there is no angle outside: everything is reflected."},
        {"schlick: the same index on both sides", schlick_nothing,
         "No boundary reflects nothing, whatever the formula says."},
        {"schlick: diffuse light", schlick_diffuse, slide},
        {"schlick: its largest errors", schlick_errors, slide},
        {"glass_bounce: one of two directions", two_directions, decide},
        {"glass_bounce: the share that is mirrored is R", share_mirrored, decide},
        {"glass_bounce: total reflection", always_mirrored, total},
        {"glass_bounce: at the critical angle", nearly_total_bounce,
         "A rounding decides there, and not the same one for R and for refract. What if R "
         "says through, but refract says false?"},
        {"glass_bounce: draws at most one number", draws_once,
         "Draw once; then compare as often as you like."},
        {"glass_bounce: the same g, the same draw", draws_from_g,
         "Whatever is drawn comes from g."},
        {"glass_bounce: the same index on both sides", never_mirrored, decide},
        {"glass_bounce: cosines that rounding made impossible", rounded_cosines,
         "-d·n may be 1.0000001, or a little below 0. What does fresnel_dielectric make of "
         "that, or refract?"},
        {"fresnel_conductor: straight on", conductor_straight, conductor},
        {"fresnel_conductor: the metals at all angles", conductor_metals, conductor},
        {"fresnel_conductor: 5000 generic conductors", conductor_generic, conductor},
        {"fresnel_conductor: without k it is glass", conductor_without_k, conductor},
        {"fresnel_conductor: along the surface", conductor_grazing, conductor},
        {"absorb: e^(-sigma t)", absorb_by_hand, beer},
        {"absorb: clear media, and no way at all", absorb_nothing, beer},
        {"absorb: a way in two parts", absorb_in_parts, beer},
        {"absorb: tiny and huge", absorb_extremes, beer},
        {"metals: as published, and Schlick's error for them", metal_table, given_code},
        {"schlick_slide: the slide's formula", slide_formula, given_code},
        {"glass_trace: clear spheres show the sky", clear_spheres, given_code},
        {"glass_trace: clear glass of any size", clear_scales, given_code},
        {"glass_trace: nested", clear_nested, given_code},
        {"glass_trace: overlapping", clear_overlapping, given_code},
        {"glass_trace: touching", clear_touching, given_code},
        {"glass_trace: boxes, and a bubble", clear_boxes, given_code},
        {"glass_trace: from inside", clear_from_inside, given_code},
        {"glass_trace: a beam through a sphere that absorbs", coloured_sphere, given_code},
        {"glass_trace: which of two absorbs", coloured_overlap, given_code},
        {"glass_trace: tinted glass", tinted_glass, given_code},
        {"glass_trace: s = 0, 1, 2", glass_depths, given_code},
        {"glass_trace: a lamp in glass", lamp_in_glass, given_code},
        {"glass_trace: in balance", in_balance, given_code},
        {"glass_trace: metals, and copper in glass", metals_in_glass, given_code},
        {"glass_trace: 150 rooms of anything", random_rooms, given_code},
        {"window_light: from under water", from_under_water, given_code},
        {"window_light: all light is accounted for", window_balance, given_code},
        {"ball_focus: by refract", focus_of_ball, given_code},
        {"caustic_forwards: the same backwards", caustic_both_ways, given_code},
        {"ring_mean: by hand", rings, given_code},
        {"prove_window: on a small picture", window_proof, given_code},
        {"media_pass: in and out of six bodies", media_lists, given_code},
        {"media_pass: limits", media_limits, given_code},
    };
    return run_tests("11-fresnel", tests, COUNT(tests));
}
