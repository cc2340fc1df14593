// 10-sphere.h: the part of 10-importance-sampling.c about the cone in which a sphere is seen.
#ifndef TESTS_10_SPHERE_H
#define TESTS_10_SPHERE_H

#include "chapters/10-importance-sampling/importance.h"
#include "tests/check-directions.h"

// ---- sphere_direction --------------------------------------------------------------

// A sphere as seen from x: the axis to its centre, and 1 - cos θ_max.
typedef struct {
    wide3 axis;
    double distance, far, width; // far: r / distance; width: 1 - cos θ_max
} cone;

static cone cone_of(sphere S, vec3 x) {
    const exact3 w = exact_sub(S.c, x);
    const exact square = exact_dot(w, w), r2 = (exact)S.r * S.r;
    const double width = (double)(r2 / (square + exact_sqrt(square * (square - r2))));
    const double d = (double)exact_sqrt(square);
    return (cone){{(double)w.x / d, (double)w.y / d, (double)w.z / d}, d, S.r / d, width};
}

// (1 - cos θ) / (1 - cos θ_max), uniform in [0, 1]. 1 - cos θ is half the square of v - axis.
static double height_in(cone k, vec3 v) {
    const double size = wide_length(v);
    const wide3 off = {v.x / size - k.axis.x, v.y / size - k.axis.y, v.z / size - k.axis.z};
    return wide_dot(off, off) / 2 / k.width;
}

// How far beyond the rim the roundings of v, and of the cone, may put a draw: in heights.
static double rim(cone k) {
    const double inside = 32 * DBL_EPSILON / sqrt(1 - k.far * k.far); // near r = d, in double
    return 8 * (double)REAL_EPSILON * k.far / k.width + inside;
}

static sphere sphere_at(vec3 x, double distance, double r, rng *g) {
    return (sphere){add(x, scale((real)distance, generic_unit(g))), (real)r};
}

// Seen large and small, tiny and huge themselves, from near and far: distance and radius.
static const double seen[][2] = {{1.5, 1.2},   {3, 1},          {1.01, 1},    {40, 1},
                                 {1e4, 1},     {3e-7, 1e-7},    {5e-8, 2e-9}, {2e7, 1.5e7},
                                 {1.00001, 1}, {1.0001e6, 1e6}, {1e3, 1},     {8e9, 7e8}};

// x near the origin, so that rounding S.c does not change much what is seen.
static sphere seen_sphere(int i, vec3 *x, rng *g) {
    const double *s = seen[i % COUNT(seen)];
    *x = scale((real)s[0], in_cube(g));
    sphere S;
    do S = sphere_at(*x, s[0], s[1], g);
    while (!(cone_of(S, *x).far < 1));
    return S;
}

#define GIVEN_SPHERE(S, x, what)                                                          \
    given("sphere c = " VEC ", r = %.9g, seen from x = " VEC ", r/|x - c| = %.9g: " what, \
          ARG((S).c), (double)(S).r, ARG(x), cone_of(S, x).far)

// How much too high a draw may be when all is right but worked out in real: some roundings of a
// direction, and of cos² θ_max = 1 - r²/d², of which close to the sphere cos θ_max makes more.
static double of_rounding(cone k) {
    return 4 * (double)REAL_EPSILON / k.width * (1 + 1 / sqrt(1 - k.far * k.far));
}

// What is wrong with a draw of this height, and what to look at.
static const char *beside(cone k, vec3 v, double height) {
    if (wide_dot(widen(v), k.axis) < 0 && k.width < 0.9) {
        hint_instead("Which way does the axis point? It goes from x to the centre.");
        return "the ray (x, v) meets the sphere; this one points away from it: the axis goes "
               "from x to the centre";
    }
    if (height < 1 + of_rounding(k)) {
        hint_instead("So little is what rounding does. Work in double from the first "
                     "difference on, and round nothing but the finished direction.");
        return "the ray (x, v) meets the sphere; this one misses it by a rounding: double "
               "inside?";
    }
    return "the ray (x, v) meets the sphere: v lies in the cone";
}

static void check_meets(sphere S, vec3 x, vec3 v) {
    const cone k = cone_of(S, x);
    GIVEN_SPHERE(S, x, "a draw");
    CHECK(is_finite(v), "finite, no NaN");
    CHECK_REAL(wide_length(v), 1, roundings(16, "a unit vector, made by a frame"));
    const double height = height_in(k, v);
    given("sphere c = " VEC ", r = %.9g, seen from x = " VEC ": the draw " VEC
          " has (1 - cos θ) / (1 - cos θ_max) = %.9g",
          ARG(S.c), (double)S.r, ARG(x), ARG(v), height);
    const bool in_the_cone = height <= 1 + rim(k);
    if (!in_the_cone) CHECK(in_the_cone, beside(k, v, height));
}

static void sphere_meets(void) {
    rng g = check_rng(11);
    for (int i = 0; i < 1200; i++) {
        vec3 x;
        const sphere S = seen_sphere(i, &x, &g);
        repeats r = {0};
        for (int k = 0; k < 50; k++) {
            GIVEN_SPHERE(S, x, "a draw");
            const vec3 v = sphere_direction(S, x, &g);
            check_meets(S, x, v);
            count_repeat(&r, v);
        }
        if (cone_of(S, x).far < 0.01) continue; // tiny: another mistake's test
        GIVEN_SPHERE(S, x, "50 draws, most of them the first again");
        CHECK(r.alike < 25, "the draws differ: is g used, and handed on?");
    }
}

// What the height would be on average for a uniform point of the sphere (whole: the far
// side too), by its angle at the centre.
static double height_by_area(double far, bool whole) {
    const double cos_max = sqrt(1 - far * far), width = far * far / (1 + cos_max);
    const double lowest = whole ? -1 : far;
    double sum = 0;
    enum { STEPS = 20000 };
    for (int i = 0; i < STEPS; i++) {
        const double c = lowest + (1 - lowest) * (i + 0.5) / STEPS, s = sqrt(1 - c * c);
        sum += (1 - cos(atan2(far * s, 1 - far * c))) / width;
    }
    return sum / STEPS;
}

static const char *const spread =
    "the draws spread over the cone, not only its middle: did 1 - cos θ_max cancel to 0?";

static void sphere_mean(void) {
    rng g = check_rng(12);
    for (int i = 0; i < 2 * COUNT(seen); i++) {
        vec3 x;
        const sphere S = seen_sphere(i, &x, &g);
        const cone k = cone_of(S, x);
        running height = {0};
        GIVEN_SPHERE(S, x, "the mean of (1 - cos θ) / (1 - cos θ_max) over 10,000 draws");
        for (int n = 0; n < 10000; n++)
            running_add(&height, height_in(k, sphere_direction(S, x, &g)));
        suspect_value(
            "uniform points of the whole sphere, also of the side that is turned away",
            height_by_area(k.far, true));
        suspect_value("uniform points of the side that is seen: they crowd towards the rim",
                      height_by_area(k.far, false));
        suspect_value("too many in the middle: the angle was uniform",
                      (1 - k.far / asin(k.far)) / k.width);
        suspect_value("too many in the middle: the radius of a disc was uniform", 1.0 / 3);
        if (k.far > 0.7) // a smaller cone narrowed by chance looks the same
            suspect_value("θ_max as if r/d were its tangent: it is the sine",
                          0.5 * (1 - 1 / sqrt(1 + k.far * k.far)) / k.width);
        const bool draws_spread = height.mean > 0.01;
        CHECK(draws_spread, spread);
        CHECK_MEAN("the mean height", &height, 0.5, rim(k) / 100);
    }
}

static void sphere_cells(void) {
    rng g = check_rng(13);
    for (int i = 0; i < COUNT(seen); i++) {
        vec3 x;
        const sphere S = seen_sphere(i, &x, &g);
        const cone k = cone_of(S, x);
        const vec3 axis = normalize(narrow(k.axis));
        tally t = {0};
        GIVEN_SPHERE(S, x,
                     "30,000 draws counted in 8 x 12 cells of 1 - cos θ and of the angle "
                     "about the axis, all equally likely for the uniform cone");
        for (int n = 0; n < 30000; n++) {
            const vec3 v = sphere_direction(S, x, &g);
            const wide3 aside = wide_along(widen(v), -1, k.axis);
            const vec3 off = narrow((wide3){aside.x / k.far, aside.y / k.far, aside.z / k.far});
            tally_add(&t, height_in(k, v), turn(off, axis));
        }
        CHECK_ALL_ROUND(&t);
        CHECK_UNIFORM(&t);
    }
}

// Down to the contract's r/d = 1e-6, where a float direction has some thirty steps across
// the cone: their grain moves the means by less than a thousandth of it.
enum { TINY = 24, TINY_DRAWS = 40000 };
#define TINY_GRAIN (1e-3 * (double)REAL_EPSILON / (double)FLT_EPSILON)

static void sphere_tiny(void) {
    rng g = check_rng(14);
    running square = {0};
    for (int i = 0; i < TINY; i++) {
        const vec3 x = in_cube(&g);
        const double distance = pow(10, i % 4 - 1);
        const sphere S = sphere_at(x, 1e3 * distance, 1e-3 * distance, &g);
        const cone k = cone_of(S, x);
        const vec3 axis = normalize(narrow(k.axis)), side = perpendicular(axis);
        running height = {0}, aside = {0};
        GIVEN_SPHERE(S, x, "the mean of (1 - cos θ) / (1 - cos θ_max) over 40,000 draws");
        for (int n = 0; n < TINY_DRAWS; n++) {
            const vec3 v = sphere_direction(S, x, &g);
            const wide3 off = wide_along(widen(v), -1, k.axis);
            running_add(&height, height_in(k, v));
            running_add(&aside, wide_dot(off, widen(side)) / k.far);
        }
        const bool draws_spread = height.mean > 0.01;
        CHECK(draws_spread, spread);
        CHECK_MEAN("the mean height", &height, 0.5, TINY_GRAIN);
        running_add(&square, aside.mean * aside.mean);
    }
    // Each mean's standard error is 0.5/200; the sum of the squares over it is chi².
    const double off_axis = sqrt(square.mean), one = 0.5 / sqrt(TINY_DRAWS);
    const double most =
        sqrt((one * one + TINY_GRAIN * TINY_GRAIN) * chi2_limit(TINY, FALSE_ALARM) / TINY);
    given("24 spheres with r/|x - c| = 1e-6: how far the mean of 40,000 draws lies to one side "
          "of the axis, in units of the cone (root of the mean square)");
    hint_instead("A draw is the axis and a little aside: is each of them in double until they "
                 "are added up? Rounded, the axis is off by a percent or two of this cone.");
    CHECK_AT_MOST(
        off_axis, most,
        "a right answer exceeds it once in a million; was the axis rounded to float?");
}

static void sphere_rare(void) {
    rng g = check_rng(15);
    for (int i = 0; i < 3 * RARE; i++) {
        vec3 x;
        const sphere S = seen_sphere(i / 3, &x, &g);
        rng rare = drawing_rare(i);
        GIVEN_SPHERE(S, x, "where rng_real gives exactly 0, or almost 1");
        check_meets(S, x, sphere_direction(S, x, &rare));
    }
}

static void sphere_from_g(void) {
    rng g = check_rng(93);
    for (int i = 0; i < 200; i++) {
        vec3 x;
        const sphere S = seen_sphere(0, &x, &g); // large: different draws look different
        rng one = rng_seed(1, (uint64_t)i), other = one;
        GIVEN_SPHERE(S, x, "a draw");
        const vec3 first = sphere_direction(S, x, &one);
        const vec3 second = sphere_direction(S, x, &other);
        given("sphere c = " VEC ", r = %.9g, x = " VEC ", " ASKED_TWICE, ARG(S.c), (double)S.r,
              ARG(x), ARG(first), ARG(second));
        check_from_g(first, second);
    }
}

// A sphere of radius 1 whose centre lies h above x's horizon and `aside` beside it.
static sphere sphere_above(vec3 x, vec3 n, double size, double h, double aside) {
    const vec3 across = scale((real)(aside * size), perpendicular(n));
    return (sphere){add(x, add(scale((real)(h * size), n), across)), (real)size};
}

// E = π L (R/d)² cos θ above the horizon; the others by independent integration.
static void sphere_light(void) {
    static const struct {
        double h, aside, E;
    } rows[] = {{1.5, 0, 1.396263401595},
                {2, 0, 0.785398163397},
                {2, 1.5, PI * 2 / (6.25 * 2.5)},
                {0.5, 2, 0.196801876179},
                {0, 2, 0.090586073706}};
    rng g = check_rng(16);
    for (int i = 0; i < COUNT(rows); i++) {
        const vec3 n = generic_unit(&g), x = in_cube(&g);
        const sphere S = sphere_above(x, n, between(&g, 0.3, 3), rows[i].h, rows[i].aside);
        running E = {0};
        given(
            "a sphere of radiance 1, its centre %g radii above the surface and %g beside: its "
            "irradiance from 40,000 draws",
            rows[i].h, rows[i].aside);
        for (int k = 0; k < 40000; k++) {
            const vec3 v = sphere_direction(S, x, &g);
            running_add(&E, fmax(cosine(v, n), 0) * 2 * PI * cone_of(S, x).width);
        }
        CHECK_MEAN("the irradiance", &E, rows[i].E, 1e-7);
    }
}

// Straight above at h = 3R, c = cos θ_max: the variance of one draw, in units of (ρL)², is (1 - c)^4 / 3 for the cone, (1 - c²) c² for
// cosine_direction, 4 (1 - c³) / 3 - (1 - c²)² for the uniform hemisphere.
typedef struct {
    double uniform, cosine, cone, mean;
} variances;

static variances variances_at(double h) {
    const double c2 = 1 - 1 / (h * h), c = sqrt(c2);
    return (variances){4 * (1 - c2 * c) / 3 - (1 - c2) * (1 - c2), (1 - c2) * c2,
                       pow(1 - c, 4) / 3, 1 - c2};
}

// Of (x - mean)², the mean and its standard error.
static void add_square(running *s, double x, double mean) {
    running_add(s, (x - mean) * (x - mean));
}

static void sphere_variance(void) {
    rng g = check_rng(17);
    const variances v = variances_at(3);
    const vec3 n = generic_unit(&g), x = in_cube(&g);
    const sphere S = sphere_above(x, n, 0.8, 3, 0);
    running towards = {0}, by_cosine = {0};
    GIVEN_SPHERE(S, x, "draws of sphere_direction");
    for (int k = 0; k < 60000; k++) {
        const double c = cosine(sphere_direction(S, x, &g), n);
        add_square(&towards, 2 * cone_of(S, x).width * c, v.mean);
        const ray r = {x, cosine_direction(n, &g)};
        add_square(&by_cosine, sphere_hit(S, r, 0, NO_HIT) < NO_HIT, v.mean);
    }
    given("a sphere of radiance 1 at 3 radii straight above: E / π by one draw in its cone has "
          "the variance (1 - cos θ_max)^4 / 3");
    CHECK_MEAN("the variance", &towards, v.cone, 0);
    given("the same sphere: E / π by one draw of cosine_direction has the variance 8/81");
    CHECK_MEAN("the variance", &by_cosine, v.cosine, 0);
}

// ---- sphere_probability --------------------------------------------------------------

static double cone_density(cone k) {
    return 1 / (2 * PI * k.width);
}

static void suspect_cones(sphere S, cone k) {
    const double cos_max = 1 - k.width, sin2 = k.far * k.far, d2 = k.distance * k.distance;
    const real in_real = (real)sqrt(1 - (real)sin2);
    const char *const cancelled =
        "1 - cos θ_max worked out as a difference: it cancels for small cones";
    suspect_value(cancelled, (double)(1 / ((real)(2 * PI) * (1 - in_real))));
    const double r2 = (double)S.r * S.r,
                 in_double[] = {sqrt(1 - sin2), sqrt(1 - r2 / d2), sqrt(d2 - r2) / k.distance};
    for (int i = 0; i < COUNT(in_double); i++)
        suspect_value(cancelled, (double)(real)(1 / (2 * PI * (1 - in_double[i]))));
    const double rounded = S.r * S.r, root = sqrt(fmax(1 - rounded / d2, 0));
    suspect_value("r² = S.r * S.r is rounded to real: (double)S.r * S.r",
                  (double)(real)((1 + root) * d2 / (2 * PI * rounded)));
    suspect_value("1 / (π (1 - cos θ_max)): half the cone's solid angle", 1 / (PI * k.width));
    suspect_value("1 / (2π cos θ_max)", 1 / (2 * PI * cos_max));
    suspect_value("1 / (π sin² θ_max): a flat disc, right for small cones only",
                  1 / (PI * sin2));
    suspect_value("1 / (4π r²): per area of the sphere, not per steradian",
                  1 / (4 * PI * sin2 * k.distance * k.distance));
    suspect_value("d² / (4π r²): per area of the whole sphere, not uniform in the cone",
                  1 / (4 * PI * sin2));
    suspect_value("the solid angle itself: the density is 1 divided by it", 2 * PI * k.width);
    suspect_value("1/(2π): the whole hemisphere", 0.5 / PI);
}

static void sphere_density(void) {
    rng g = check_rng(21);
    for (int i = 0; i < 400; i++) {
        const vec3 x = in_cube(&g);
        const double distance = between(&g, 1, 4), r = between(&g, 0.2, 0.9);
        const sphere S = sphere_at(x, distance, r, &g);
        const cone k = cone_of(S, x);
        const wide3 near = wide_along(k.axis, 0.5 * k.far, widen(in_cube(&g)));
        const vec3 v = normalize(narrow(near));
        if (height_in(k, v) > 0.99) continue;
        GIVEN_SPHERE(S, x, "the density in the cone");
        suspect_cones(S, k);
        suspect_value("0: as if the ray missed; is v's side of x or of the sphere confused?",
                      0);
        CHECK_REAL(sphere_probability(S, x, v), cone_density(k), double_inside(10));
    }
}

// From a millionth of the distance to a millionth above the surface.
static void sphere_density_extremes(void) {
    const double gaps[] = {1e6, 1e5, 1e4, 1e3, 100, 10, 1, 0.1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6};
    rng g = check_rng(22);
    for (int i = 0; i < 40 * COUNT(gaps); i++) {
        const double r = pow(10, i % 3 * 4 - 4), gap = gaps[i % COUNT(gaps)];
        const sphere S = {scale((real)r, in_cube(&g)), (real)r};
        const vec3 x = add(S.c, scale((real)(r * (1 + gap)), generic_unit(&g)));
        const cone k = cone_of(S, x);
        if (!(k.far < 1)) continue;
        const vec3 v = normalize(narrow(k.axis));
        GIVEN_SPHERE(S, x, "the density on the axis");
        suspect_value(
            "0 on the axis, as if the ray missed: were the cosines compared? |v| is 1 "
            "only to 6e-8",
            0);
        const real d2 = dot(sub(S.c, x), sub(S.c, x)), sin2 = S.r * S.r / d2;
        if (k.far > 0.9)
            suspect_value("1 - r²/d² in real arithmetic: close to the sphere it cancels",
                          (double)((1 + sqrt(fmax(1 - sin2, 0))) / ((real)(2 * PI) * sin2)));
        suspect_cones(S, k);
        CHECK_REAL(sphere_probability(S, x, v), cone_density(k),
                   double_inside(1 + 1 / sqrt(gap)));
    }
}

// How far from the centre the ray (x, v) passes, in radii.
static double passes_at(sphere S, vec3 x, vec3 v) {
    const wide3 side = wide_cross(wide_sub(S.c, x), widen(v));
    return sqrt(wide_dot(side, side)) / S.r / wide_length(v);
}

static void check_zero(sphere S, vec3 x, vec3 v, double height) {
    const cone k = cone_of(S, x);
    const bool near = fabs(height - 1) < 2 * (double)REAL_EPSILON / k.width;
    const double p = sphere_probability(S, x, v);
    given("sphere c = " VEC ", r = %.9g, x = " VEC ", r/|x - c| = %.9g, v = " VEC
          ": the ray passes the centre at |w x v| = %.9g r",
          ARG(S.c), (double)S.r, ARG(x), k.far, ARG(v), passes_at(S, x, v));
    const bool p_is_positive = p > 0;
    if (height < 1) {
        CHECK(p_is_positive, near ? "p > 0 where the ray meets the sphere; were the cosines "
                                    "compared? |v| is 1 only to 6e-8"
                                  : "p > 0 where the ray meets the sphere");
        return;
    }
    if (near)
        suspect_value("the cosines were compared: |v| is 1 only to 6e-8", cone_density(k));
    suspect_value("the cone's density: the ray misses the sphere, is that looked at?",
                  cone_density(k));
    CHECK_REAL(p, 0, exactly());
}

static void sphere_density_zero(void) {
    rng g = check_rng(23);
    for (int i = 0; i < 4000; i++) {
        vec3 x;
        const sphere S = seen_sphere(i, &x, &g);
        const cone k = cone_of(S, x);
        const double off = 2 * k.far * rng_double(&g);
        const vec3 aside = perpendicular(normalize(narrow(k.axis)));
        const vec3 v = normalize(narrow(wide_along(k.axis, off, widen(aside))));
        const double height = height_in(k, v);
        if (fabs(height - 1) < rim(k)) continue; // the rim itself: rounding decides
        check_zero(S, x, v, height);
        GIVEN_SPHERE(S, x, "straight away from it: the sphere lies behind");
        suspect_value("the cone's density: a sphere behind x is not seen along v",
                      cone_density(k));
        CHECK_REAL(sphere_probability(
                       S, x, normalize(narrow((wide3){-k.axis.x, -k.axis.y, -k.axis.z}))),
                   0, exactly());
    }
    for (int i = 0; i < 500; i++) {
        const vec3 c = in_cube(&g), off = generic_unit(&g);
        const sphere S = {c, (real)between(&g, 0.1, 5)};
        const vec3 x = add(S.c, scale(S.r * (real)0.99 * rng_real(&g), off));
        given("sphere c = " VEC ", r = %.9g, and x = " VEC " in it", ARG(S.c), (double)S.r,
              ARG(x));
        CHECK_REAL(sphere_probability(S, x, generic_unit(&g)), 0, exactly());
    }
}

static void sphere_belongs(void) {
    rng g = check_rng(24);
    for (int i = 0; i < 4 * COUNT(seen); i++) {
        vec3 x;
        const sphere S = seen_sphere(i, &x, &g);
        const cone k = cone_of(S, x);
        running all = {0};
        for (int n = 0; n < 500; n++) {
            GIVEN_SPHERE(S, x, "a direction that sphere_direction draws");
            const vec3 v = sphere_direction(S, x, &g);
            if (height_in(k, v) > 1 - rim(k)) continue;
            const double p = sphere_probability(S, x, v);
            const bool p_is_positive = p > 0;
            CHECK(p_is_positive, "p > 0 for a direction that sphere_direction draws");
            running_add(&all, 1 / p);
        }
        GIVEN_SPHERE(S, x, "the mean of 1/p over 500 draws: the cone's solid angle");
        const double mean_of_1_over_p = all.mean;
        CHECK_REAL(mean_of_1_over_p, 2 * PI * k.width, double_inside(1000));
    }
}

#endif
