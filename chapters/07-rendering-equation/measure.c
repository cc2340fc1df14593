// measure.c: how fast the rules converge, on smooth integrands and on rims; the same
// light by directions, by area and in closed form; and the curse of dimension.
#include <stdio.h>

#include "chapters/07-rendering-equation/rendering.h"
#include "common/exact3.h"

static const char *const rule_names[] = {"midpoint", "Simpson", "Gauss"};
static const double promised_smooth[] = {2, 4, NAN};

static double between(rng *g, double low, double high) {
    return low + (high - low) * rng_double(g);
}

// ---- errors by n, and their rate -------------------------------------------------------

enum { MOST_COLUMNS = 16 };

typedef struct {
    int count;
    double n[MOST_COLUMNS], error[MOST_COLUMNS];
} curve;

static void curve_add(curve *c, double n, double error) {
    c->n[c->count] = n;
    c->error[c->count++] = error;
}

// The slope of log error over log n, by least squares over what is not yet rounding.
static double rate(const curve *c) {
    double k = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (int i = c->count / 4; i < c->count; i++) {
        if (!(c->error[i] > 1e-12)) continue;
        const double x = log(c->n[i]), y = log(c->error[i]);
        k++, sx += x, sy += y, sxx += x * x, sxy += x * y;
    }
    return (k * sxy - sx * sy) / (k * sxx - sx * sx);
}

// `promised` is the exponent; NAN: faster than any power, 0: nothing is promised.
static void curve_rows(const char *table, const char *what, double promised, const curve *c,
                       const char *x_name, const char *error_name) {
    char name[120];
    if (isnan(promised))
        snprintf(name, sizeof name, "%s (faster than any power)", what);
    else
        snprintf(name, sizeof name, "%s (promised n^-%.3g, measured n^%.2f)", what, promised,
                 rate(c));
    for (int i = 0; i < c->count; i++)
        csv_row(table, name, x_name, c->n[i], error_name, c->error[i], "ns", NAN);
}

// ---- one dimension ------------------------------------------------------------------------

// With a place that moves, so that no rule is lucky.
typedef double line(const double *place, double x);

static double smooth_line(const double *place, double x) {
    (void)place;
    return PI / 2 * sin(PI * x);
}

static double jump_line(const double *place, double x) {
    return x > *place;
}

static double kink_line(const double *place, double x) {
    return fmax(0, x - *place);
}

static double smooth_integral(double place) {
    (void)place;
    return 1;
}

static double jump_integral(double place) {
    return 1 - place;
}

static double kink_integral(double place) {
    return (1 - place) * (1 - place) / 2;
}

typedef struct {
    line *f;
    const double *place;
} placed_line;

static double at_first(const void *data, const double *x) {
    const placed_line *l = data;
    return l->f(l->place, x[0]);
}

static void one_dimension(const char *table, line *f, double (*integral)(double), int places,
                          const double *promised) {
    for (int rule = MIDPOINT; rule <= GAUSS; rule++) {
        curve c = {0};
        for (int n = 3; n <= 513; n = 2 * n - 1) {
            rng g = rng_seed(7, 1);
            double squares = 0;
            for (int i = 0; i < places; i++) {
                const double place = between(&g, 0.2, 0.8);
                const placed_line l = {f, &place};
                const double off =
                    integrate_cube((quadrature)rule, n, 1, at_first, &l) - integral(place);
                squares += off * off / places;
            }
            curve_add(&c, n, sqrt(squares));
        }
        curve_rows(table, rule_names[rule], promised[rule], &c, "n", "error");
    }
}

static void measure_lines(void) {
    const double jump[] = {1, 1, 1}, kink[] = {2, 2, 2};
    one_dimension("one dimension: smooth", smooth_line, smooth_integral, 1, promised_smooth);
    one_dimension("one dimension: a kink", kink_line, kink_integral, 100, kink);
    one_dimension("one dimension: a jump", jump_line, jump_integral, 100, jump);
}

// ---- the hemisphere -------------------------------------------------------------------------

// One light above the origin, the normal z, and the E that is right.
typedef struct {
    radiance_field L_i;
    const void *light;
    double E;
    vec3 e; // what the light is made of
    sphere S;
    disc D;
    rectangle R;
} lit;

static const vec3 origin = {0, 0, 0}, z_axis = {0, 0, 1};

static double from_one_side(const void *e, vec3 x, vec3 w) {
    (void)x;
    return 1 + dot(w, *(const vec3 *)e);
}

static void side_sky(lit *l, rng *g) {
    l->e = unit_vector(g);
    l->L_i = from_one_side, l->light = &l->e;
    l->E = PI + 2 * PI / 3 * l->e.z;
}

// A direction at an angle from n in [low, high), to any side.
static vec3 aslant(vec3 n, double low, double high, rng *g) {
    const double theta = between(g, low, high), phi = between(g, 0, 2 * PI);
    return direction_at(n, theta, phi);
}

static void some_sphere(lit *l, double distance, double low, double high, rng *g) {
    l->S = (sphere){scale((real)distance, aslant(z_axis, low, high, g)), 1};
    l->L_i = from_sphere, l->light = &l->S;
    l->E = sphere_irradiance(l->S, origin, z_axis);
}

static void sphere_above(lit *l, rng *g) {
    some_sphere(l, between(g, 1.5, 3), 0, 0, g);
}

static void sphere_anywhere(lit *l, rng *g) {
    some_sphere(l, between(g, 2, 4), 0.3, 0.9, g);
}

static void sphere_cut(lit *l, rng *g) {
    some_sphere(l, between(g, 1.5, 3), 1.4, 1.7, g);
}

static void disc_anywhere(lit *l, rng *g) {
    const vec3 axis = aslant(z_axis, 0.2, 0.6, g);
    const double r = between(g, 0.4, 0.8);
    l->D = (disc){{axis, axis}, (real)r};
    l->L_i = from_disc, l->light = &l->D;
    l->E = PI * r * r / (1 + r * r) * (double)axis.z;
}

// Square, with sides of the length `size`, about a point at the distance 1.
static rectangle some_rectangle(double size, rng *g) {
    const vec3 centre = aslant(z_axis, 0.2, 0.7, g);
    const vec3 towards = normalize(add(neg(centre), scale((real)0.3, unit_vector(g))));
    const vec3 s1 = narrow(perpendicular_at(towards, between(g, 0, 6)));
    const vec3 a = scale((real)size, s1), b = scale((real)size, cross(towards, s1));
    return (rectangle){sub(centre, scale((real)0.5, add(a, b))), a, b};
}

static void rectangle_anywhere(lit *l, rng *g) {
    l->R = some_rectangle(between(g, 0.4, 0.8), g);
    l->L_i = from_rectangle, l->light = &l->R;
    l->E = rectangle_irradiance(l->R, origin, z_axis);
}

static const struct {
    const char *name;
    void (*make)(lit *l, rng *g);
    double promised;
} skies[] = {{"smooth sky", side_sky, 2},
             {"sphere straight above", sphere_above, 1},
             {"sphere anywhere", sphere_anywhere, 1.5},
             {"sphere, cut by the horizon", sphere_cut, 1.5},
             {"disc", disc_anywhere, 1.5},
             {"square", rectangle_anywhere, 1.5}};

static void measure_hemisphere(void) {
    enum { PLACES = 32 };
    for (int k = 0; k < COUNT(skies); k++) {
        curve c = {0};
        for (int n = 4; n <= 128; n *= 2) {
            rng g = rng_seed(7, 2);
            double squares = 0;
            for (int i = 0; i < PLACES; i++) {
                lit l;
                skies[k].make(&l, &g);
                const double E = irradiance(l.L_i, l.light, origin, z_axis, n, 2 * n);
                squares += (E / l.E - 1) * (E / l.E - 1) / PLACES;
            }
            curve_add(&c, n, sqrt(squares));
        }
        curve_rows("hemisphere, n x 2n directions", skies[k].name, skies[k].promised, &c, "n",
                   "relative error");
    }
}

// ---- the light's area -------------------------------------------------------------------------

// Against Gauss with so many points that the error is rounding.
static double area_error(quadrature rule, int n, double size) {
    enum { PLACES = 12 };
    rng g = rng_seed(7, 3);
    double squares = 0;
    for (int i = 0; i < PLACES; i++) {
        const rectangle R = some_rectangle(size, &g);
        const double E = rectangle_irradiance(R, origin, z_axis);
        const double off = rectangle_irradiance_by_area(rule, n, R, origin, z_axis) / E - 1;
        squares += off * off / PLACES;
    }
    return sqrt(squares);
}

static void measure_area(void) {
    for (int rule = MIDPOINT; rule <= GAUSS; rule++) {
        curve c = {0};
        for (int n = 3; n <= 65; n = 2 * n - 1)
            curve_add(&c, n, area_error((quadrature)rule, n, 0.8));
        curve_rows("over a square, n x n points", rule_names[rule], promised_smooth[rule], &c,
                   "n", "relative error");
    }
}

// A point below the middle of a unit square, at the distance `near`.
static void measure_near(void) {
    const int points[] = {4, 16, 64};
    for (int k = 0; k < COUNT(points); k++)
        for (double near = 1; near > 5e-4; near /= 10) {
            const rectangle R = {{(real)-0.45, (real)-0.55, (real)near}, {0, 1, 0}, {1, 0, 0}};
            const double E = rectangle_irradiance(R, origin, z_axis);
            char name[60];
            snprintf(name, sizeof name, "over the square, Gauss %d x %d", points[k], points[k]);
            csv_row(
                "near a unit square", name, "distance", near, "relative error",
                fabs(rectangle_irradiance_by_area(GAUSS, points[k], R, origin, z_axis) / E - 1),
                "ns", NAN);
        }
}

// What share of the spheres is between two directions, and how wrong are all together?
static void measure_small(void) {
    enum { PLACES = 64, N = 64 };
    for (double distance = 2; distance < 3000; distance *= 4) {
        rng g = rng_seed(7, 4);
        double squares = 0, missed = 0;
        for (int i = 0; i < PLACES; i++) {
            lit l;
            some_sphere(&l, distance, 0.3, 0.9, &g);
            const double E = irradiance(l.L_i, l.light, origin, z_axis, N, 2 * N);
            squares += (E / l.E - 1) * (E / l.E - 1) / PLACES;
            missed += (E == 0) / (double)PLACES;
        }
        csv_row("small lights, 64 x 128 directions", "relative error", "distance / radius",
                distance, "of 64 spheres", sqrt(squares), "ns", NAN);
        csv_row("small lights, 64 x 128 directions", "share not seen at all",
                "distance / radius", distance, "of 64 spheres", missed, "ns", NAN);
    }
}

// ---- Lambert's formula, far away ------------------------------------------------------------------

typedef double edge(vec3 a, vec3 side, vec3 n);

static double by_acos(vec3 a, vec3 side, vec3 n) {
    const vec3 b = add(a, side), normal = cross(a, b);
    return (double)(acos(dot(a, b) / (length(a) * length(b))) * dot(normal, n) /
                    length(normal));
}

static double by_atan2(vec3 a, vec3 side, vec3 n) {
    const vec3 b = add(a, side), normal = cross(a, b);
    return (double)(atan2(length(normal), dot(a, b)) * dot(normal, n) / length(normal));
}

static double by_side(vec3 a, vec3 side, vec3 n) {
    const vec3 b = add(a, side), normal = cross(a, side);
    return (double)(atan2(length(normal), dot(a, b)) * dot(normal, n) / length(normal));
}

static double lambert_formula(edge *part, rectangle R) {
    const vec3 p0 = R.corner, p1 = add(p0, R.side1), p3 = add(p0, R.side2);
    return -(part(p0, R.side1, z_axis) + part(p1, R.side2, z_axis) - part(p3, R.side1, z_axis) -
             part(p0, R.side2, z_axis)) /
           2;
}

static double with_acos(rectangle R) {
    return lambert_formula(by_acos, R);
}

static double with_atan2(rectangle R) {
    return lambert_formula(by_atan2, R);
}

static double with_side(rectangle R) {
    return lambert_formula(by_side, R);
}

static double double_inside(rectangle R) {
    return rectangle_irradiance(R, origin, z_axis);
}

static double by_gauss(rectangle R) {
    return rectangle_irradiance_by_area(GAUSS, 4, R, origin, z_axis);
}

static const struct {
    const char *name;
    double (*E)(rectangle R);
} formulas[] = {{"acos, a x b", with_acos},
                {"atan2, a x b", with_atan2},
                {"atan2, a x side", with_side},
                {"atan2, a x side, double inside", double_inside},
                {"over the area, Gauss 4 x 4", by_gauss}};

static void measure_far(void) {
    enum { PLACES = 101 };
    for (int k = 0; k < COUNT(formulas); k++)
        for (int far = 0; far <= 9; far++) {
            rng g = rng_seed(7, 5);
            double errors[PLACES];
            for (int i = 0; i < PLACES; i++) {
                const rectangle R = some_rectangle(pow(10, -far), &g);
                const double E = rectangle_irradiance_by_area(GAUSS, 24, R, origin, z_axis);
                errors[i] = fabs(formulas[k].E(R) / E - 1);
                if (isnan(errors[i])) errors[i] = 1; // 0/0: all of it is lost
            }
            csv_row("Lambert's formula, far away", formulas[k].name, "distance / size",
                    pow(10, far), "median relative error", quantile(errors, PLACES, 0.5), "ns",
                    NAN);
        }
}

// ---- what it costs -----------------------------------------------------------------------------------

enum { CASES = 64 };

#define BY_HEMISPHERE(n)                                                                 \
    static double by_hemisphere_##n(rectangle R) {                                       \
        return irradiance(from_rectangle, &R, origin, z_axis, n, 2 * n);                 \
    }                                                                                    \
    static void run_hemisphere_##n(void *data) {                                         \
        for (int i = 0; i < CASES; i++) keep(by_hemisphere_##n(((rectangle *)data)[i])); \
    }
#define BY_AREA(n)                                                                 \
    static double by_area_##n(rectangle R) {                                       \
        return rectangle_irradiance_by_area(GAUSS, n, R, origin, z_axis);          \
    }                                                                              \
    static void run_area_##n(void *data) {                                         \
        for (int i = 0; i < CASES; i++) keep(by_area_##n(((rectangle *)data)[i])); \
    }
BY_HEMISPHERE(8)
BY_HEMISPHERE(32)
BY_HEMISPHERE(128)
BY_AREA(2)
BY_AREA(4)
BY_AREA(8)

static void run_closed(void *data) {
    for (int i = 0; i < CASES; i++) keep(double_inside(((rectangle *)data)[i]));
}

static const struct {
    const char *name;
    double (*E)(rectangle R);
    void (*run)(void *data);
} ways[] = {{"Lambert's formula", double_inside, run_closed},
            {"over the area, Gauss 2 x 2", by_area_2, run_area_2},
            {"over the area, Gauss 4 x 4", by_area_4, run_area_4},
            {"over the area, Gauss 8 x 8", by_area_8, run_area_8},
            {"8 x 16 directions", by_hemisphere_8, run_hemisphere_8},
            {"32 x 64 directions", by_hemisphere_32, run_hemisphere_32},
            {"128 x 256 directions", by_hemisphere_128, run_hemisphere_128}};

static void measure_cost(void) {
    static rectangle R[CASES];
    timed timings[COUNT(ways)];
    double ns[COUNT(ways)];
    rng g = rng_seed(7, 6);
    for (int i = 0; i < CASES; i++) R[i] = some_rectangle(0.8, &g);
    for (int k = 0; k < COUNT(ways); k++) timings[k] = (timed){ways[k].name, ways[k].run};
    measure_ns(timings, COUNT(ways), R, CASES, 5, ns);
    for (int k = 0; k < COUNT(ways); k++) {
        double squares = 0;
        for (int i = 0; i < CASES; i++) {
            const double E = rectangle_irradiance_by_area(GAUSS, 24, R[i], origin, z_axis);
            const double off = ways[k].E(R[i]) / E - 1;
            squares += off * off / CASES;
        }
        csv_row("E of a square: error and cost", ways[k].name, "random squares", CASES,
                "relative error, root mean square", sqrt(squares), "ns", ns[k]);
    }
}

// ---- the curse of dimension --------------------------------------------------------------------------

typedef struct {
    int dimensions;
    double radius;
} solid;

static double sines(const void *data, const double *x) {
    double product = 1;
    for (int k = 0; k < ((const solid *)data)->dimensions; k++)
        product *= PI / 2 * sin(PI * x[k]);
    return product;
}

// A corner of the ball about the origin: in two dimensions the lecture's circle.
static double in_ball(const void *data, const double *x) {
    const solid *s = data;
    double square = 0;
    for (int k = 0; k < s->dimensions; k++) square += x[k] * x[k];
    return square <= s->radius * s->radius;
}

static double ball_share(int d, double radius) {
    return pow(sqrt(PI) / 2 * radius, d) / tgamma(d / 2.0 + 1);
}

// The most points an axis with n^d <= budget; 0 when the rule has none so few. Gauss's
// points take n² work to find, and more than 512 gain nothing.
static int points_per_axis(quadrature rule, double budget, int d) {
    int n = (int)floor(pow(budget, 1.0 / d) + 1e-9);
    if (rule == GAUSS && n > 512) return 512;
    if (rule == SIMPSON && n % 2 == 0) n--;
    return rule == SIMPSON && n < 3 ? 0 : n;
}

static double smooth_error(quadrature rule, int n, int d) {
    const solid s = {d, 1};
    return fabs(integrate_cube(rule, n, d, sines, &s) - 1);
}

static double ball_error(quadrature rule, int n, int d) {
    enum { RADII = 3 };
    double squares = 0;
    for (int i = 0; i < RADII; i++) {
        const solid s = {d, 1 - 0.053 * i};
        const double off =
            integrate_cube(rule, n, d, in_ball, &s) / ball_share(d, s.radius) - 1;
        squares += off * off / RADII;
    }
    return sqrt(squares);
}

// Random points: the standard error, from the variance that each integrand has.
static double smooth_random(double budget, int d) {
    return sqrt((pow(PI * PI / 8, d) - 1) / budget);
}

static double ball_random(double budget, int d) {
    return sqrt((1 / ball_share(d, 1) - 1) / budget);
}

static void curse(const char *table, double budget, double (*error)(quadrature, int, int),
                  double (*at_random)(double, int), int from) {
    for (int rule = MIDPOINT; rule <= GAUSS; rule++)
        for (int d = from; d <= MOST_DIMENSIONS; d++) {
            const int n = points_per_axis((quadrature)rule, budget, d);
            csv_row(table, rule_names[rule], "dimensions", d, "relative error",
                    n ? error((quadrature)rule, n, d) : (double)NAN, "ns", NAN);
        }
    for (int d = from; d <= MOST_DIMENSIONS; d++)
        csv_row(table, "random points (chapter 08)", "dimensions", d, "relative error",
                at_random(budget, d), "ns", NAN);
}

static void measure_curse(void) {
    curse("curse: smooth, 4096 evaluations", 4096, smooth_error, smooth_random, 1);
    curse("curse: smooth, 262144 evaluations", 262144, smooth_error, smooth_random, 1);
    curse("curse: a ball, 4096 evaluations", 4096, ball_error, ball_random, 2);
    curse("curse: a ball, 262144 evaluations", 262144, ball_error, ball_random, 2);
}

int main(void) {
    measure_far();
    if (sizeof(real) > sizeof(float)) return 0; // the rest is double inside in both
    measure_lines();
    measure_hemisphere();
    measure_area();
    measure_near();
    measure_small();
    measure_cost();
    measure_curse();
}
