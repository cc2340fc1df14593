// Tests of 10-importance-sampling: every sampler against its density, the densities against
// closed forms in double, and the path tracer that is made of them.
#include "tests/10-ggx.h"
#include "tests/10-paths.h"
#include "tests/10-sphere.h"
#include "tests/check-directions.h"

// ---- cosine_direction --------------------------------------------------------------

static void check_above(vec3 v, vec3 n, const char *draw) {
    given("n = " VEC ", %s: " VEC, ARG(n), draw, ARG(v));
    CHECK(is_finite(v), "finite, no NaN");
    CHECK_REAL(wide_length(v), 1, roundings(16, "a unit vector, made by a frame"));
    CHECK(cosine(v, n) >= BELOW_BY_ROUNDING, "above the surface: v·n >= 0, but for a rounding");
}

static void cosine_unit(void) {
    rng g = check_rng(1);
    for (int i = 0; i < 400; i++) {
        const vec3 n = test_normal(i % 64, &g);
        given("n = " VEC ": draws of cosine_direction", ARG(n));
        repeats r = {0};
        for (int k = 0; k < 100; k++) {
            const vec3 v = cosine_direction(n, &g);
            check_above(v, n, "a draw");
            count_repeat(&r, v);
        }
        given("n = " VEC ": %ld of 100 draws are the first again", ARG(n), r.alike);
        CHECK(r.alike < 50, "the draws differ: is g used, and handed on?");
    }
}

// Beside (0, 0, -1), as near as floats get.
static void cosine_upside_down(void) {
    rng g = check_rng(2);
    for (int k = 0; k <= 45; k++) {
        const real off = k == 45 ? 0 : (real)pow(10, -k);
        const vec3 aside = scale(off, generic_unit(&g));
        const vec3 n = normalize((vec3){aside.x, aside.y, k % 2 ? -1 : 1});
        given("n = " VEC ": draws of cosine_direction", ARG(n));
        for (int i = 0; i < 200; i++)
            check_above(cosine_direction(n, &g), n, "beside the z axis, a draw");
    }
}

static void cosine_mean(void) {
    rng g = check_rng(3);
    for (int i = 0; i < NORMALS; i++) {
        const vec3 n = test_normal(i, &g);
        given("n = " VEC ": draws of cosine_direction", ARG(n));
        running c = {0};
        for (int k = 0; k < 40000; k++) running_add(&c, cosine(cosine_direction(n, &g), n));
        given("n = " VEC ": the mean cosine between n and 40,000 draws", ARG(n));
        suspect_value("uniform over the hemisphere: the cosine is missing", 0.5);
        suspect_value("a density of cos³: n plus a point *in* the ball?", 0.8);
        suspect_value("a density of cos²", 0.75);
        suspect_value("a disc with too many points in the middle: its radius must be the root "
                      "of a uniform number, or its area is not covered evenly",
                      PI / 4);
        suspect_value("the angle θ is uniform: without the sine of the solid angle", 2 / PI);
        suspect_value("uniform over the whole sphere", 0);
        CHECK_MEAN("the mean cosine", &c, 2.0 / 3, 0);
    }
}

static void cosine_cells(void) {
    rng g = check_rng(4);
    for (int i = 0; i < NORMALS; i++) {
        const vec3 n = test_normal(i, &g);
        given("n = " VEC ": draws of cosine_direction", ARG(n));
        tally t = {0};
        for (int k = 0; k < 60000; k++) {
            const vec3 v = cosine_direction(n, &g);
            const double c = cosine(v, n);
            tally_add(&t, 1 - c * c, turn(v, n));
        }
        given("n = " VEC ": 60,000 draws counted in 8 x 12 cells of sin²θ and of the angle "
              "about n, all equally likely for cos θ / π",
              ARG(n));
        CHECK_ALL_ROUND(&t);
        CHECK_UNIFORM(&t);
    }
}

static void cosine_rare(void) {
    rng g = check_rng(5);
    for (int i = 0; i < RARE; i++) {
        const vec3 n = test_normal(i % 16, &g);
        rng rare = drawing_rare(i);
        check_above(cosine_direction(n, &rare), n,
                    i % 2 ? "where rng_real gives exactly 0" : "where rng_real gives almost 1");
    }
}

static void cosine_from_g(void) {
    rng g = check_rng(91);
    for (int i = 0; i < 200; i++) {
        const vec3 n = test_normal(i, &g);
        rng one = rng_seed(1, (uint64_t)i), other = one;
        given("n = " VEC ": draws of cosine_direction", ARG(n));
        const vec3 first = cosine_direction(n, &one), second = cosine_direction(n, &other);
        given("n = " VEC ", " ASKED_TWICE, ARG(n), ARG(first), ARG(second));
        check_from_g(first, second);
    }
}

// ---- cosine_probability ------------------------------------------------------------

static void cosine_density(void) {
    rng g = check_rng(6);
    for (int i = 0; i < 2000; i++) {
        const vec3 n = test_normal(i, &g), v = generic_unit(&g);
        const double c = cosine(v, n);
        given("n = " VEC ", v = " VEC ", so n·v = %.9g", ARG(n), ARG(v), c);
        suspect_value("the cosine without 1/π: over the hemisphere it adds up to π", c);
        suspect_value("1/(2π): uniform over the hemisphere", 0.5 / PI);
        suspect_value("cos θ / (2π): over the hemisphere it adds up to 1/2", c / (2 * PI));
        suspect_value("negative: below the surface there are no draws", c / PI);
        suspect_value("|cos θ| / π: below the surface there are no draws", fabs(c) / PI);
        suspect_value("1/π, without the cosine", 1 / PI);
        CHECK_REAL(cosine_probability(n, v), fmax(c, 0) / PI,
                   absolute_of(2 * REAL_EPSILON, "three products and two sums, all below 1"));
    }
}

static void cosine_density_whole(void) {
    rng g = check_rng(7);
    for (int i = 0; i < NORMALS; i++) {
        const vec3 n = test_normal(i, &g);
        running p = {0};
        for (int k = 0; k < 40000; k++)
            running_add(&p, 4 * PI * (double)cosine_probability(n, unit_vector(&g)));
        given("n = " VEC ": the integral of the density over the whole sphere, by 40,000 "
              "uniform directions",
              ARG(n));
        CHECK_MEAN("the mean of p times the sphere's solid angle", &p, 1, 0);
    }
}

// 1/p is what a draw stands for. Above cos θ = 0.2 they must stand for 2π 0.8 steradians.
static void cosine_belongs(void) {
    rng g = check_rng(8);
    const vec3 n = generic_unit(&g);
    running all = {0};
    for (int k = 0; k < 100000; k++) {
        const vec3 v = cosine_direction(n, &g);
        if (cosine(v, n) <= 0.2) {
            running_add(&all, 0);
            continue;
        }
        const double p = cosine_probability(n, v);
        given("n = " VEC ", v = " VEC " by cosine_direction: p = %.9g", ARG(n), ARG(v), p);
        const bool p_is_positive = p > 0;
        CHECK(p_is_positive, "p > 0 for a direction that cosine_direction draws");
        running_add(&all, 1 / p);
    }
    given("n = " VEC ": the mean of 1/p over the draws with cos θ > 0.2, in steradians",
          ARG(n));
    CHECK_MEAN("the mean of 1/p", &all, 2 * PI * 0.8, 0);
}

static void cosine_no_variance(void) {
    rng g = check_rng(9);
    const vec3 n = generic_unit(&g);
    for (int k = 0; k < 10000; k++) {
        const vec3 v = cosine_direction(n, &g);
        const double c = cosine(v, n), p = cosine_probability(n, v);
        if (c < 1e-3) continue; // a rounding of the cosine counts there
        given("rho = 0.6 under a sky of 1: rho/π cos θ / p, for v = " VEC ", n = " VEC, ARG(v),
              ARG(n));
        CHECK_REAL(0.6 / PI * c / p, 0.6,
                   relative_to(2000 * REAL_EPSILON, "roundings of cosines down to 0.001"));
    }
}

// ---- triangle_sample ---------------------------------------------------------------

static triangle generic_triangle(rng *g) {
    const vec3 a = in_cube(g), b = in_cube(g), c = in_cube(g);
    return (triangle){a, b, c};
}

// Of ordinary shape; needles; huge and tiny ones.
static triangle test_triangle(int i, rng *g) {
    triangle T = generic_triangle(g);
    if (i % 4 == 1) T.p3 = add(T.p2, scale((real)1e-5, in_cube(g)));
    const real size = i % 4 == 2 ? (real)1e12 : i % 4 == 3 ? (real)1e-12 : 1;
    return (triangle){scale(size, T.p1), scale(size, T.p2), scale(size, T.p3)};
}

static void check_inside(triangle_point q, const char *draw) {
    given("%s: u = %.9g, v = %.9g", draw, (double)q.u, (double)q.v);
    CHECK(isfinite(q.u) && isfinite(q.v), "finite, no NaN");
    const double slack = 2 * (double)REAL_EPSILON;
    CHECK(q.u >= -slack && q.v >= -slack, "u >= 0 and v >= 0");
    CHECK((double)q.u + q.v <= 1 + slack,
          "u + v <= 1: beyond it lies the other half of the parallelogram");
    CHECK_REAL(q.t, 0, exactly());
}

static void triangle_inside(void) {
    rng g = check_rng(31);
    for (int i = 0; i < 400; i++) {
        const triangle T = test_triangle(i, &g);
        repeats r = {0};
        for (int k = 0; k < 50; k++) {
            const triangle_point q = triangle_sample(T, &g);
            check_inside(q, "a draw");
            count_repeat(&r, (vec3){q.u, q.v, 0});
        }
        given("%ld of 50 draws are the first again", r.alike);
        CHECK(r.alike < 25, "the draws differ: is g used, and handed on?");
    }
}

static void triangle_from_g(void) {
    rng g = check_rng(92);
    for (int i = 0; i < 200; i++) {
        const triangle T = test_triangle(i, &g);
        rng one = rng_seed(1, (uint64_t)i), other = one;
        given("p1 = " VEC ", p2 = " VEC ", p3 = " VEC, ARG(T.p1), ARG(T.p2), ARG(T.p3));
        const triangle_point p = triangle_sample(T, &one), q = triangle_sample(T, &other);
        const vec3 first = {p.t, p.u, p.v}, second = {q.t, q.u, q.v};
        given("p1 = " VEC ", p2 = " VEC ", p3 = " VEC ", (t, u, v) " ASKED_TWICE, ARG(T.p1),
              ARG(T.p2), ARG(T.p3), ARG(first), ARG(second));
        check_from_g(first, second);
    }
}

// A mean can speak of crowding only when all points are in the triangle.
static void suspect_means(double u, double v, long beyond) {
    if (beyond > 0) {
        suspect_value(
            "as in the whole parallelogram: the half beyond the diagonal u + v = 1 is "
            "not brought back, or only in one coordinate",
            0.5);
        hint_instead("Points lie beyond the diagonal u + v = 1, in the other half of the "
                     "parallelogram. Bring that half back first: both u and v change.");
        return;
    }
    if (fabs(u - 0.25) < 0.02 && fabs(v - 0.25) < 0.02)
        suspect_value(
            "too many points near p1, where u = v = 0: a root is missing, or the half "
            "beyond the diagonal was shrunk, not turned",
            0.25);
    suspect_value("the points crowd towards a corner: a strip across the triangle gets "
                  "as many points near the corner as at the broad end: a root is missing",
                  0.5);
    suspect_value("the points crowd towards a corner: a root is missing", 0.25);
}

static void triangle_mean(void) {
    rng g = check_rng(32);
    for (int i = 0; i < 8; i++) {
        const triangle T = test_triangle(i, &g);
        running u = {0}, v = {0};
        long beyond = 0;
        for (int k = 0; k < 20000; k++) {
            const triangle_point q = triangle_sample(T, &g);
            running_add(&u, q.u), running_add(&v, q.v);
            beyond += (double)q.u + q.v > 1 + 2 * (double)REAL_EPSILON;
        }
        const running *both[] = {&u, &v};
        for (int k = 0; k < 2; k++) {
            given("the mean %c of 20,000 draws, %ld of them with u + v > 1; for the whole "
                  "triangle, its centre's, 1/3",
                  "uv"[k], beyond);
            suspect_means(u.mean, v.mean, beyond);
            CHECK_MEAN("the mean", both[k], 1.0 / 3, 0);
        }
    }
}

// Where u, v and 1 - u - v are all above 1/6: a triangle of half the size, a quarter of the area.
static void triangle_middle(void) {
    rng g = check_rng(36);
    running inside = {0};
    for (int k = 0; k < 40000; k++) {
        const triangle_point q = triangle_sample(generic_triangle(&g), &g);
        running_add(&inside, fmin(fmin(q.u, q.v), 1 - (double)q.u - q.v) > 1.0 / 6);
    }
    given("which share of 40,000 draws lies where u, v and 1 - u - v are all above 1/6: a "
          "quarter of the triangle's area, in its middle");
    hint_instead(inside.mean > 0.25
                     ? "The middle is too full. The sum of several random numbers crowds about "
                       "its mean: are three divided by their sum?"
                     : "The middle is too empty. Which part of the triangle has too many "
                       "points, and do all of them lie in the triangle?");
    CHECK_MEAN("the share", &inside, 0.25, 0);
}

// For uniform points (1 - u)² is uniform, and so is v / (1 - u).
static void triangle_cells(void) {
    rng g = check_rng(33);
    for (int i = 0; i < 8; i++) {
        const triangle T = test_triangle(i, &g);
        tally t = {0};
        for (int k = 0; k < 40000; k++) {
            const triangle_point q = triangle_sample(T, &g);
            const double rest = 1 - (double)q.u;
            tally_add(&t, rest * rest, rest > 0 ? q.v / rest : 0);
        }
        given("40,000 draws counted in 8 x 12 cells of equal area, in strips of u");
        CHECK_UNIFORM(&t);
    }
}

static void triangle_rare(void) {
    rng g = check_rng(34);
    for (int i = 0; i < RARE; i++) {
        rng rare = drawing_rare(i);
        check_inside(triangle_sample(generic_triangle(&g), &rare),
                     i % 2 ? "where rng_real gives exactly 0"
                           : "where rng_real gives almost 1");
    }
}

// Lambert's formula: half the sum over the edges of their angles at x, each times the cosine
// of the plane through x and the edge. All corners above the horizon.
static double triangle_irradiance(triangle T, vec3 x, vec3 n) {
    const wide3 p[] = {wide_sub(T.p1, x), wide_sub(T.p2, x), wide_sub(T.p3, x)};
    double E = 0;
    for (int i = 0; i < 3; i++) {
        const wide3 a = p[i], b = p[(i + 1) % 3], c = wide_cross(a, b);
        const double sine = sqrt(wide_dot(c, c));
        E += atan2(sine, wide_dot(a, b)) * wide_dot(c, widen(n)) / sine / 2;
    }
    return fabs(E);
}

// A triangle some distance above x's horizon, of the given kind; x and n to match.
static triangle lamp_above(int i, vec3 x, vec3 n, rng *g) {
    triangle T = generic_triangle(g);
    if (i % 3 == 1) T.p3 = add(T.p2, scale((real)1e-4, in_cube(g)));
    const real size = i % 3 == 2 ? 30 : 1;
    const vec3 up = add(x, scale((real)2.5 * size, n));
    return (triangle){add(up, scale(size, T.p1)), add(up, scale(size, T.p2)),
                      add(up, scale(size, T.p3))};
}

static vec3 point_at(triangle T, triangle_point q) {
    return add(T.p1, add(scale(q.u, sub(T.p2, T.p1)), scale(q.v, sub(T.p3, T.p1))));
}

static double area_of(triangle T) {
    return wide_length(triangle_normal(T)) / 2;
}

static vec3 unit_normal(triangle T) {
    const double size = wide_length(triangle_normal(T));
    return scale((real)(1 / size), triangle_normal(T));
}

static void triangle_light(void) {
    rng g = check_rng(35);
    for (int i = 0; i < 9; i++) {
        const vec3 n = generic_unit(&g), x = in_cube(&g);
        const triangle T = lamp_above(i, x, n, &g);
        const double area = area_of(T);
        const vec3 n_y = unit_normal(T);
        running E = {0};
        for (int k = 0; k < 20000; k++) {
            const wide3 w = wide_sub(point_at(T, triangle_sample(T, &g)), x);
            const double d2 = wide_dot(w, w);
            running_add(&E, fabs(wide_dot(w, widen(n)) * wide_dot(w, widen(n_y))) * area /
                                (d2 * d2));
        }
        given("%s of radiance 1 above x: its irradiance from 20,000 points, against Lambert's "
              "formula",
              i % 3 == 1 ? "a needle" : "a triangle");
        const double exact_E = triangle_irradiance(T, x, n);
        CHECK_MEAN("the irradiance", &E, exact_E, 1e-5 * exact_E);
    }
}

// ---- solid_angle_probability ---------------------------------------------------------

static void suspect_areas(double d, double area, double c) {
    suspect_value("without cos θ': a tilted lamp looks smaller", d * d / area);
    suspect_value("without the distance's square: a far lamp looks smaller", 1 / (area * c));
    suspect_value("1/area: per area, not per steradian", 1 / area);
    suspect_value("|y - x| in place of its square", d / (area * c));
    suspect_value("the cosine belongs below the line", d * d * c / area);
    suspect_value("|y - x| left in the cosine: n_y·(y - x) must be divided by the length",
                  d / (area * c));
    suspect_value("upside down: this is the solid angle for each unit of area times area",
                  area * c / (d * d));
    suspect_value("negative: the lamp's back is seen; |cos θ'|", -d * d / (area * c));
}

static void area_values(void) {
    rng g = check_rng(41);
    for (int i = 0; i < 2000; i++) {
        const vec3 x = in_cube(&g), n = generic_unit(&g), off = in_cube(&g);
        const vec3 y = add(x, scale((real)between(&g, 0.5, 5), off));
        const wide3 w = wide_sub(y, x);
        const double d = sqrt(wide_dot(w, w)), c = fabs(wide_dot(widen(n), w)) / d;
        const double area = (real)between(&g, 0.1, 3);
        if (c < 1e-3) continue;
        given("x = " VEC ", y = " VEC ", n_y = " VEC ", area = %.9g: |y - x| = %.6g, "
              "|cos θ'| = %.6g",
              ARG(x), ARG(y), ARG(n), area, d, c);
        suspect_areas(d, area, c);
        CHECK_REAL(solid_angle_probability(x, y, n, (real)area), d * d / (area * c),
                   double_inside(1 / c));
    }
}

// Everything k decades larger or smaller, and far from the origin: the same solid angle.
static void area_scales(void) {
    rng g = check_rng(42);
    for (int k = -15; k <= 15; k++) {
        const real size = (real)pow(10, k);
        for (int i = 0; i < 50; i++) {
            const vec3 x = scale(i % 2 * 1000 * size, in_cube(&g)), n = generic_unit(&g);
            const vec3 off = generic_unit(&g), more = in_cube(&g);
            const vec3 y = add(x, scale(size, add(more, scale(2, off))));
            const wide3 w = wide_sub(y, x);
            const double d = sqrt(wide_dot(w, w)), c = fabs(wide_dot(widen(n), w)) / d;
            const double area = size * size * (real)0.7;
            if (c < 1e-3) continue;
            given("x = " VEC ", y = " VEC ", n_y = " VEC ", area = %.9g", ARG(x), ARG(y),
                  ARG(n), area);
            suspect_areas(d, area, c);
            CHECK_REAL(solid_angle_probability(x, y, n, (real)area), d * d / (area * c),
                       double_inside(1 / c));
        }
    }
}

static void area_grazing(void) {
    rng g = check_rng(43);
    for (int i = 0; i < 500; i++) {
        const vec3 n = generic_unit(&g), across = perpendicular(n);
        const double tilt = pow(10, -1 - i % 6);
        const vec3 x = {0, 0, 0}, y = add(scale(3, across), scale((real)tilt, n));
        const wide3 w = widen(y);
        const double d = sqrt(wide_dot(w, w)), c = fabs(wide_dot(widen(n), w)) / d;
        if (c == 0) continue;
        given("almost edge-on: x = 0, y = " VEC ", n_y = " VEC ", area = 1: |cos θ'| = %.6g",
              ARG(y), ARG(n), c);
        suspect_areas(d, 1, c);
        CHECK_REAL(solid_angle_probability(x, y, n, 1), d * d / c, double_inside(1 / c));
    }
    given("edge-on: x = (1, 2, 3), y = (1, 5, -1), n_y = (1, 0, 0)");
    CHECK_REAL(solid_angle_probability((vec3){1, 2, 3}, (vec3){1, 5, -1}, (vec3){1, 0, 0}, 2),
               INFINITY, exactly());
}

// The mean of 1/p over uniform points is the solid angle that the triangle fills.
static void area_whole(void) {
    rng g = check_rng(44);
    for (int i = 0; i < 9; i++) {
        const vec3 n = generic_unit(&g), x = in_cube(&g);
        const triangle T = lamp_above(i, x, n, &g);
        const real area = (real)area_of(T);
        const vec3 n_y = unit_normal(T);
        running all = {0};
        for (int k = 0; k < 20000; k++) {
            const double root = sqrt(rng_double(&g)), share = rng_double(&g);
            const triangle_point q = {0, (real)(1 - root), (real)(root * share)};
            running_add(&all,
                        1 / (double)solid_angle_probability(x, point_at(T, q), n_y, area));
        }
        const double omega = triangle_solid_angle(T, x);
        given("%s above x: the mean of 1/p over 20,000 uniform points is its solid angle",
              i % 3 == 1 ? "a needle" : "a triangle");
        CHECK_MEAN("the mean of 1/p", &all, omega, 1e-5 * omega);
    }
}

// ---- balance_heuristic and power_heuristic --------------------------------------------

// 1 - q / (p + q), rounded in several ways: near 1 a number has no digits for how far from it.
static void suspect_difference(real p, real q) {
    const real by_double = (real)((double)q / ((double)p + q)), by_real = q / (p + q),
               by_ratio = 1 / (1 + p / q), other[] = {by_double, by_real, by_ratio};
    for (int i = 0; i < COUNT(other); i++)
        suspect_value("1 minus the other weight: that is rounded, and near 1 the difference "
                      "keeps few digits. Divide p itself",
                      (double)(1 - other[i]));
}

// First alike, by a factor of 1.3 to 3: all mistakes give numbers of one size there.
static void balance_values(void) {
    rng g = check_rng(51);
    for (int i = 0; i < 2000; i++) {
        const double range = i < 50 ? 0.3 : 3, apart = between(&g, 1.3, 3);
        const double p = (real)pow(10, between(&g, -range, range));
        const double other = i % 2 ? p * apart : p / apart;
        const double q = (real)(i < 50 ? other : pow(10, between(&g, -3, 3)));
        given("p = %.9g, q = %.9g", p, q);
        suspect_value("q / (p + q): the weight of the other one", q / (p + q));
        suspect_value("p² / (p² + q²): the power heuristic", p * p / (p * p + q * q));
        suspect_value("1/2 for all: the average of the two ways, with the noise of both", 0.5);
        suspect_value("p / q", p / q);
        suspect_value("q / p", q / p);
        suspect_value("1 / (p + q): this is the weight over p", 1 / (p + q));
        suspect_difference((real)p, (real)q);
        suspect_value("1: the light is counted by both ways", 1);
        CHECK_REAL(balance_heuristic((real)p, (real)q), p / (p + q),
                   roundings(8, "a few operations"));
    }
}

typedef real (*heuristic)(real p, real q);

// Huge, tiny, zero, infinite.
static void sums_to_one(heuristic weight, const char *name) {
    const real sizes[] = {0,         REAL_MIN,   (real)1e-20,  (real)1e-3, 1,
                          (real)7.5, (real)1e20, REAL_MAX / 2, REAL_MAX,   INFINITY};
    for (int i = 0; i < COUNT(sizes); i++) {
        for (int k = 0; k < COUNT(sizes); k++) {
            const real p = sizes[i], q = sizes[k];
            if (p == q && (p == 0 || isinf(p))) continue;
            const double one = weight(p, q), other = weight(q, p);
            given("%s: w(%.9g, %.9g) = %.9g and w(%.9g, %.9g) = %.9g: their sum should be 1",
                  name, (double)p, (double)q, one, (double)q, (double)p, other);
            const bool both_are_numbers = !isnan(one) && !isnan(other);
            CHECK(both_are_numbers, "numbers: infinity / infinity is NaN, and 0 / 0 too");
            const double their_sum = one + other;
            if (isinf(p + q) && isfinite(p) && isfinite(q))
                suspect_value("p + q overflows", (double)(p / (p + q)) + (double)(q / (p + q)));
            CHECK_REAL(their_sum, 1, roundings(8, "two quotients"));
            given("%s: w(p, q) for p = %.9g, q = %.9g", name, (double)p, (double)q);
            if (p == 0 || isinf(q)) CHECK_REAL(one, 0, exactly());
            if (q == 0 || isinf(p)) CHECK_REAL(one, 1, exactly());
            CHECK(one >= 0 && one <= 1, "a weight from 0 to 1");
        }
    }
}

static void balance_extremes(void) {
    sums_to_one(balance_heuristic, "balance_heuristic");
}

static void power_extremes(void) {
    sums_to_one(power_heuristic, "power_heuristic");
}

static void power_values(void) {
    rng g = check_rng(52);
    for (int i = 0; i < 500; i++) {
        const double p = (real)pow(10, between(&g, -3, 3)),
                     q = (real)pow(10, between(&g, -3, 3));
        given("p = %.9g, q = %.9g", p, q);
        CHECK_REAL(power_heuristic((real)p, (real)q), p * p / (p * p + q * q),
                   roundings(16, "a few operations, squared"));
    }
}

// A sphere light half below the horizon: two samplers, together as good as the closed form.
static void balance_combines(void) {
    rng g = check_rng(53);
    const vec3 n = generic_unit(&g), x = in_cube(&g);
    const sphere S = sphere_above(x, n, 1, 0.5, 2);
    running both = {0};
    for (int i = 0; i < 60000; i++) {
        const vec3 a = sphere_direction(S, x, &g), b = cosine_direction(n, &g);
        const real pa = sphere_probability(S, x, a), qa = cosine_probability(n, a);
        const real pb = cosine_probability(n, b), qb = sphere_probability(S, x, b);
        double sum = 0;
        if (pa > 0) sum += fmax(cosine(a, n), 0) / pa * balance_heuristic(pa, qa);
        if (qb > 0 && pb > 0) sum += fmax(cosine(b, n), 0) / pb * balance_heuristic(pb, qb);
        running_add(&both, sum);
    }
    given("a sphere light half below the horizon: its irradiance from 60,000 draws of "
          "sphere_direction and as many of cosine_direction, weighted");
    suspect_factor("the light is counted by both ways", 2);
    CHECK_MEAN("the irradiance", &both, 0.196801876179, 0);
}

// ---- orthonormal_basis -----------------------------------------------------------------

#define FRAME_ERROR (sizeof(real) == sizeof(float) ? 3e-7 : 6e-16)

// The nearest numbers to a unit vector along a.
static vec3 rounded_unit(vec3 a) {
    const exact3 e = exact_of(a);
    const exact size = exact_sqrt(exact_dot(e, e));
    return (vec3){(real)(e.x / size), (real)(e.y / size), (real)(e.z / size)};
}

static double distance_of(exact a, exact b) {
    return fabs((double)(a - b));
}

// How far from an orthonormal, right-handed frame.
static double frame_error(frame f) {
    const exact3 s = exact_of(f.s), t = exact_of(f.t), n = exact_of(f.n), u = exact_cross(s, t);
    const double errors[] = {distance_of(exact_sqrt(exact_dot(s, s)), 1),
                             distance_of(exact_sqrt(exact_dot(t, t)), 1),
                             distance_of(exact_dot(s, t), 0),
                             distance_of(exact_dot(s, n), 0),
                             distance_of(exact_dot(t, n), 0),
                             distance_of(u.x, n.x),
                             distance_of(u.y, n.y),
                             distance_of(u.z, n.z)};
    double worst = 0;
    for (int i = 0; i < COUNT(errors); i++)
        if (!(errors[i] <= worst)) worst = errors[i]; // NaN too
    return worst;
}

static void basis_everywhere(void) {
    rng g = check_rng(81);
    for (int i = 0; i < 30000; i++) {
        const vec3 n = rounded_unit(test_normal(i, &g));
        given("n = " VEC, ARG(n));
        CHECK_AT_MOST(frame_error(orthonormal_basis(n)), FRAME_ERROR,
                      "orthonormal and right-handed: 3e-7 in float, 6e-16 in double");
    }
}

// n.z to -1 and to 1, down to the smallest numbers.
static void basis_at_the_pole(void) {
    rng g = check_rng(82);
    for (int i = 0; i < 30000; i++) {
        const double off = pow(10, -1.5 - (i % 450) / 10.0);
        const vec3 aside = scale((real)off, in_cube(&g));
        const vec3 n = rounded_unit((vec3){aside.x, aside.y, i % 3 ? -1 : 1});
        given("n = " VEC, ARG(n));
        CHECK_AT_MOST(frame_error(orthonormal_basis(n)), FRAME_ERROR / 2,
                      "orthonormal and right-handed: 1.5e-7 in float, 3e-16 in double");
    }
}

static void there_and_back(void) {
    rng g = check_rng(83);
    for (int i = 0; i < 5000; i++) {
        const frame f = orthonormal_basis(test_normal(i, &g));
        const vec3 v = generic_unit(&g);
        given("n = " VEC ", v = " VEC, ARG(f.n), ARG(v));
        CHECK_VEC3(to_world(f, to_local(f, v)), v, roundings(16, "a frame there and back"));
        CHECK_VEC3(to_local(f, f.n), ((vec3){0, 0, 1}), roundings(12, "a rounded frame"));
        CHECK_REAL(to_local(f, v).z, cosine(v, f.n),
                   absolute_of(4 * REAL_EPSILON, "a dot product"));
    }
}

// ------------------------------------------------------------------------------------------

int main(void) {
    static const char *const lambert =
        "The density must be cos θ / π: seen from above the draws fill the unit disc evenly.";
    static const char *const rare_draws =
        "If the tests above fail too, mend those first: this may be the same. If not: rng_real "
        "may give exactly 0, and almost 1. Is there a division, a root of what rounding makes "
        "negative?";
    static const char *const from_g = "Whatever is drawn comes from g, by rng_real(g), and "
                                      "nothing is kept for the next call.";
    static const char *const frames =
        "Is the frame right for every n, (0, 0, -1) and all around "
        "it too? orthonormal_basis is.";
    static const char *const cone_hint =
        "In a cone 1 - cos θ is uniform from 0 to 1 - cos θ_max.";
    static const char *const cancels =
        "Which difference of nearly equal numbers is there? sin² = (1 - cos)(1 + cos).";
    static const char *const area = "A strip of a triangle has an area in proportion to its "
                                    "length: how many of the points belong to it?";
    static const char *const patch =
        "How many steradians does a little piece dA of the lamp fill, "
        "seen from x?";
    static const char *const balance = "p's share of p + q: divide so that nothing overflows.";
    static const char *const normals = "Stretch o by alpha, choose what the hemisphere mirrors "
                                       "of it, stretch the normal back.";
    static const char *const view_hint =
        "Which share of what o sees of the surface do the normals "
        "about h fill? G1 (o·h) D / o.z.";
    static const char *const together =
        "1/p is the solid angle that a draw stands for: sampler and "
        "probability must belong together.";
    static const char *const given_code = "Given code: did it change?";
    static const char *const made_of_yours =
        "Given code, made of the exercises: are they right, each by itself?";
    static const test tests[] = {
        {"cosine_direction: a unit vector above the surface", cosine_unit, frames},
        {"cosine_direction: beside the z axis", cosine_upside_down, frames},
        {"cosine_direction: the mean cosine is 2/3", cosine_mean, lambert},
        {"cosine_direction: chi² against cos θ / π", cosine_cells, lambert},
        {"cosine_direction: the rarest random numbers", cosine_rare, rare_draws},
        {"cosine_direction: the same g, the same draw", cosine_from_g, from_g},
        {"cosine_probability: cos θ / π, above the surface", cosine_density, lambert},
        {"cosine_probability: its integral is 1", cosine_density_whole, lambert},
        {"cosine_probability: belongs to cosine_direction", cosine_belongs, together},
        {"cosine_probability: no noise under a constant sky", cosine_no_variance, together},
        {"sphere_direction: a unit vector that meets the sphere", sphere_meets, cone_hint},
        {"sphere_direction: the mean of 1 - cos θ", sphere_mean, cone_hint},
        {"sphere_direction: chi² against the uniform cone", sphere_cells, cone_hint},
        {"sphere_direction: r/|x - c| = 1e-6", sphere_tiny, cancels},
        {"sphere_direction: the rarest random numbers", sphere_rare, rare_draws},
        {"sphere_direction: the same g, the same draw", sphere_from_g, from_g},
        {"sphere_direction: the light of a sphere", sphere_light, cone_hint},
        {"sphere_direction: the variance of one draw", sphere_variance, cone_hint},
        {"sphere_probability: 1 / (2π (1 - cos θ_max))", sphere_density,
         "The cone's solid angle is ∫ sin θ dθ dφ up to θ_max."},
        {"sphere_probability: far away and close by", sphere_density_extremes, cancels},
        {"sphere_probability: 0 where the ray misses", sphere_density_zero,
         "Is the sphere before x, is x outside, and how near does the ray pass the centre?"},
        {"sphere_probability: belongs to sphere_direction", sphere_belongs, together},
        {"triangle_sample: in the triangle", triangle_inside,
         "u and v of two random numbers fill a parallelogram, twice the triangle."},
        {"triangle_sample: the mean is the centre", triangle_mean, area},
        {"triangle_sample: the quarter in the middle", triangle_middle, area},
        {"triangle_sample: chi² against equal areas", triangle_cells, area},
        {"triangle_sample: the rarest random numbers", triangle_rare, rare_draws},
        {"triangle_sample: the same g, the same draw", triangle_from_g, from_g},
        {"triangle_sample: the light of a triangle", triangle_light, area},
        {"solid_angle_probability: |y - x|² / (area |cos θ'|)", area_values, patch},
        {"solid_angle_probability: from 1e-15 to 1e15", area_scales,
         "Where does a power of |y - x| leave the range of float?"},
        {"solid_angle_probability: grazing and edge-on", area_grazing,
         "Near 0 the products of n_y·(y - x) cancel: double inside."},
        {"solid_angle_probability: 1/p adds up to the solid angle", area_whole, patch},
        {"balance_heuristic: p / (p + q)", balance_values, balance},
        {"balance_heuristic: zero, huge, infinite", balance_extremes, balance},
        {"balance_heuristic: two ways to one light", balance_combines, balance},
        {"ggx_normal: a unit vector that is seen from o", normal_seen, normals},
        {"ggx_normal: the mean of what is seen", normal_mean, normals},
        {"ggx_normal: chi² against the visible normals", normal_cells, normals},
        {"ggx_normal: the rarest random numbers", normal_rare, rare_draws},
        {"ggx_normal: the same g, the same draw", normal_from_g, from_g},
        {"ggx_normal: the energy of a rough mirror", normal_energy, normals},
        {"ggx_normal_probability: G1 (o·h) D / o.z", seen_density, view_hint},
        {"ggx_normal_probability: 0 for what is not seen", unseen_density, view_hint},
        {"ggx_normal_probability: its integral is 1", seen_whole, view_hint},
        {"ggx_normal_probability: belongs to ggx_normal", seen_belongs, together},
        {"orthonormal_basis: for all n", basis_everywhere, given_code},
        {"orthonormal_basis: n.z near -1", basis_at_the_pole, given_code},
        {"to_local, to_world: there and back", there_and_back, given_code},
        {"power_heuristic: p² / (p² + q²)", power_values, given_code},
        {"power_heuristic: zero, huge, infinite", power_extremes, given_code},
        {"ggx_density: the integral of D h.z is 1", ggx_density_whole, given_code},
        {"ggx_brdf: reciprocity", ggx_reciprocal, given_code},
        {"ggx_brdf: 1 - ln 2 straight on", ggx_straight_on, given_code},
        {"ggx_weight: f_r cos θ / p", ggx_weight_belongs, made_of_yours},
        {"surface_scatter: weight and density belong to the direction", scatter_belongs,
         made_of_yours},
        {"surface_scatter: the same light as uniform directions", scatter_means, made_of_yours},
        {"lamps_aim: density and solid angle", aims_belong, made_of_yours},
        {"lamps_aim: lamps that look tiny", aims_at_tiny_spheres, made_of_yours},
        {"light_trace: a constant sky, mean and variance", constant_sky, made_of_yours},
        {"light_trace: a sphere light, mean and variance", lamp_variance, made_of_yours},
        {"light_trace: a lamp at a million radii", tiny_lamp, made_of_yours},
        {"light_trace: every strategy finds the same light in the box", box_means,
         made_of_yours},
        {"light_trace: every strategy finds the same light of spheres", sphere_means,
         made_of_yours},
        {"light_trace: never negative, never NaN", clean_light, made_of_yours},
    };
    return run_tests("10-importance-sampling", tests, COUNT(tests));
}
