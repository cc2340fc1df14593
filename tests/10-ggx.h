// 10-ggx.h: the part of 10-importance-sampling.c about rough mirrors.
#ifndef TESTS_10_GGX_H
#define TESTS_10_GGX_H

#include "chapters/10-importance-sampling/importance.h"
#include "tests/check-directions.h"

// ---- ggx_normal ----------------------------------------------------------------------

static const real alphas[] = {(real)0.5, (real)0.1, 1, (real)0.001};
static const double heights[] = {0.7, 1, 0.2, 1e-3, 0}; // of o: o.z

// A local direction of the given height: a unit vector but for its rounding.
static vec3 from_height(double z, rng *g) {
    const double angle = between(g, 0, 2 * PI), s = sqrt(1 - z * z);
    return (vec3){(real)(s * cos(angle)) + 0, (real)(s * sin(angle)) + 0, (real)z}; // no -0
}

// The row i of alphas x heights.
enum { VIEWS = COUNT(alphas) * COUNT(heights) };
static real view(int i, vec3 *o, rng *g) {
    *o = from_height(heights[i / COUNT(alphas) % COUNT(heights)], g);
    return alphas[i % COUNT(alphas)];
}

#define GIVEN_VIEW(o, alpha, what) \
    given("o = " VEC ", alpha = %g: " what, ARG(o), (double)(alpha))

// o.z / G1(o), times 2.
static double twice_in_view(vec3 o, double alpha) {
    const double across = (double)o.x * o.x + (double)o.y * o.y;
    return o.z + sqrt((double)o.z * o.z + alpha * alpha * across);
}

static void check_seen(vec3 o, real alpha, vec3 h, const char *draw) {
    given("o = " VEC ", alpha = %g, %s: " VEC ", with o·h = %.3g", ARG(o), (double)alpha, draw,
          ARG(h), cosine(o, h));
    CHECK(is_finite(h), "finite, no NaN");
    CHECK_REAL(wide_length(h), 1, roundings(16, "a unit vector: normalize comes last"));
    CHECK(h.z >= 0, "h.z >= 0: a surface has no normals that point into it");
    // Where h has hardly any height rounding turns it by more than its own digits.
    CHECK(cosine(o, h) >= BELOW_BY_ROUNDING - 0.05 * twice_in_view(o, alpha),
          "o·h >= 0: a normal that is turned away from o is not seen from there");
}

static void normal_seen(void) {
    rng g = check_rng(61);
    for (int i = 0; i < 10 * VIEWS; i++) {
        vec3 o;
        const real alpha = view(i, &o, &g);
        GIVEN_VIEW(o, alpha, "draws of ggx_normal");
        repeats r = {0};
        for (int k = 0; k < 200; k++) {
            const vec3 h = ggx_normal(o, alpha, &g);
            check_seen(o, alpha, h, "a draw");
            count_repeat(&r, h);
        }
        GIVEN_VIEW(o, alpha, "200 draws, most of them the first again");
        CHECK(r.alike < 100, "the draws differ: is g used, and handed on?");
    }
}

// Stretched by alpha the normals are a hemisphere's, and what that mirrors of the
// direction w, which o becomes, lies uniformly in the part of the sphere above -w.z.
typedef struct {
    wide3 w, mirrored;
} stretched_view;

static stretched_view stretch(vec3 o, wide3 h, double alpha) {
    const wide3 w = wide_unit((wide3){alpha * o.x, alpha * o.y, o.z});
    const wide3 m = wide_unit((wide3){h.x / alpha, h.y / alpha, h.z});
    const double k = 2 * wide_dot(w, m);
    return (stretched_view){w, {k * m.x - w.x, k * m.y - w.y, k * m.z - w.z}};
}

// Uniform in [0, 1] for a right sampler; below 0 for a normal that is not seen.
static double height_seen(vec3 o, wide3 h, double alpha) {
    const stretched_view s = stretch(o, h, alpha);
    return (s.w.z + s.mirrored.z) / (1 + s.w.z);
}

// Normals drawn otherwise.
enum { ALL_NORMALS, UNSTRETCHED, HEMISPHERE, HALF_SPHERE, NOT_BACK, OTHER_WAYS };
static const char *const other_ways[OTHER_WAYS] = {
    [ALL_NORMALS] = "all normals of the surface, with the density D h.z, not those seen from o",
    [UNSTRETCHED] = "o itself was not stretched by alpha",
    [HEMISPHERE] = "uniform over the stretched hemisphere, as if o did not matter",
    [HALF_SPHERE] = "what is mirrored was drawn above the horizon: it goes down to -w.z",
    [NOT_BACK] = "the normal was not stretched back by alpha",
};

static wide3 other_normal(int how, vec3 o, double alpha, rng *g) {
    const double phi = between(g, 0, 2 * PI), u = rng_double(g);
    if (how == ALL_NORMALS) { // by D h.z
        const double tangent = alpha * sqrt(u / (1 - u));
        return (wide3){tangent * cos(phi), tangent * sin(phi), 1};
    }
    const double there = how == UNSTRETCHED ? 1 : alpha, back = how == NOT_BACK ? 1 : alpha;
    const wide3 w = how == HEMISPHERE ? (wide3){0, 0, 0}
                                      : wide_unit((wide3){there * o.x, there * o.y, o.z});
    const double lowest = how == HALF_SPHERE ? 0 : -w.z;
    const double z = 1 - u * (1 - lowest), s = sqrt(fmax(1 - z * z, 0));
    return (wide3){back * (s * cos(phi) + w.x), back * (s * sin(phi) + w.y), z + w.z};
}

static double other_mean(int how, vec3 o, double alpha, rng *g) {
    double sum = 0;
    enum { DRAWS = 100000 };
    for (int i = 0; i < DRAWS; i++)
        sum += height_seen(o, other_normal(how, o, alpha, g), alpha);
    return sum / DRAWS;
}

// Worth the time to ask what it looks like? CHECK_MEAN itself allows 5.
static bool looks_off(const running *s, double expected) {
    return !(fabs(s->mean - expected) <= 4 * running_standard_error(s));
}

static void normal_mean(void) {
    rng g = check_rng(62);
    for (int i = 0; i < VIEWS; i++) {
        vec3 o;
        const real alpha = view(i, &o, &g);
        GIVEN_VIEW(o, alpha, "draws of ggx_normal");
        running height = {0};
        for (int k = 0; k < 40000; k++)
            running_add(&height, height_seen(o, widen(ggx_normal(o, alpha, &g)), alpha));
        GIVEN_VIEW(o, alpha,
                   "a number that is uniform from 0 to 1 for the normals seen from o "
                   "(how high the stretched normal mirrors o), its mean over 40,000 "
                   "draws");
        for (int how = 0; looks_off(&height, 0.5) && how < OTHER_WAYS; how++)
            suspect_value(other_ways[how], other_mean(how, o, alpha, &g));
        CHECK_MEAN("the mean height", &height, 0.5, 1e-5);
    }
}

static void normal_cells(void) {
    rng g = check_rng(63);
    for (int i = 0; i < VIEWS; i++) {
        vec3 o;
        const real alpha = view(i, &o, &g);
        GIVEN_VIEW(o, alpha, "draws of ggx_normal");
        tally t = {0};
        for (int k = 0; k < 25000; k++) {
            const stretched_view s = stretch(o, widen(ggx_normal(o, alpha, &g)), alpha);
            tally_add(&t, (s.w.z + s.mirrored.z) / (1 + s.w.z),
                      atan2(s.mirrored.y, s.mirrored.x) / (2 * PI) + 0.5);
        }
        GIVEN_VIEW(o, alpha,
                   "25,000 normals counted in 8 x 12 cells, all equally likely for "
                   "those seen from o");
        CHECK_UNIFORM(&t);
    }
}

static void normal_rare(void) {
    rng g = check_rng(64);
    for (int i = 0; i < 4 * RARE; i++) {
        vec3 o;
        const real alpha = view(i / 4, &o, &g);
        GIVEN_VIEW(o, alpha, "draws of ggx_normal");
        rng rare = drawing_rare(i);
        const vec3 h = ggx_normal(o, alpha, &rare);
        check_seen(o, alpha, h,
                   i % 2 ? "where rng_real gives exactly 0" : "where rng_real gives almost 1");
    }
}

static void normal_from_g(void) {
    rng g = check_rng(94);
    for (int i = 0; i < 10 * VIEWS; i++) {
        vec3 o;
        const real alpha = view(i, &o, &g);
        rng one = rng_seed(1, (uint64_t)i), other = one;
        GIVEN_VIEW(o, alpha, "draws of ggx_normal");
        const vec3 first = ggx_normal(o, alpha, &one), second = ggx_normal(o, alpha, &other);
        given("o = " VEC ", alpha = %g, " ASKED_TWICE, ARG(o), (double)alpha, ARG(first),
              ARG(second));
        check_from_g(first, second);
    }
}

enum { ENERGY_DRAWS = 60000 };

static vec3 lit_from(bool straight, rng *g) {
    return from_height(straight ? 1 : sqrt(rng_double(g)), g);
}

static double energy_otherwise(int how, bool straight, real alpha, rng *g) {
    double sum = 0;
    for (int k = 0; k < ENERGY_DRAWS; k++) {
        const vec3 o = lit_from(straight, g);
        const vec3 h = narrow(wide_unit(other_normal(how, o, alpha, g)));
        sum += ggx_weight(o, neg(reflect(o, h)), alpha);
    }
    return sum / ENERGY_DRAWS;
}

// Which share of the light a rough mirror of F = 1 sends out again, by one bounce: the mean
// over all directions, and straight on. Independent integration; 1 - ln 2 in closed form.
static void normal_energy(void) {
    static const struct {
        double alpha, albedo;
    } rows[] = {{0.1, 0.97205}, {0.3, 0.84687}, {0.5, 0.70024},
                {0.8, 0.50787}, {1, 0.40914},   {-1, 0.306852819440}};
    rng g = check_rng(65);
    for (int i = 0; i < COUNT(rows); i++) {
        const real alpha = (real)fabs(rows[i].alpha);
        const bool straight = rows[i].alpha < 0;
        running light = {0};
        for (int k = 0; k < ENERGY_DRAWS; k++) {
            const vec3 o = lit_from(straight, &g);
            const vec3 h = ggx_normal(o, alpha, &g), v = neg(reflect(o, h));
            running_add(&light, ggx_weight(o, v, alpha));
        }
        given(
            "a rough mirror of F = 1, alpha = %g: the share of the light that one bounce sends "
            "out, by 60,000 draws%s",
            (double)alpha, straight ? ", o straight above" : " from all directions");
        for (int how = 0; looks_off(&light, rows[i].albedo) && how < OTHER_WAYS; how++)
            suspect_value(other_ways[how], energy_otherwise(how, straight, alpha, &g));
        CHECK_MEAN("the share of the light", &light, rows[i].albedo, 1e-6);
    }
}

// ---- ggx_normal_probability -------------------------------------------------------------

static double wide_density(wide3 h, double alpha) {
    const double a = alpha * alpha, k = (h.x * h.x + h.y * h.y) / a + h.z * h.z;
    return h.z > 0 ? 1 / (PI * a * k * k) : 0;
}

static double wide_seen(vec3 o, wide3 h, double alpha) {
    const double c = fmax(wide_dot(widen(o), h), 0);
    return 2 * c * wide_density(h, alpha) / twice_in_view(o, alpha);
}

// A normal whose slopes are of the size of alpha.
static vec3 likely_normal(real alpha, rng *g) {
    const double tangent = alpha * 2 * rng_double(g), phi = between(g, 0, 2 * PI);
    const vec3 h = {(real)(tangent * cos(phi)), (real)(tangent * sin(phi)), 1};
    return normalize(h);
}

static void suspect_densities(vec3 o, wide3 h, double alpha) {
    const double c = wide_dot(widen(o), h), D = wide_density(h, alpha);
    const double G = 2 / twice_in_view(o, alpha), a = sqrt(alpha); // G1 / o.z
    suspect_value("D h.z: all normals, whether o sees them or not", D * h.z);
    suspect_value("D alone", D);
    suspect_value("G1 D / o.z: o·h is missing", G * D);
    suspect_value("G1 (o·h) D: not divided by o.z", G * c * D * o.z);
    suspect_value("(o·h) D / o.z: G1 is missing", c * D / o.z);
    suspect_value("divided by 4 (o·h): that is the density of the mirrored direction, not of h",
                  G * D / 4);
    suspect_value("D with alpha where alpha² belongs", G * c * wide_density(h, a));
    suspect_value("alpha where alpha² belongs",
                  2 * c * wide_density(h, a) / twice_in_view(o, a));
    suspect_value("G1 with alpha where alpha² belongs", 2 * c * D / twice_in_view(o, a));
}

static void seen_density(void) {
    rng g = check_rng(71);
    for (int i = 0; i < 200 * VIEWS; i++) {
        vec3 o;
        const real alpha = view(i, &o, &g);
        const vec3 h = likely_normal(alpha, &g);
        const wide3 H = widen(h);
        const double c = wide_dot(widen(o), H);
        if (c <= 0) continue;
        // A rounding of each of the three terms of o·h, relative to their sum.
        const double terms = fabs((double)o.x * h.x) + fabs((double)o.y * h.y) + o.z * h.z;
        given("o = " VEC ", h = " VEC ", alpha = %g: o·h = %.6g", ARG(o), ARG(h), (double)alpha,
              c);
        suspect_densities(o, H, alpha);
        CHECK_REAL(ggx_normal_probability(o, h, alpha), wide_seen(o, H, alpha),
                   relative_to(REAL_EPSILON * (12 + 3 * terms / c),
                               "some roundings, and those of o·h"));
    }
}

static void unseen_density(void) {
    rng g = check_rng(72);
    for (int i = 0; i < 100 * VIEWS; i++) {
        vec3 o;
        const real alpha = view(i, &o, &g);
        const vec3 h = generic_unit(&g);
        if (cosine(o, h) > BELOW_BY_ROUNDING && h.z > 0) continue;
        given("o = " VEC ", h = " VEC ", alpha = %g: o·h = %.3g, h.z = %.3g", ARG(o), ARG(h),
              (double)alpha, cosine(o, h), (double)h.z);
        suspect_value("negative: the side of a normal that is turned away is not seen",
                      2 * cosine(o, h) * wide_density(widen(h), alpha) /
                          twice_in_view(o, alpha));
        CHECK_REAL(ggx_normal_probability(o, h, alpha), 0, exactly());
    }
}

// In stretched coordinates, which resolve any alpha: h = A m / |A m|, A = diag(alpha, alpha,
// 1), m on the hemisphere, and dh = det A / |A m|³ dm.
static double integral_seen(vec3 o, real alpha, int n) {
    double sum = 0;
    for (int i = 0; i < n; i++) {
        const double z = (i + 0.5) / n, s = sqrt(1 - z * z);
        for (int k = 0; k < 2 * n; k++) {
            const double phi = PI * (k + 0.5) / n;
            const wide3 a = {alpha * s * cos(phi), alpha * s * sin(phi), z};
            const double square = wide_dot(a, a), size = sqrt(square);
            const vec3 h = narrow((wide3){a.x / size, a.y / size, z / size});
            sum += (double)ggx_normal_probability(o, h, alpha) / (square * size);
        }
    }
    return sum * alpha * alpha * PI / ((double)n * n);
}

static void seen_whole(void) {
    rng g = check_rng(73);
    for (int i = 0; i < VIEWS; i++) {
        vec3 o;
        const real alpha = view(i, &o, &g);
        GIVEN_VIEW(o, alpha,
                   "the integral of the density over all normals, by the midpoint rule");
        const double integral = integral_seen(o, alpha, 100);
        CHECK_REAL(integral, 1, relative_to(1e-3, "the midpoint rule with 100 x 200 points"));
    }
}

// The draws whose slopes lie in a disc of radius alpha/2, 0.8 alpha from the pole on o's side:
// 1/p is the solid angle that each stands for.
static bool in_patch(vec3 o, vec3 h, double alpha) {
    const double flat = sqrt((double)o.x * o.x + (double)o.y * o.y);
    const double a = flat > 0 ? o.x / flat : 1, b = flat > 0 ? o.y / flat : 0;
    const double p = h.x / (alpha * h.z) - 0.8 * a, q = h.y / (alpha * h.z) - 0.8 * b;
    return p * p + q * q < 0.25;
}

static double patch_size(double alpha) {
    double sum = 0;
    enum { N = 200 };
    for (int i = 0; i < N; i++) {
        for (int k = 0; k < N; k++) {
            const double r = 0.5 * (i + 0.5) / N, phi = 2 * PI * (k + 0.5) / N;
            const double p = alpha * (0.8 + r * cos(phi)), q = alpha * r * sin(phi);
            sum += r * pow(1 + p * p + q * q, -1.5);
        }
    }
    return sum * alpha * alpha * 0.5 / N * 2 * PI / N;
}

static void seen_belongs(void) {
    rng g = check_rng(74);
    for (int i = 0; i < VIEWS; i++) {
        vec3 o;
        const real alpha = view(i, &o, &g);
        GIVEN_VIEW(o, alpha, "draws of ggx_normal");
        running all = {0};
        for (int k = 0; k < 10000; k++) {
            const vec3 h = ggx_normal(o, alpha, &g);
            if (!in_patch(o, h, alpha)) {
                running_add(&all, 0);
                continue;
            }
            const double p = ggx_normal_probability(o, h, alpha);
            given("o = " VEC ", alpha = %g, h = " VEC " by ggx_normal: p = %.9g", ARG(o),
                  (double)alpha, ARG(h), p);
            const bool p_is_positive = p > 0;
            CHECK(p_is_positive, "p > 0 for a normal that ggx_normal draws");
            running_add(&all, 1 / p);
        }
        GIVEN_VIEW(o, alpha,
                   "the mean of 1/p over the draws that fall into a patch of normals: "
                   "the patch's solid angle");
        CHECK_MEAN("the mean of 1/p", &all, patch_size(alpha), 1e-4 * patch_size(alpha));
    }
}

// ---- GGX: the given parts ----------------------------------------------------------------

static void ggx_density_whole(void) {
    for (int i = 0; i < COUNT(alphas); i++) {
        const double alpha = alphas[i];
        double sum = 0;
        enum { N = 4000 };
        for (int k = 0; k < N; k++) { // sin² of the stretched angle is uniform
            const double u = (k + 0.5) / N, t2 = alpha * alpha * u / (1 - u);
            const double z = 1 / sqrt(1 + t2), s = sqrt(t2) * z;
            const vec3 h = {(real)(s * 0.6), (real)(s * -0.8), (real)z};
            // d(tan²) = alpha² / (1-u)² du, dh = π cos³ d(tan²)
            const double dh = PI * z * z * z * alpha * alpha / ((1 - u) * (1 - u)) / N;
            sum += (double)ggx_density(h, (real)alpha) * z * dh;
        }
        given("alpha = %g: the integral of D(h) h.z over the hemisphere", alpha);
        CHECK_REAL(sum, 1,
                   relative_to(20 * REAL_EPSILON + 1e-12,
                               "a constant integrand, rounded and added up"));
    }
}

static void ggx_reciprocal(void) {
    rng g = check_rng(84);
    for (int i = 0; i < 3000; i++) {
        const real alpha = alphas[i % COUNT(alphas)];
        const vec3 o = from_height(rng_double(&g), &g);
        const vec3 v = i % 2 ? from_height(rng_double(&g), &g)
                             : from_height(pow(10, -6 * rng_double(&g)), &g);
        given("o = " VEC ", v = " VEC ", alpha = %g", ARG(o), ARG(v), (double)alpha);
        const real there = ggx_brdf(o, v, alpha), back = ggx_brdf(v, o, alpha);
        CHECK(isfinite(there) && there >= 0, "finite and not negative");
        CHECK_REAL(back, there, roundings(4, "the same terms, added the other way round"));
        CHECK_REAL(ggx_brdf(neg(o), v, alpha), 0, exactly());
        CHECK_REAL(ggx_brdf(o, neg(v), alpha), 0, exactly());
    }
    const real tiny = REAL_MIN; // o + v is all rounding
    given("o = (1, 0, tiny), v = (-1, 0, tiny)");
    CHECK(isfinite(ggx_brdf((vec3){1, 0, tiny}, (vec3){-1, 0, tiny}, 1)), "finite, no NaN");
}

// alpha = 1, o straight above: 2π ∫ f_r cos θ dcos θ = 1 - ln 2, by the midpoint rule.
static void ggx_straight_on(void) {
    double sum = 0;
    enum { N = 1000 };
    for (int i = 0; i < N; i++) {
        const double z = (i + 0.5) / N, s = sqrt(1 - z * z);
        const vec3 v = {(real)(s * 0.6), (real)(s * 0.8), (real)z};
        sum += 2 * PI * z * (double)ggx_brdf((vec3){0, 0, 1}, v, 1) / N;
    }
    given(
        "alpha = 1, F = 1, o straight above: the share of the light that one bounce sends out");
    CHECK_REAL(sum, 1 - log(2.0), relative_to(1e-5, "the midpoint rule with 1000 points"));
}

static void ggx_weight_belongs(void) {
    rng g = check_rng(85);
    for (int i = 0; i < 200 * VIEWS; i++) {
        vec3 o;
        const real alpha = view(i, &o, &g);
        if (o.z == 0) continue;
        const vec3 h = ggx_normal(o, alpha, &g), v = neg(reflect(o, h));
        const double c = cosine(o, h);
        if (v.z < 0.01 || c < 0.01) continue;
        // f_r v.z / p, with the p of the mirrored direction, p(h) / (4 o·h).
        const double f = ggx_brdf(o, v, alpha), p = wide_seen(o, widen(h), alpha) / (4 * c);
        given("o = " VEC ", alpha = %g, v = " VEC ": f_r v.z / p", ARG(o), (double)alpha,
              ARG(v));
        // h comes back from o + v with roundings, of which alpha makes 1/alpha as much in D.
        CHECK_REAL(ggx_weight(o, v, alpha), f * v.z / p,
                   relative_to(100 * REAL_EPSILON / c * (1 + 1 / (double)alpha),
                               "h from o + v again, rounded, seen against alpha"));
        CHECK(ggx_weight(o, v, alpha) <= 1 + 4 * REAL_EPSILON, "at most 1: G2 <= G1");
    }
}

#endif
