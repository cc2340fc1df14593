// Tests of 07-rendering-equation: the cosine, the solid angle and π; integrals over the
// hemisphere and over a light; and a judge for any BRDF.
#include "chapters/07-rendering-equation/rendering.h"
#include "common/measure.h"
#include "tests/check-generic.h"
#include "tests/check.h"

#include <stdarg.h>
#include <stdio.h>

static const char *in_words(const char *format, ...) __attribute__((format(printf, 1, 2)));
static const char *in_words(const char *format, ...) {
    static char words[300];
    va_list args;
    va_start(args, format);
    vsnprintf(words, sizeof words, format, args);
    va_end(args);
    return words;
}

// CHECK, and what is the case instead: printf's format.
#define DEMAND(holds, claim, ...)                                                          \
    do {                                                                                   \
        if (!(holds)) check_that(__FILE__, __LINE__, in_words(__VA_ARGS__), false, claim); \
    } while (0)
// CHECK_AT_MOST of something that has a name.
#define DEMAND_AT_MOST(what, got, bound, why) \
    check_at_most(__FILE__, __LINE__, what, got, bound, why)

// A point and a unit normal, along no axis.
typedef struct {
    vec3 x, n;
} place;

static place some_place(rng *g) {
    const real x = (real)between(g, -3, 3), y = (real)between(g, -3, 3),
               z = (real)between(g, -3, 3);
    return (place){{x, y, z}, unit_vector(g)};
}

// The point at the distance d in the direction (theta, phi) about n.
static vec3 point_from(place at, double d, double theta, double phi) {
    const wide3 w = widen(direction_at(at.n, theta, phi));
    return narrow(wide_along(widen(at.x), d, w));
}

// A direction at an angle from n in [low, high), to any side.
static vec3 aslant(vec3 n, double low, double high, rng *g) {
    const double theta = between(g, low, high), phi = between(g, 0, 2 * PI);
    return direction_at(n, theta, phi);
}

#define PLACE_TEXT "x = " VEC ", n = " VEC
#define ARG_PLACE(at) ARG((at).x), ARG((at).n)

// ---- the integral over the hemisphere, and how it goes wrong ------------------------

typedef enum {
    RIGHT,
    NO_COSINE,
    NO_SINE,
    NEITHER,
    COSINE_TWICE,
    WHOLE_SPHERE,
    WHOLE_NO_SINE,
    NO_SINE_TWICE,
    SINE_AT_CORNER,
    ABOUT_Z,
    HALF_ROUND,
    SWAPPED,
    X_AND_W,
    SLIPS
} slip;

static const char *const slip_names[SLIPS] = {
    [NO_COSINE] = "the integral without the cosine w·n",
    [NO_SINE] = "the integral without the sine of dw = sin θ dθ dφ",
    [NEITHER] = "the integral with neither cosine nor sine",
    [COSINE_TWICE] = "the cosine was taken twice",
    [WHOLE_SPHERE] = "θ ran from 0 to π: what comes from below was added, or taken off",
    [WHOLE_NO_SINE] = "the sine of dw is missing, and θ ran from 0 to π",
    [NO_SINE_TWICE] = "the sine of dw is missing, and dθ is π / n_theta, not half of it",
    [SINE_AT_CORNER] = "the sine of the cell's corner, sin(i dθ), not of its middle",
    [ABOUT_Z] = "the hemisphere about the z axis, not about n",
    [HALF_ROUND] = "φ ran only half the way round",
    [X_AND_W] = "L_i(world, w, x): x comes before w",
    [SWAPPED] = "n_theta and n_phi are swapped in the loops",
};

static double with_slip(slip s, radiance_field L_i, const void *world, place at, int n_theta,
                        int n_phi) {
    const bool whole = s == WHOLE_SPHERE || s == WHOLE_NO_SINE;
    const bool sine = s != NO_SINE && s != NEITHER && s != WHOLE_NO_SINE && s != NO_SINE_TWICE;
    const double d_theta = (whole ? PI : PI / 2) / n_theta;
    const double d_phi = (s == HALF_ROUND ? PI : 2 * PI) / n_phi;
    const vec3 n = s == ABOUT_Z ? (vec3){0, 0, 1} : at.n;
    const int sectors = s == SWAPPED ? n_theta : n_phi;
    double sum = 0;
    for (int k = 0; k < n_theta * n_phi; k++) {
        const double theta = (k / sectors + 0.5) * d_theta, phi = (k % sectors + 0.5) * d_phi;
        const vec3 w = direction_at(n, theta, phi);
        double weight = d_theta * d_phi;
        if (s != NO_COSINE && s != NEITHER) weight *= cos(theta);
        if (s == COSINE_TWICE) weight *= cos(theta);
        if (sine) weight *= sin(s == SINE_AT_CORNER ? theta - d_theta / 2 : theta);
        sum += weight * (s == X_AND_W ? L_i(world, w, at.x) : L_i(world, at.x, w));
    }
    return s == NO_SINE_TWICE ? 2 * sum : sum;
}

static bool alike(double a, double b) {
    return fabs(a - b) <= 0.02 * fabs(b);
}

// A slip that changes nothing here, or leaves nothing, cannot be told. Half round and
// swapped loops can be the same: then both are named.
static void suspect_slips(radiance_field L_i, const void *world, place at, int n_theta,
                          int n_phi) {
    double value[SLIPS];
    for (int s = RIGHT; s < SLIPS; s++)
        value[s] = with_slip((slip)s, L_i, world, at, n_theta, n_phi);
    if (alike(value[HALF_ROUND], value[SWAPPED])) {
        suspect_value("φ did not run all the way round: only to π, or n_theta and n_phi are "
                      "swapped in the loops",
                      value[SWAPPED]);
        value[HALF_ROUND] = value[SWAPPED] = 0;
    }
    for (int s = RIGHT + 1; s < SLIPS; s++)
        if (value[s] != 0 && !alike(value[s], value[RIGHT]))
            suspect_value(slip_names[s], value[s]);
    suspect_factor("dθ dφ is missing", (double)n_theta * n_phi / (PI * PI));
    suspect_factor("dθ is missing", n_theta / (PI / 2));
    suspect_factor("dφ is missing", n_phi / (2 * PI));
}

// A light of radiance 0 or 1 has a rim, and the cells that it crosses count whole or not
// at all: by chance, since it crosses them anywhere. A cell's variance is its weight
// squared times the mean of f(1 - f) = 1/6, f the share that is lit: five standard
// errors are 2.04 of the root of the sum of squares; half as many again, since neighbours
// are not quite independent where the rim runs along the grid.
static double rim_tolerance(radiance_field L_i, const void *world, place at, int n_theta,
                            int n_phi) {
    enum { MOST = 1024 };
    const double d_theta = PI / 2 / n_theta, d_phi = 2 * PI / n_phi;
    bool above[MOST + 1], below[MOST + 1];
    double squares = 0;
    for (int i = 0; i <= n_theta; i++) {
        for (int j = 0; j <= n_phi; j++)
            below[j] = L_i(world, at.x, direction_at(at.n, i * d_theta, j * d_phi)) > 0;
        for (int j = 0; i > 0 && j < n_phi; j++) {
            const int lit = above[j] + above[j + 1] + below[j] + below[j + 1];
            const double theta = (i - 0.5) * d_theta;
            const double weight = cos(theta) * sin(theta) * d_theta * d_phi;
            if (lit > 0 && lit < 4) squares += weight * weight;
        }
        for (int j = 0; j <= n_phi; j++) above[j] = below[j];
    }
    return 3 * sqrt(squares);
}

// The midpoint rule's own error on a smooth integrand of size 1.
static double smooth_tolerance(int n_theta) {
    const double h = PI / 2 / n_theta;
    return PI * h * h;
}

static void check_light(const char *what, radiance_field L_i, const void *world, place at,
                        double expected) {
    enum { N = 160, M = 400 };
    given("%s of radiance 1; " PLACE_TEXT "; n_theta = %d, n_phi = %d", what, ARG_PLACE(at), N,
          M);
    suspect_slips(L_i, world, at, N, M);
    CHECK_REAL(irradiance(L_i, world, at.x, at.n, N, M), expected,
               absolute_of(rim_tolerance(L_i, world, at, N, M) + smooth_tolerance(N),
                           "the cells that the light's rim crosses count whole or not at all"));
}

// ---- irradiance ------------------------------------------------------------------------

static void uniform_sky(void) {
    rng g = check_rng(1);
    for (int i = 0; i < 20; i++) {
        const place at = some_place(&g);
        const int n_theta = 10 + 7 * i, n_phi = 8 + 3 * i;
        given("a sky of radiance 1 all around; " PLACE_TEXT "; n_theta = %d, n_phi = %d",
              ARG_PLACE(at), n_theta, n_phi);
        suspect_value("2π: the cosine w·n is missing, or the sine of dw = sin θ dθ dφ", 2 * PI);
        suspect_value(slip_names[NEITHER], PI * PI);
        suspect_value(slip_names[COSINE_TWICE], 2 * PI / 3);
        suspect_value("neither sine nor cosine, and dθ = π / n_theta: θ ends at π/2",
                      2 * PI * PI);
        suspect_value("the sine of dw is missing, and dθ is π / n_theta, not half of it",
                      4 * PI);
        suspect_factor(slip_names[HALF_ROUND], 0.5);
        suspect_factor("dθ dφ is missing", (double)n_theta * n_phi / (PI * PI));
        suspect_value(slip_names[SWAPPED],
                      with_slip(SWAPPED, from_uniform_sky, NULL, at, n_theta, n_phi));
        const double E = irradiance(from_uniform_sky, NULL, at.x, at.n, n_theta, n_phi);
        if (E != 0 && fabs(E) < 1e-9)
            suspect_value("nothing is left: θ ran from 0 to π, and what comes from below was "
                          "taken off",
                          E);
        CHECK_REAL(irradiance(from_uniform_sky, NULL, at.x, at.n, n_theta, n_phi), PI,
                   absolute_of(smooth_tolerance(n_theta), "the midpoint rule's own error"));
    }
}

// A smooth sky, brighter towards the normal and to one side.
typedef struct {
    vec3 n, e;
} smooth;

static double from_smooth_sky(const void *world, vec3 x, vec3 w) {
    const smooth *s = world;
    (void)x;
    const double c = dot(w, s->n), aside = dot(w, s->e);
    return c * c + (1 + aside) / 2;
}

// ∫ c³ dw = π/2, ∫ c dw = π, and ∫ (w·e) c dw = (2π/3) n·e.
static double smooth_irradiance(const smooth *s) {
    return PI / 2 + PI / 2 + PI / 3 * dot(s->n, s->e);
}

static void smooth_sky(void) {
    rng g = check_rng(2);
    for (int i = 0; i < 20; i++) {
        const place at = some_place(&g);
        const smooth s = {at.n, unit_vector(&g)};
        given("a smooth sky, brightest straight above; " PLACE_TEXT
              "; n_theta = 50, n_phi = 70",
              ARG_PLACE(at));
        suspect_slips(from_smooth_sky, &s, at, 50, 70);
        CHECK_REAL(irradiance(from_smooth_sky, &s, at.x, at.n, 50, 70), smooth_irradiance(&s),
                   absolute_of(3 * smooth_tolerance(50),
                               "the midpoint rule's own error, for a sky of up to 2"));
    }
}

static void promised_rate(void) {
    rng g = check_rng(3);
    const place at = some_place(&g);
    const smooth s = {at.n, unit_vector(&g)};
    const double E = smooth_irradiance(&s);
    for (int n = 8; n <= 64; n *= 2) {
        given("a smooth sky, E = %.9g; %d x %d directions", E, n, n);
        const double once = irradiance(from_smooth_sky, &s, at.x, at.n, n, n) - E;
        const double twice = irradiance(from_smooth_sky, &s, at.x, at.n, 2 * n, 2 * n) - E;
        given("a smooth sky, E = %.9g; the error with %d x %d directions is %.3g", E, n, n,
              once);
        DEMAND_AT_MOST(
            "irradiance, twice as many directions each way: its error", fabs(twice),
            fabs(once) / 3.5 + 1e-6,
            "twice as many directions each way: an error of n^-2 falls to a quarter");
    }
}

static double from_half_space(const void *e, vec3 x, vec3 w) {
    (void)x;
    return dot(w, *(const vec3 *)e) > 0;
}

// Lit from the side of e: the lit part of the unit circle is half of it, and half an ellipse.
static void half_sky(void) {
    rng g = check_rng(4);
    for (int i = 0; i < 10; i++) {
        const place at = some_place(&g);
        // Not too upright: the rim would run along a ring or a sector of the grid.
        const vec3 e = aslant(at.n, 0.5, 1.2, &g);
        check_light("one half of the sky", from_half_space, &e, at,
                    PI / 2 * (1 + (double)dot(at.n, e)));
    }
}

// A sphere of the radius 1 at the height h, moved x to the side, about any place.
static sphere sphere_beside(place at, double x, double h, double phi) {
    return (sphere){point_from(at, sqrt(x * x + h * h), atan2(x, h), phi), 1};
}

// Its rim is a circle of the grid: all the cells round it count, or none.
static void sphere_above(void) {
    const double heights[] = {1.5, 2, 3.7, 10}, known[] = {1.396263401595, 0.785398163397};
    rng g = check_rng(5);
    for (int i = 0; i < COUNT(heights); i++) {
        enum { N = 1500, M = 40 };
        const double h = heights[i], E = i < 2 ? known[i] : PI / (h * h);
        const place at = some_place(&g);
        const sphere S = sphere_beside(at, 0, h, 0);
        given(
            "a sphere of radius 1 and radiance 1, straight above at the height %g; " PLACE_TEXT
            "; n_theta = %d, n_phi = %d",
            h, ARG_PLACE(at), N, M);
        suspect_slips(from_sphere, &S, at, N, M);
        CHECK_REAL(irradiance(from_sphere, &S, at.x, at.n, N, M), E,
                   absolute_of(PI / h * (PI / 2 / N) + smooth_tolerance(N),
                               "the ring of cells in which the sphere's rim lies"));
    }
}

static void sphere_half_below(void) {
    const double heights[] = {0.5, 0}, known[] = {0.196801876179, 0.090586073706};
    rng g = check_rng(6);
    for (int i = 0; i < COUNT(heights); i++) {
        const place at = some_place(&g);
        const sphere S = sphere_beside(at, 2, heights[i], between(&g, 0, 6));
        char what[100];
        snprintf(what, sizeof what,
                 "a sphere, radius 1, 2 to the side, %g up: the horizon cuts it", heights[i]);
        check_light(what, from_sphere, &S, at, known[i]);
    }
}

static void spheres_anywhere(void) {
    rng g = check_rng(7);
    for (int i = 0; i < 12; i++) {
        const place at = some_place(&g);
        const double d = between(&g, 1.3, 3), angle = between(&g, 0.3, 1.0);
        const double x = d * sin(angle), h = d * cos(angle);
        const sphere S = sphere_beside(at, x, h, between(&g, 0, 6));
        if (h > 1) check_light("a sphere, radius 1", from_sphere, &S, at, PI * h / (d * d * d));
        check_light("a sphere, radius 1", from_sphere, &S, at,
                    sphere_irradiance(S, at.x, at.n));
    }
}

// The normal of the light is not n: the light is tilted.
static rectangle rectangle_facing(place at, rng *g) {
    const double angle = between(g, 0.2, 0.7), phi = between(g, 0, 6);
    const vec3 centre = point_from(at, between(g, 1.2, 2), angle, phi);
    const vec3 towards =
        normalize(add(normalize(sub(at.x, centre)), scale((real)0.2, unit_vector(g))));
    const vec3 s1 = scale((real)between(g, 0.4, 0.9), narrow(perpendicular_at(towards, 1)));
    const vec3 s2 = scale((real)between(g, 0.4, 0.9), cross(towards, normalize(s1)));
    return (rectangle){sub(centre, scale((real)0.5, add(s1, s2))), s1, s2};
}

static void discs_and_rectangles(void) {
    rng g = check_rng(8);
    for (int i = 0; i < 8; i++) {
        const place at = some_place(&g);
        const double r = between(&g, 0.5, 1.5), h = between(&g, 0.7, 2);
        const double tilt = between(&g, 0.1, 0.4);
        const vec3 axis = direction_at(at.n, tilt, between(&g, 0, 6));
        const disc D = {{narrow(wide_along(widen(at.x), h, widen(axis))), axis}, (real)r};
        if (atan2(r, h) + tilt < 1.5) // above the horizon
            check_light("a disc", from_disc, &D, at, PI * r * r / (r * r + h * h) * cos(tilt));
        const rectangle R = rectangle_facing(at, &g);
        check_light("a rectangle", from_rectangle, &R, at, rectangle_irradiance(R, at.x, at.n));
    }
}

// What L_i was asked for: how often wrongly, and the first wrong direction.
enum { ASKED_THETA = 12, ASKED_PHI = 17, ASKED = ASKED_THETA * ASKED_PHI };

typedef struct {
    place at;
    int count, elsewhere, turned_round, not_unit, below;
    vec3 first_not_unit, first_below;
    int off_middle, at_rings, rings[ASKED_THETA + 1];
    double first_off;
} asked;

static double angle_between(vec3 a, vec3 b) {
    const wide3 across = wide_cross(widen(a), widen(b));
    return atan2(sqrt(wide_dot(across, across)), wide_dot(widen(a), widen(b)));
}

static bool same_vec3(vec3 a, vec3 b) {
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

static void note_direction(asked *a, vec3 w) {
    const bool unit = fabs(wide_dot(widen(w), widen(w)) - 1) < 16 * REAL_EPSILON;
    const bool above = wide_dot(widen(w), widen(a->at.n)) > -8 * REAL_EPSILON;
    if (!unit && a->not_unit++ == 0) a->first_not_unit = w;
    if (!above && a->below++ == 0) a->first_below = w;
    const double theta = angle_between(w, a->at.n), rows = theta / (PI / 2 / ASKED_THETA);
    if (!(fabs(rows - floor(rows) - 0.5) < 0.01) && a->off_middle++ == 0) a->first_off = theta;
    const int ring = (int)lround(rows);
    if (!(fabs(rows - ring) < 0.01) || ring > ASKED_THETA) return;
    a->at_rings++;
    a->rings[ring]++;
}

static double takes_notes(const void *world, vec3 x, vec3 w) {
    asked *a = *(asked *const *)world;
    a->count++;
    a->elsewhere += !same_vec3(x, a->at.x);
    a->turned_round += same_vec3(w, a->at.x);
    note_direction(a, same_vec3(w, a->at.x) ? x : w);
    return 1;
}

static void demand_good_directions(const asked *a) {
    DEMAND(a->not_unit == 0, "all directions are unit vectors",
           "%d of %d are not, the first w = " VEC, a->not_unit, a->count,
           ARG(a->first_not_unit));
    DEMAND(a->below == 0, "all directions lie in the hemisphere of n: w·n > 0",
           "%d of %d directions lie below, first w = " VEC, a->below, a->count,
           ARG(a->first_below));
}

// The midpoint rule, in whatever order, wherever φ begins.
static void demand_middles(const asked *a) {
    const char *claim = "θ is the middle of a cell, (i + 0.5) dθ, for i from 0 to 11";
    const bool corners = a->at_rings == a->count;
    DEMAND(!corners || a->rings[0] == 0, claim,
           "θ = 0 was asked: the corner of the cell, not its middle: i dθ");
    DEMAND(!corners, claim,
           "θ = dθ, 2dθ … was asked: the far corner of the cell, not its middle: (i + 1) dθ");
    DEMAND(a->off_middle == 0, claim, "%d of %d are not, the first θ = %.4g = %.3g dθ",
           a->off_middle, a->count, a->first_off, a->first_off / (PI / 2 / ASKED_THETA));
}

static void asks_as_promised(void) {
    rng g = check_rng(9);
    asked notes = {.at = some_place(&g)};
    asked *world = &notes;
    given(PLACE_TEXT "; n_theta = %d, n_phi = %d; how often L_i is asked", ARG_PLACE(notes.at),
          ASKED_THETA, ASKED_PHI);
    suspect_value("12 x 12", 144);
    suspect_value("17 x 17", 289);
    irradiance(takes_notes, &world, notes.at.x, notes.at.n, ASKED_THETA, ASKED_PHI);
    check_int(__FILE__, __LINE__, "L_i, how often", notes.count, ASKED);
    DEMAND(notes.turned_round == 0, "L_i(world, x, w): first the point, then the direction",
           "x and w are swapped");
    DEMAND(notes.elsewhere == 0, "L_i is asked about x", "%d of %d times about another point",
           notes.elsewhere, notes.count);
    demand_good_directions(&notes);
    demand_middles(&notes);
}

static void any_size(void) {
    rng g = check_rng(10);
    const place at = some_place(&g);
    const sphere S = sphere_beside(at, 0.9, 1.4, 2);
    given("a sphere of radius 1 beside x; n_theta = 40, n_phi = 60");
    const double E = irradiance(from_sphere, &S, at.x, at.n, 40, 60);
    for (int k = -20; k <= 30; k += 10) {
        const real size = (real)ldexp(1, k);
        const sphere T = {scale(size, S.c), size * S.r};
        const vec3 x = scale(size, at.x);
        given("a sphere and x, 2^%d times as large", k);
        CHECK_REAL(
            irradiance(from_sphere, &T, x, at.n, 40, 60), E,
            relative_to(1e-12, "the same directions, and a power of two does not round"));
    }
}

// ---- lambert_brdf ------------------------------------------------------------------------

static void lambert_value(void) {
    const double rhos[] = {0.5, 1, 0.18, 0.73, 0};
    for (int i = 0; i < COUNT(rhos); i++) {
        const double rho = rhos[i];
        given("rho = %g", rho);
        suspect_value(
            "rho: the directions of the hemisphere, weighted by the cosine, measure π", rho);
        suspect_value("rho / 2π: the hemisphere's solid angle, without the cosine",
                      rho / (2 * PI));
        suspect_value("1 / π: it does not depend on rho", 1 / PI);
        suspect_value("rho times π", rho * PI);
        suspect_value("the PI of a whole sphere: rho / 4π", rho / (4 * PI));
        CHECK_REAL(lambert_brdf(rho), rho / PI, roundings(8, "a quotient and π, in real"));
    }
}

static void lambert_reflects_rho(void) {
    for (int i = 0; i <= 10; i++) {
        const double rho = i / 10.0;
        given("rho = %g; all the light that a uniform sky sends is π", rho);
        suspect_factor("more comes back than arrives: a π is missing", PI);
        CHECK_REAL(lambert_brdf(rho) * PI, rho, roundings(4, "a quotient and a product"));
    }
}

// ---- disc_irradiance -----------------------------------------------------------------------

typedef enum {
    DISC_RIGHT,
    NO_R,
    NO_COS_HERE,
    NO_COS_THERE,
    NO_SQUARE,
    ONE_DISTANCE,
    FOUR_DISTANCES,
    N_NOT_UNIT,
    NO_HORIZON,
    HORIZON_ABS,
    ONE_SIDE,
    OTHER_SIDE,
    DISC_SLIPS
} disc_slip;

static const char *const disc_slip_names[DISC_SLIPS] = {
    [NO_R] = "dA = dr dφ: the r of dA = r dr dφ is missing",
    [NO_COS_HERE] = "the cosine at x is missing",
    [NO_COS_THERE] = "the cosine θ' at the disc is missing",
    [NO_SQUARE] = "the distance squared is missing",
    [ONE_DISTANCE] = "divided by the distance, not by its square",
    [FOUR_DISTANCES] = "v was not made a unit vector in both cosines, or once too often",
    [N_NOT_UNIT] = "the disc's normal was taken for a unit vector",
    [NO_HORIZON] = "points below the horizon of x were taken off",
    [HORIZON_ABS] = "points below the horizon of x were added",
    [ONE_SIDE] = "only one side of the disc shines",
    [OTHER_SIDE] = "only the other side of the disc shines",
};

static double disc_with_slip(disc_slip s, disc D, place at, int n_r, int n_phi) {
    const double d_r = (double)D.radius / n_r, d_phi = 2 * PI / n_phi;
    const wide3 to_centre = wide_sub(D.P.x, at.x), n = widen(at.n), m = widen(D.P.n);
    double sum = 0;
    for (int k = 0; k < n_r * n_phi; k++) {
        const double r = (k / n_phi + 0.5) * d_r, phi = (k % n_phi + 0.5) * d_phi;
        const wide3 v = wide_along(to_centre, r, perpendicular_at(D.P.n, phi));
        const double d = sqrt(wide_dot(v, v)), size = sqrt(wide_dot(m, m));
        double here = wide_dot(v, n) / d, there = wide_dot(v, m) / d / size;
        if (here < 0 && s == HORIZON_ABS) here = -here;
        if (here < 0 && s != NO_HORIZON) continue;
        if ((s == ONE_SIDE && there > 0) || (s == OTHER_SIDE && there < 0)) continue;
        if (s == NO_COS_HERE) here = 1;
        if (s == NO_COS_THERE) there = 1;
        if (s == N_NOT_UNIT) there *= size;
        const double power = s == NO_SQUARE ? 0 : s == ONE_DISTANCE ? 1 : 2;
        const double dA = (s == NO_R ? 1 : r) * d_r * d_phi;
        sum += here * fabs(there) / pow(d, s == FOUR_DISTANCES ? 4 : power) * dA;
    }
    return sum;
}

static void given_disc(disc D, place at, int n_r, int n_phi) {
    given("a disc: centre " VEC ", normal " VEC ", radius %g; " PLACE_TEXT
          "; n_r = %d, n_phi = %d",
          ARG(D.P.x), ARG(D.P.n), (double)D.radius, ARG_PLACE(at), n_r, n_phi);
}

static void judge_disc(disc D, place at, int n_r, int n_phi, double expected,
                       double tolerance) {
    for (int s = DISC_RIGHT + 1; s < DISC_SLIPS; s++)
        suspect_value(disc_slip_names[s], disc_with_slip((disc_slip)s, D, at, 32, 64));
    suspect_factor("dr dφ is missing", n_r * n_phi / (2 * PI * (double)D.radius));
    suspect_factor("the diameter for the radius, or φ round twice", 2);
    suspect_value("infinity: divided by 0. The square of a small length, and its fourth power "
                  "the more, is 0 in float",
                  INFINITY);
    CHECK_REAL(
        disc_irradiance(D, at.x, at.n, n_r, n_phi), expected,
        relative_to(tolerance, "the midpoint rule's own error, a step beside the distance"));
}

static void check_disc(disc D, place at, int n_r, int n_phi, double expected,
                       double tolerance) {
    given_disc(D, at, n_r, n_phi);
    judge_disc(D, at, n_r, n_phi, expected, tolerance);
}

// The midpoint rule with steps of s, over what changes within d: (s/d)²/24 times a
// second derivative of up to some 20; and as much for the step along the rings.
static double disc_tolerance(double r, double nearest, int n_r, int n_phi) {
    const double step = r / n_r / nearest, arc = 2 * PI * r / n_phi / nearest;
    return step * step + arc * arc / 4 + 1e-6;
}

// The closed form for a parallel disc of radius r whose axis passes x at the distance a.
static double parallel_disc(double r, double h, double a) {
    const double s = h * h + a * a + r * r;
    return PI / 2 * (1 - (h * h + a * a - r * r) / sqrt(s * s - 4 * r * r * a * a));
}

// Above x at the height h and a to the side; its normal is n turned by `tilt`, of any length.
static disc disc_over(place at, double h, double a, double phi, double r, double size) {
    const vec3 P = point_from(at, sqrt(a * a + h * h), atan2(a, h), phi);
    return (disc){{P, scale((real)size, at.n)}, (real)r};
}

static void disc_above(void) {
    rng g = check_rng(11);
    for (int i = 0; i < 12; i++) {
        const double r = between(&g, 0.3, 2), h = between(&g, 0.5, 3);
        const place at = some_place(&g);
        const disc D = disc_over(at, h, 0, 0, r, i % 2 ? 1 : -1);
        check_disc(D, at, 90, 70, PI * r * r / (r * r + h * h), disc_tolerance(r, h, 90, 70));
    }
}

static void disc_aside(void) {
    rng g = check_rng(12);
    for (int i = 0; i < 12; i++) {
        const double r = between(&g, 0.3, 1.2), h = between(&g, 0.6, 2), a = between(&g, 0, 2);
        const place at = some_place(&g);
        const disc D = disc_over(at, h, a, between(&g, 0, 6), r, i % 2 ? 1 : -1);
        check_disc(D, at, 100, 140, parallel_disc(r, h, a), disc_tolerance(r, h, 100, 140));
    }
}

// x looks past the disc: on the disc's axis, all above the horizon, E is the cosine's share.
static void disc_tilted(void) {
    rng g = check_rng(13);
    for (int i = 0; i < 12; i++) {
        const double h = between(&g, 0.8, 2), r = between(&g, 0.2, 0.6) * h;
        const double tilt = between(&g, 0.2, 0.9);
        const place at = some_place(&g);
        const vec3 axis = direction_at(at.n, tilt, between(&g, 0, 6));
        const disc D = {{narrow(wide_along(widen(at.x), h, widen(axis))),
                         scale((real)(i % 2 ? 1 : -1), axis)},
                        (real)r};
        check_disc(D, at, 60, 70, PI * r * r / (r * r + h * h) * cos(tilt),
                   disc_tolerance(r, h, 60, 70));
    }
}

static void disc_normal_length(void) {
    rng g = check_rng(14);
    const double sizes[] = {0.01, 0.7, 3, 250, 1e-20, 1e20, 1e-30, 1e30, 1e-40, 1e38};
    for (int i = 0; i < COUNT(sizes); i++) {
        const place at = some_place(&g);
        const disc D = disc_over(at, 1.3, 0.4, 2, 0.9, sizes[i]);
        check_disc(D, at, 60, 80, parallel_disc((double)D.radius, 1.3, 0.4),
                   disc_tolerance(0.9, 1.3, 60, 80));
    }
}

// Does the disc shine to both sides, by the answer under test, where all of it is above?
static bool both_sides_shine(disc D, place at) {
    const vec3 below = sub(at.x, scale(3, at.n));
    const disc back = {{D.P.x, neg(D.P.n)}, D.radius};
    return disc_irradiance(D, below, at.n, 8, 16) > 0 &&
           disc_irradiance(back, below, at.n, 8, 16) > 0;
}

// The disc stands upright, its centre a little above the horizon's plane or below it: a
// part of it shines. The reference sums over the hemisphere.
static void disc_cut(void) {
    rng g = check_rng(15);
    for (int i = 0; i < 4; i++) {
        const place at = some_place(&g);
        const double far = between(&g, 1.5, 2), below = i % 2 ? -0.05 : 0.05;
        const vec3 P = point_from(at, far, PI / 2 + below, between(&g, 0, 6));
        const vec3 tilted = add(normalize(sub(P, at.x)), scale((real)0.3, unit_vector(&g)));
        const disc D = {{P, tilted}, 1};
        const double E = with_slip(RIGHT, from_disc, &D, at, 300, 600);
        const double rim = rim_tolerance(from_disc, &D, at, 300, 600);
        given_disc(D, at, 80, 160);
        if (both_sides_shine(D, at))
            suspect_value("the whole disc was judged by its centre, which is below the horizon",
                          0);
        judge_disc(D, at, 80, 160, E, rim / E + 0.005);
    }
}

static void disc_below(void) {
    rng g = check_rng(16);
    for (int i = 0; i < 5; i++) {
        const place at = some_place(&g), turned = {at.x, neg(at.n)};
        const disc D = disc_over(turned, 1.5, 0.5, 1, 0.8, 1);
        given("a disc wholly below the horizon: centre " VEC "; " PLACE_TEXT, ARG(D.P.x),
              ARG_PLACE(at));
        suspect_value("its light was taken off, not left out",
                      -parallel_disc((double)D.radius, 1.5, 0.5));
        suspect_value("it shone through the ground", parallel_disc((double)D.radius, 1.5, 0.5));
        CHECK_REAL(
            disc_irradiance(D, at.x, at.n, 20, 200), 0,
            absolute_of(1e-3, "nothing arrives from below; a diagnosis needs some room"));
        CHECK_REAL(disc_irradiance(D, at.x, at.n, 20, 20), 0, exactly());
    }
}

static void disc_any_size(void) {
    rng g = check_rng(17);
    for (int k = -12; k <= 15; k += 3) {
        const double size = pow(10, k);
        const vec3 x = scale((real)size, unit_vector(&g)), n = unit_vector(&g);
        const disc D = disc_over((place){x, n}, 1.3 * size, 0.4 * size, 2, 0.9 * size, 1);
        check_disc(D, (place){x, n}, 60, 80, parallel_disc(0.9, 1.3, 0.4),
                   disc_tolerance(0.9, 1.3, 60, 80));
    }
}

// At 1e6 floats lie 1/16 apart: the disc lies where its centre was rounded to.
static void disc_far_out(void) {
    rng g = check_rng(38);
    for (int i = 0; i < 12; i++) {
        const place at = {scale((real)1e6, unit_vector(&g)), unit_vector(&g)};
        const double r = between(&g, 0.1, 0.25);
        const disc D = disc_over(at, between(&g, 0.3, 1), 0.3, 2, r, 1);
        const wide3 v = wide_sub(D.P.x, at.x);
        const double h = wide_dot(v, widen(at.n));
        const double a = sqrt(fmax(0, wide_dot(v, v) - h * h));
        check_disc(D, at, 60, 80, parallel_disc((double)D.radius, h, a),
                   disc_tolerance(r, h, 60, 80));
    }
}

// The closed form's error falls as n^-2.
static void disc_rate(void) {
    rng g = check_rng(18);
    const place at = some_place(&g);
    const disc D = disc_over(at, 1, 0.3, 2, 0.8, 1);
    const double E = parallel_disc((double)D.radius, 1, 0.3);
    for (int n = 8; n <= 32; n *= 2) {
        given("a disc of radius 0.8 at the height 1; n_r = %d", n);
        const double once = disc_irradiance(D, at.x, at.n, n, 4 * n) - E;
        const double twice = disc_irradiance(D, at.x, at.n, 2 * n, 8 * n) - E;
        given("a disc of radius 0.8 at the height 1; the error with n_r = %d is %.3g", n, once);
        DEMAND_AT_MOST("disc_irradiance, twice as many points each way: its error", fabs(twice),
                       fabs(once) / 3.5 + 2e-7,
                       "twice as many points each way: an error of n^-2 falls to a quarter");
    }
}

// Two discs of radius 1, face to face at the distance 1: the mean of E / π over one of
// them, (3 - √5) / 2.
static void coaxial_discs(void) {
    rng g = check_rng(19);
    const place at = some_place(&g);
    const disc D = disc_over(at, 1, 0, 0, 1, 1);
    double s[12], weight[12], factor = 0;
    quadrature_rule(GAUSS, 12, s, weight);
    given("two discs of radius 1 at the distance 1: the mean of disc_irradiance / π over one");
    for (int i = 0; i < 12; i++) { // a uniform share s of the disc's area lies within √s
        const vec3 x = point_from(at, sqrt(s[i]), PI / 2, 0.7);
        factor += weight[i] * disc_irradiance(D, x, at.n, 120, 160) / PI;
    }
    CHECK_REAL(factor, 0.381966011250,
               relative_to(disc_tolerance(1, 1, 120, 160), "the midpoint rule's own error"));
}

// ---- directional_albedo --------------------------------------------------------------------

// f as an L_i, for a given w_o.
typedef struct {
    brdf f;
    const void *paint;
    vec3 n, w_o;
} fixed_w_o;

static double towards_w_o(const void *world, vec3 x, vec3 w_i) {
    const fixed_w_o *f = world;
    (void)x;
    return f->f(f->paint, f->n, w_i, f->w_o);
}

// c (w_i·n)(w_o·n): reciprocal, and of albedo (2π/3) c (w_o·n).
static double cosines(const void *paint, vec3 n, vec3 w_i, vec3 w_o) {
    return *(const double *)paint * dot(w_i, n) * dot(w_o, n);
}

static double constant(const void *paint, vec3 n, vec3 w_i, vec3 w_o) {
    (void)n, (void)w_i, (void)w_o;
    return *(const double *)paint;
}

// The modified Phong lobe, the judge's own.
static double phong(const void *paint, vec3 n, vec3 w_i, vec3 w_o) {
    const double k = *(const double *)paint;
    const double along = 2 * (double)dot(w_i, n) * dot(w_o, n) - dot(w_i, w_o);
    return along > 0 ? (k + 2) / (2 * PI) * pow(along, k) : 0;
}

static void check_albedo(const char *what, brdf f, const void *paint, vec3 n, vec3 w_o,
                         int n_theta, int n_phi, double expected, double tolerance) {
    const place at = {{0, 0, 0}, n};
    const fixed_w_o as_light = {f, paint, n, w_o};
    const double cosine = dot(n, w_o);
    given("f = %s; n = " VEC ", w_o = " VEC " at w_o·n = %.6g; n_theta = %d, n_phi = %d", what,
          ARG(n), ARG(w_o), cosine, n_theta, n_phi);
    if (cosine < 0.9) // straight on it is as if there were none
        suspect_value("the cosine of w_o, not of w_i",
                      cosine * with_slip(NO_COSINE, towards_w_o, &as_light, at, 60, 90));
    suspect_slips(towards_w_o, &as_light, at, n_theta, n_phi);
    CHECK_REAL(directional_albedo(f, paint, n, w_o, n_theta, n_phi), expected,
               absolute_of(tolerance, "the midpoint rule's own error"));
}

static void albedo_of_lambert(void) {
    rng g = check_rng(20);
    for (int i = 0; i < 8; i++) {
        const double tilt = i == 0 ? 1.3 : between(&g, 0, 1.5); // first a tilted one
        const vec3 n = unit_vector(&g), w_o = direction_at(n, tilt, 1);
        const double rho = between(&g, 0.1, 1), f = rho / PI;
        check_albedo("rho / π", constant, &f, n, w_o, 40, 30, rho, f * smooth_tolerance(40));
    }
}

static void albedo_of_cosines(void) {
    rng g = check_rng(21);
    const double c = 0.4;
    for (int i = 0; i < 12; i++) {
        const double tilt = i == 0 ? 1.3 : between(&g, 0, 1.5);
        const vec3 n = unit_vector(&g), w_o = direction_at(n, tilt, 2);
        const double cosine = dot(n, w_o);
        check_albedo("0.4 (w_i·n)(w_o·n)", cosines, &c, n, w_o, 50, 35, c * cosine * 2 * PI / 3,
                     c * smooth_tolerance(50));
    }
}

// Straight on, the modified Phong lobe reflects everything; near the horizon
// (k + 2)/π ∫ sin²α cos^k α dα: 1/π for k = 1, 1/4 for k = 2, 3/16 for k = 4.
static void albedo_of_phong(void) {
    const double powers[] = {1, 2, 4}, grazing[] = {1 / PI, 0.25, 3.0 / 16};
    rng g = check_rng(22);
    for (int i = 0; i < COUNT(powers); i++) {
        const vec3 n = unit_vector(&g), along = direction_at(n, PI / 2 - 1e-5, 3);
        check_albedo("a modified Phong lobe", phong, &powers[i], n, along, 120, 160, grazing[i],
                     0.003);
        check_albedo("a modified Phong lobe", phong, &powers[i], n, n, 120, 160, 1, 0.003);
    }
}

typedef struct {
    asked w_i;
    vec3 w_o;
    int swapped, wrong_o, wrong_n;
} f_asked;

static double f_takes_notes(const void *paint, vec3 n, vec3 w_i, vec3 w_o) {
    f_asked *a = *(f_asked *const *)paint;
    a->w_i.count++;
    a->wrong_n += !same_vec3(n, a->w_i.at.n);
    a->wrong_o += !same_vec3(w_o, a->w_o);
    a->swapped += same_vec3(w_i, a->w_o);
    note_direction(&a->w_i, w_i);
    return 1 / PI;
}

static void albedo_asks_as_promised(void) {
    rng g = check_rng(23);
    const vec3 n = unit_vector(&g);
    f_asked notes = {.w_i.at.n = n, .w_o = direction_at(n, 1, 2)};
    f_asked *paint = &notes;
    given("n = " VEC ", w_o = " VEC "; n_theta = %d, n_phi = %d; how often f is asked", ARG(n),
          ARG(notes.w_o), ASKED_THETA, ASKED_PHI);
    directional_albedo(f_takes_notes, &paint, n, notes.w_o, ASKED_THETA, ASKED_PHI);
    const int count = notes.w_i.count;
    check_int(__FILE__, __LINE__, "f, how often", count, ASKED);
    DEMAND(notes.wrong_n == 0, "f is asked with the normal n", "%d of %d times with another",
           notes.wrong_n, count);
    DEMAND(notes.swapped < count, "w_o is f's last argument: first w_i, then w_o",
           "w_i and w_o are swapped");
    DEMAND(notes.wrong_o == 0, "f is asked with w_o", "%d of %d times with another",
           notes.wrong_o, count);
    demand_good_directions(&notes.w_i);
    demand_middles(&notes.w_i);
}

// ---- own_brdf: a judge for any BRDF -------------------------------------------------------

#define WRONG_WAY                                                                        \
    "is the mirrored direction turned the wrong way? reflect(d, n) wants d towards the " \
    "surface"

static const double shines[] = {0, 1, 7.5, 40, 200};

// A direction above n; every third one grazes: cosines from 1e-6.
static vec3 some_above(vec3 n, int i, rng *g) {
    const double cosine = i % 3 ? between(g, 0.001, 1) : pow(10, between(g, -6, -1));
    return direction_at(n, acos(cosine), between(g, 0, 2 * PI));
}

// Any w_o, or one near the mirror image of w_i, where the lobe is.
static vec3 some_out(vec3 n, vec3 w_i, int i, rng *g) {
    if (i % 2) return some_above(n, i / 2, g);
    const real fuzz = (real)between(g, 0, 0.3);
    const vec3 near = normalize(add(neg(reflect(w_i, n)), scale(fuzz, unit_vector(g))));
    return dot(near, n) > (real)1e-6 ? near : some_above(n, i / 2, g);
}

// Numbers first: a long line is cut off at its end.
static void given_pair(double rho, double shine, vec3 n, vec3 w_i, vec3 w_o) {
#define SHORT "(%.6g, %.6g, %.6g)"
    given("rho = %.3g, shine = %g; w_i·n = %.3g, w_o·n = %.3g; n = " SHORT ", w_i = " SHORT
          ", w_o = " SHORT,
          rho, shine, (double)dot(w_i, n), (double)dot(w_o, n), ARG(n), ARG(w_i), ARG(w_o));
}

// Dot products of unit vectors are rounded: 1 and a little is no cosine.
static const char *why_not_a_number(vec3 n, vec3 w_i, vec3 w_o) {
    const double along = dot(neg(reflect(w_i, n)), w_o);
    if (fabs(along) > 1 - 1e-6)
        return "NaN: acos of a little more than 1, or less than -1? The dot product of two "
               "unit vectors may be just beyond, by its rounding";
    return "NaN: a power or root of a negative number, acos of more than 1, or 0/0? If of "
           "r·w_o: " WRONG_WAY;
}

static void own_finite(void) {
    rng g = check_rng(24);
    for (int i = 0; i < 20000; i++) {
        const vec3 n = unit_vector(&g), w_i = some_above(n, i, &g);
        const vec3 w_o = i % 7 ? some_out(n, w_i, i, &g) : w_i;
        const double shine = shines[i % COUNT(shines)], rho = i % 4 ? between(&g, 0, 1) : 1;
        given_pair(rho, shine, n, w_i, w_o);
        const double f = own_brdf(rho, shine, n, w_i, w_o);
        DEMAND(!isnan(f), "a number", "%s", why_not_a_number(n, w_i, w_o));
        DEMAND(!isinf(f), "a BRDF is finite, here", "f is infinite: what divides by 0?");
        DEMAND(f >= 0, "a BRDF is never negative: light cannot be taken off",
               "f = %.4g. A cosine below 0 has no lobe; and if it is r·w_o: " WRONG_WAY, f);
    }
}

// A high power makes much of a dot product's rounding: what does f do when n or w_o is not
// quite a unit vector, by four roundings?
static double change_by_rounding(double shine, vec3 n, vec3 w_i, vec3 w_o) {
    const double f = own_brdf(0.8, shine, n, w_i, w_o);
    double change = 0;
    for (int sign = -1; sign <= 1; sign += 2) {
        const real size = 1 + (real)(4 * sign) * REAL_EPSILON;
        const double by_n = own_brdf(0.8, shine, scale(size, n), w_i, w_o);
        const double by_w_o = own_brdf(0.8, shine, n, w_i, scale(size, w_o));
        change = fmax(change, fmax(fabs(by_n - f), fabs(by_w_o - f)));
    }
    return isfinite(change) ? change : 0;
}

static void own_reciprocal(void) {
    rng g = check_rng(25);
    for (int i = 0; i < 20000; i++) {
        const vec3 n = unit_vector(&g), w_i = some_above(n, i, &g);
        const vec3 w_o = some_out(n, w_i, i, &g);
        const double shine = shines[i % COUNT(shines)], ci = dot(w_i, n), co = dot(w_o, n);
        given_pair(0.8, shine, n, w_i, w_o);
        suspect_factor("divided by the cosine of w_i, not of both or neither", co / ci);
        suspect_factor("multiplied by the cosine of w_i, or divided by that of w_o, alone",
                       ci / co);
        const double f = own_brdf(0.8, shine, n, w_i, w_o),
                     swapped = own_brdf(0.8, shine, n, w_o, w_i);
        if (fabs(f - swapped) <= 1e-6 + 2e-3 * fabs(swapped)) continue;
        const double rounding = change_by_rounding(shine, n, w_i, w_o);
        check_real(__FILE__, __LINE__, "own_brdf; expected: the same with w_i and w_o swapped",
                   f, swapped,
                   (allowance){1e-6 + rounding, 2e-3, "dot products in float, to a power"});
    }
}

// The share of the light from w_o that comes back, by the judge's own sum. A narrow lobe
// falls between FEW directions, and then is asked for MORE; when the sum of these changes
// with MOST, the lobe falls between them too.
enum { FEW = 160, MORE = 1280, MOST = 2560 };

static double own_albedo(double rho, double shine, vec3 n, vec3 w_o, int rings) {
    const int sectors = rings / 2 * 3;
    const double d_theta = PI / 2 / rings, d_phi = 2 * PI / sectors;
    double albedo = 0;
    for (int k = 0; k < rings * sectors; k++) {
        const double theta = (k / sectors + 0.5) * d_theta;
        const vec3 w_i = direction_at(n, theta, (k % sectors + 0.5) * d_phi);
        albedo += own_brdf(rho, shine, n, w_i, w_o) * cos(theta) * sin(theta) * d_theta * d_phi;
    }
    return albedo;
}

static void demand_a_number(double albedo) {
    DEMAND(!isnan(albedo), "a share of the light",
           "NaN: a power or root of a negative number, or 0/0?");
}

static void demand_width(bool too_narrow, double more, double most) {
    DEMAND(
        !too_narrow, "the lobe is wider than the judge's directions, about 0.005 radians",
        "by 1280 x 1920 directions the share %.3g of the light comes back, by 2560 x 3840 it "
        "is %.3g: this lobe falls between them; make it wider",
        more, most);
}

// By FEW directions more than rho came back.
static void conserves_by_more(double rho, double shine, vec3 n, vec3 w_o) {
    const double more = own_albedo(rho, shine, n, w_o, MORE);
    if (more <= rho * 1.01) return;
    const double most = own_albedo(rho, shine, n, w_o, MOST);
    demand_width(most < 0.98 * more, more, most);
    DEMAND_AT_MOST(
        "own_brdf, the share of the light that comes back, by 1280 x 1920 directions", more,
        rho * 1.01, "no more light leaves than rho of what arrives; 1 % is for the sum");
}

static void own_conserves(void) {
    const double cosines_o[] = {1, 0.9, 0.7, 0.5, 0.2, 0.05, 1e-3, 1e-6}, rhos[] = {0, 0.35, 1};
    rng g = check_rng(26);
    for (int i = 0; i < COUNT(cosines_o) * COUNT(rhos) * COUNT(shines); i++) {
        const double rho = rhos[i % 3], shine = shines[i / 3 % COUNT(shines)];
        const double cosine = cosines_o[i / 3 / COUNT(shines)];
        const vec3 n = unit_vector(&g);
        const vec3 w_o = direction_at(n, acos(cosine), between(&g, 0, 6));
        given("rho = %g, shine = %g, light from w_o at w_o·n = %g (%s)", rho, shine, cosine,
              cosine < 0.1 ? "grazing" : "steep");
        const double albedo = own_albedo(rho, shine, n, w_o, FEW);
        demand_a_number(albedo);
        if (albedo > rho * 1.01) conserves_by_more(rho, shine, n, w_o);
    }
}

static const char *why_so_little(double albedo, double before, double shine, vec3 n) {
    if (albedo == 0 && shine == 0 && own_albedo(0.8, 4, n, n, FEW) > 0)
        return "for shine = 4 something does: is the factor before the lobe 0 for shine = 0?";
    if (albedo == 0 && before > 0 && shine > 1)
        return "for a smaller shine something does: is the lobe narrower than the judge's "
               "directions, 0.005 radians, or its factor 0?";
    if (albedo == 0) return WRONG_WAY;
    if (albedo < before)
        return "a narrow lobe must be higher: does the factor grow with shine?";
    return "is the factor before the lobe large enough?";
}

// Straight on.
static double own_albedo_of_any_width(double shine, vec3 n) {
    const double few = own_albedo(0.8, shine, n, n, FEW);
    if (!(few < 0.08)) return few;
    const double more = own_albedo(0.8, shine, n, n, MORE);
    if (!(more < 0.08)) return more;
    const double most = own_albedo(0.8, shine, n, n, MOST);
    demand_width(most > 1.1 * more, more, most);
    return more;
}

static void own_reflects(void) {
    rng g = check_rng(27);
    double before = 0;
    for (int i = 0; i < COUNT(shines); i++) {
        const vec3 n = unit_vector(&g);
        given("rho = 0.8, shine = %g, light straight on", shines[i]);
        const double albedo = own_albedo_of_any_width(shines[i], n);
        demand_a_number(albedo);
        DEMAND(albedo >= 0.08,
               "at least the share rho / 10 = 0.08 comes back: or nothing is to be seen",
               "%.3g comes back; %s", albedo, why_so_little(albedo, before, shines[i], n));
        before = albedo;
    }
}

static void own_has_a_lobe(void) {
    rng g = check_rng(28);
    double least = INFINITY, most = 0;
    given("rho = 0.8, shine = 40, 2000 pairs of directions");
    for (int i = 0; i < 2000; i++) {
        const vec3 n = unit_vector(&g), w_i = some_above(n, 1, &g);
        const double f = own_brdf(0.8, 40, n, w_i, some_out(n, w_i, i, &g));
        least = fmin(least, f), most = fmax(most, f);
    }
    DEMAND(most > 1.05 * least, "f depends on the directions: it has a lobe, unlike Lambert's",
           "f lies between %.4g and %.4g", least, most);
}

static void own_uses_shine(void) {
    rng g = check_rng(37);
    double change = 0;
    given("rho = 0.8, 2000 pairs of directions, each with shine = 1 and shine = 40");
    for (int i = 0; i < 2000; i++) {
        const vec3 n = unit_vector(&g), w_i = some_above(n, 1, &g);
        const vec3 w_o = some_out(n, w_i, i, &g);
        const double dull = own_brdf(0.8, 1, n, w_i, w_o),
                     sharp = own_brdf(0.8, 40, n, w_i, w_o);
        change = fmax(change, fabs(sharp - dull) / fmax(fmax(sharp, dull), 1e-30));
    }
    DEMAND(change > 0.01, "shine changes the lobe", "f changes by %.2g %% at most",
           100 * change);
}

// The same turn for all: by a frame about `to` in place of one about `from`.
static vec3 turned(vec3 v, vec3 from, vec3 to) {
    const wide3 a = perpendicular_at(from, 0), b = perpendicular_at(from, PI / 2);
    const wide3 p = perpendicular_at(to, 0.7), q = perpendicular_at(to, 0.7 + PI / 2);
    const wide3 w = widen(v);
    wide3 sum = wide_along((wide3){0, 0, 0}, wide_dot(w, a), p);
    sum = wide_along(sum, wide_dot(w, b), q);
    return narrow(wide_along(sum, wide_dot(w, widen(from)), widen(to)));
}

static void own_turned(void) {
    rng g = check_rng(29);
    for (int i = 0; i < 2000; i++) {
        const vec3 n = unit_vector(&g), m = unit_vector(&g);
        const vec3 w_i = aslant(n, 0, 1.4, &g);
        const vec3 w_o = aslant(n, 0, 1.4, &g);
        const double shine = i % 2 ? 7.5 : 1;
        given_pair(0.8, shine, n, w_i, w_o);
        check_real(__FILE__, __LINE__,
                   "own_brdf with all three turned together; expected: as before",
                   own_brdf(0.8, shine, m, turned(w_i, n, m), turned(w_o, n, m)),
                   own_brdf(0.8, shine, n, w_i, w_o),
                   (allowance){1e-4, 2e-3, "vectors in float, turned and rounded"});
    }
}

// ---- the module: quadrature ----------------------------------------------------------------

static double power_of_first(const void *degree, const double *x) {
    return pow(x[0], *(const int *)degree);
}

static void rule_degrees(void) {
    const struct {
        const char *name;
        quadrature rule;
        int n, degree;
    } rules[] = {
        {"midpoint", MIDPOINT, 1, 1}, {"midpoint", MIDPOINT, 10, 1}, {"Simpson", SIMPSON, 3, 3},
        {"Simpson", SIMPSON, 11, 3},  {"Gauss", GAUSS, 1, 1},        {"Gauss", GAUSS, 2, 3},
        {"Gauss", GAUSS, 5, 9},       {"Gauss", GAUSS, 16, 31},      {"Gauss", GAUSS, 40, 79}};
    for (int i = 0; i < COUNT(rules); i++)
        for (int degree = 0; degree <= rules[i].degree; degree++) {
            given("%s with n = %d, ∫ x^%d over [0, 1]", rules[i].name, rules[i].n, degree);
            CHECK_REAL(integrate_cube(rules[i].rule, rules[i].n, 1, power_of_first, &degree),
                       1.0 / (degree + 1),
                       relative_to(1e-13, "exact, but for rounding in double"));
        }
}

static void rule_points(void) {
    for (int rule = MIDPOINT; rule <= GAUSS; rule++)
        for (int n = 3; n <= 301; n += 2) {
            double x[301], weight[301], sum = 0;
            quadrature_rule((quadrature)rule, n, x, weight);
            given("rule %d with n = %d", rule, n);
            for (int i = 0; i < n; i++) {
                sum += weight[i];
                CHECK(x[i] >= 0 && x[i] <= 1 && weight[i] > 0,
                      "points inside, weights positive");
                CHECK(i == 0 || x[i] > x[i - 1], "ascending");
                CHECK_REAL(x[i] + x[n - 1 - i], 1,
                           absolute_of(1e-15, "the same from both ends"));
            }
            CHECK_REAL(sum, 1, absolute_of(1e-12, "∫ 1"));
        }
}

// ∏ π/2 sin π x: 1 in any dimension.
typedef struct {
    int dimensions;
} cube;

static double sines(const void *data, const double *x) {
    double product = 1;
    for (int k = 0; k < ((const cube *)data)->dimensions; k++)
        product *= PI / 2 * sin(PI * x[k]);
    return product;
}

// One factor of the midpoint rule is known: h / sin h with h = π / 2n, to the power d.
static void cube_products(void) {
    for (int d = 1; d <= MOST_DIMENSIONS; d++) {
        const cube c = {d};
        const int n = 4;
        const double h = PI / 2 / n;
        given("∫ ∏ π/2 sin πx in %d dimensions, 4 points an axis", d);
        CHECK_REAL(integrate_cube(MIDPOINT, n, d, sines, &c), pow(h / sin(h), d),
                   relative_to(1e-12, "the sum is known in closed form"));
        CHECK_REAL(integrate_cube(GAUSS, 5, d, sines, &c), 1,
                   relative_to(1e-6, "Gauss with five points of a sine"));
    }
}

// ---- the module: lights ---------------------------------------------------------------------

static void directions(void) {
    rng g = check_rng(30);
    for (int i = 0; i < 2000; i++) {
        const vec3 n = unit_vector(&g), axis[] = {{0, 0, 1}, {0, -1, 0}, {1, 0, 0}};
        const vec3 up = i % 10 ? n : axis[i / 10 % 3];
        const double theta = between(&g, 0, PI / 2), phi = between(&g, 0, 2 * PI);
        const vec3 long_up = scale((real)pow(10, i % 7 - 3), up);
        given("n = " VEC ", θ = %.6g, φ = %.6g", ARG(long_up), theta, phi);
        const vec3 w = direction_at(long_up, theta, phi);
        CHECK_REAL(sqrt(wide_dot(widen(w), widen(w))), 1, roundings(4, "a unit vector"));
        CHECK_REAL(dot(w, up), cos(theta), absolute_of(8 * REAL_EPSILON, "rounded components"));
        const wide3 a = perpendicular_at(long_up, phi),
                    b = perpendicular_at(long_up, phi + 0.3);
        CHECK_REAL(wide_dot(a, widen(long_up)), 0,
                   absolute_of(1e-15 * pow(10, i % 7 - 3), "perpendicular, in double"));
        CHECK_REAL(wide_dot(a, b), cos(0.3), absolute_of(1e-14, "turned by 0.3"));
        CHECK_REAL(wide_dot(wide_cross(a, b), widen(up)), sin(0.3),
                   absolute_of(8 * REAL_EPSILON, "about n, against the clock"));
    }
}

static void known_spheres(void) {
    const struct {
        double x, h, E;
    } rows[] = {{0, 1.5, 1.396263401595},
                {0, 2, 0.785398163397},
                {2, 0.5, 0.196801876179},
                {2, 0, 0.090586073706}};
    for (int i = 0; i < COUNT(rows); i++) {
        const sphere S = {{(real)rows[i].x, 0, (real)rows[i].h}, 1};
        given("a sphere of radius 1 at (%g, 0, %g)", rows[i].x, rows[i].h);
        CHECK_REAL(sphere_irradiance(S, (vec3){0, 0, 0}, (vec3){0, 0, 1}), rows[i].E,
                   absolute_of(1e-12, "as many digits as are known"));
    }
    const sphere below = {{0, 2, -3}, 1};
    CHECK_REAL(sphere_irradiance(below, (vec3){0, 0, 0}, (vec3){0, 0, 1}), 0, exactly());
}

// Against the sum over the hemisphere, from wholly above to wholly below.
static void cut_spheres(void) {
    rng g = check_rng(31);
    for (int i = 0; i < 20; i++) {
        const place at = some_place(&g);
        const double d = between(&g, 1.1, 3), angle = between(&g, 0.5, 2.6);
        const sphere S = {point_from(at, d, angle, between(&g, 0, 6)), 1};
        const double sum = with_slip(RIGHT, from_sphere, &S, at, 160, 300);
        given("a sphere of radius 1 at the distance %g, %g from the zenith", d, angle);
        CHECK_REAL(
            sphere_irradiance(S, at.x, at.n), sum,
            absolute_of(rim_tolerance(from_sphere, &S, at, 160, 300) + smooth_tolerance(160),
                        "the sum's own error, along the rim"));
    }
}

// A lamp in all directions: Φ = 4π r² times π; E = Φ cos θ / 4π d².
static void sphere_like_a_point(void) {
    rng g = check_rng(32);
    for (int k = 0; k <= 9; k++) {
        const place at = some_place(&g);
        const double d = 2.5 * pow(10, k), theta = between(&g, 0, 1.1);
        const sphere S = {point_from(at, d, theta, 1), 1};
        const wide3 v = wide_sub(S.c, at.x);
        const double far = sqrt(wide_dot(v, v)), flux = 4 * PI * PI;
        given("a sphere of radius 1 at the distance %g: as a point of the same flux", far);
        CHECK_REAL(sphere_irradiance(S, at.x, at.n),
                   flux * wide_dot(v, widen(at.n)) / (4 * PI * far * far * far),
                   relative_to(1e-12, "the same in exact arithmetic"));
    }
}

static void known_rectangles(void) {
    const vec3 x = {0, 0, 0}, n = {0, 0, 1};
    const struct {
        const char *what;
        rectangle R;
        double factor;
    } rows[] = {
        {"above, x under a corner", {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}}, 0.138531605995},
        {"above, x under the centre",
         {{(real)-0.5, (real)-0.5, 1}, {0, 1, 0}, {1, 0, 0}},
         0.239456470461},
        {"upright, its foot at the height of x",
         {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
         0.055734197003},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        given("a unit square %s, at the distance 1", rows[i].what);
        CHECK_REAL(rectangle_irradiance(rows[i].R, x, n) / PI, rows[i].factor,
                   absolute_of(1e-12, "as many digits as are known"));
        CHECK_REAL(rectangle_irradiance_by_area(GAUSS, 24, rows[i].R, x, n) / PI,
                   rows[i].factor, absolute_of(1e-10, "Gauss with 24 x 24 points"));
        const rectangle back = {rows[i].R.corner, rows[i].R.side2, rows[i].R.side1};
        CHECK_REAL(rectangle_irradiance(back, x, n), 0, exactly());
        CHECK_REAL(rectangle_irradiance_by_area(GAUSS, 4, back, x, n), 0, exactly());
    }
}

// Cut in two, E is the sum; and the two forms agree, far away too.
static void rectangles_anywhere(void) {
    rng g = check_rng(33);
    for (int i = 0; i < 200; i++) {
        const place at = some_place(&g);
        const rectangle R = rectangle_facing(at, &g);
        const double E = rectangle_irradiance(R, at.x, at.n);
        const vec3 half = scale((real)0.5, R.side1);
        const rectangle left = {R.corner, half, R.side2},
                        right = {add(R.corner, half), half, R.side2};
        given("a rectangle, corner " VEC ", sides " VEC ", " VEC "; " PLACE_TEXT, ARG(R.corner),
              ARG(R.side1), ARG(R.side2), ARG_PLACE(at));
        CHECK_REAL(rectangle_irradiance_by_area(GAUSS, 20, R, at.x, at.n), E,
                   relative_to(1e-7, "Gauss with 20 x 20 points"));
        CHECK_REAL(rectangle_irradiance(left, at.x, at.n) +
                       rectangle_irradiance(right, at.x, at.n),
                   E, relative_to(8 * REAL_EPSILON, "the middle of a side, rounded"));
    }
}

static void far_rectangles(void) {
    rng g = check_rng(34);
    for (int k = 0; k <= 6; k++) {
        const vec3 n = unit_vector(&g), x = {0, 0, 0};
        rectangle R = rectangle_facing((place){x, n}, &g);
        R.side1 = scale((real)pow(10, -k), R.side1),
        R.side2 = scale((real)pow(10, -k), R.side2);
        given("a rectangle of size 1e-%d at the distance 1 to 2", k);
        CHECK_REAL(
            rectangle_irradiance(R, x, n), rectangle_irradiance_by_area(GAUSS, 20, R, x, n),
            relative_to(1e-7 + 1e-15 * pow(10, k),
                        "the four edges nearly cancel: a rounding times distance / size"));
    }
}

static void known_form_factors(void) {
    const rectangle a = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                    over = {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}},
                    beside = {{0, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    given("two unit squares face to face at the distance 1");
    CHECK_REAL(form_factor(GAUSS, 12, a, over), 0.199824895698,
               absolute_of(1e-9, "Gauss, 12^4"));
    CHECK_REAL(form_factor_lambert(GAUSS, 12, a, over), 0.199824895698,
               absolute_of(2e-8, "Gauss, 12^2; points in real"));
    given("two unit squares with a common edge at a right angle");
    CHECK_REAL(form_factor_lambert(GAUSS, 12, a, beside), 0.200043776075,
               absolute_of(2e-7, "Gauss, 12^2; a corner in the integrand"));
    CHECK_REAL(form_factor(MIDPOINT, 16, a, beside), 0.200043776075,
               absolute_of(0.05, "the integrand grows without bound at the common edge"));
    given("the closed cube: one square opposite, four beside");
    CHECK_REAL(form_factor_lambert(GAUSS, 12, a, over) +
                   4 * form_factor_lambert(GAUSS, 12, a, beside),
               1, absolute_of(1e-6, "all the light arrives somewhere"));
}

// A_a F_ab = A_b F_ba.
static void form_factor_reciprocity(void) {
    rng g = check_rng(35);
    for (int i = 0; i < 5; i++) {
        const place at = some_place(&g);
        const rectangle b = rectangle_facing(at, &g);
        const vec3 s1 = scale((real)0.2, narrow(perpendicular_at(at.n, 0))),
                   s2 = scale(2, cross(at.n, s1));
        const rectangle a = {at.x, s1, s2};
        const double area_a = (double)length(cross(a.side1, a.side2)),
                     area_b = (double)length(cross(b.side1, b.side2));
        given("two rectangles of area %g and %g", area_a, area_b);
        CHECK_REAL(
            area_a * form_factor(GAUSS, 8, a, b), area_b * form_factor(GAUSS, 8, b, a),
            relative_to(16 * REAL_EPSILON + 1e-13, "the same double sum, areas in real"));
    }
}

static void equation(void) {
    rng g = check_rng(36);
    for (int i = 0; i < 10; i++) {
        const place at = some_place(&g);
        const double rho = between(&g, 0.1, 1), L_e = between(&g, 0, 2);
        const lit_point point = {at.x, at.n, L_e, brdf_lambert, &rho, from_uniform_sky, NULL};
        given("a matte point of albedo %g that shines with %g, under a sky of 1", rho, L_e);
        CHECK_REAL(outgoing_radiance(&point, direction_at(at.n, 1, 1), 60, 60), L_e + rho,
                   absolute_of(smooth_tolerance(60), "the midpoint rule's own error"));
    }
}

int main(void) {
    static const char *const sky = "Which directions does the hemisphere have, how much solid "
                                   "angle does each stand for, and which factor of the "
                                   "equation stands beside L_i?";
    static const char *const rim =
        "Cosine, sine, and the hemisphere about n: see direction_at.";
    static const char *const lambert =
        "What must f_r be so that the integral of f_r (w·n) over "
        "the hemisphere is rho?";
    static const char *const disc_hint =
        "A cosine at x, one at the light, the distance squared, "
        "and the area of a piece of a ring.";
    static const char *const albedo = "The same sum as for irradiance, with f in place of L_i.";
    static const char *const lobe = "What would break if w_i and w_o were swapped, or w_o came "
                                    "near the horizon?";
    static const char *const given_code = "Given code: did it change?";
    static const test tests[] = {
        {"lambert_brdf: a value", lambert_value, lambert},
        {"lambert_brdf: a uniform sky gives back rho", lambert_reflects_rho, lambert},
        {"irradiance: a uniform sky gives π", uniform_sky, sky},
        {"irradiance: a smooth sky", smooth_sky, sky},
        {"irradiance: half a sky, tilted", half_sky, rim},
        {"irradiance: a sphere straight above", sphere_above, rim},
        {"irradiance: a sphere that the horizon cuts", sphere_half_below,
         "Only directions with w·n > 0 count; θ ends at π/2."},
        {"irradiance: spheres anywhere", spheres_anywhere, rim},
        {"irradiance: discs and rectangles", discs_and_rectangles, rim},
        {"irradiance: asks L_i as promised", asks_as_promised,
         "n_theta times n_phi unit directions about n, each in the middle of its cell; x and "
         "world are handed on."},
        {"irradiance: the error falls as n^-2", promised_rate,
         "Is each direction in the middle of its cell, and does its weight belong to it?"},
        {"irradiance: the same at any size", any_size, "Directions have no size."},
        {"disc_irradiance: straight above", disc_above, disc_hint},
        {"disc_irradiance: to the side", disc_aside, disc_hint},
        {"disc_irradiance: x turned away", disc_tilted, disc_hint},
        {"disc_irradiance: a normal of any length", disc_normal_length,
         "D.P.n may have any length but 0: what is a cosine made of? And the square of 1e-30, "
         "or of 1e30, is no float: widen first."},
        {"disc_irradiance: wholly below the horizon", disc_below,
         "What is the sign of the cosine at x there?"},
        {"disc_irradiance: half below the horizon", disc_cut,
         "Judge every point of the disc by itself."},
        {"disc_irradiance: any size", disc_any_size,
         "Double inside: what does the fourth power of 1e15, or of 1e-12, become in float?"},
        {"disc_irradiance: far from the origin", disc_far_out,
         "At 1e6 floats lie 1/16 apart. A point of the disc has no place there in float: begin "
         "with D.P.x - x, and stay in double."},
        {"disc_irradiance: the error falls as n^-2", disc_rate,
         "The middle of each ring and of each piece of it."},
        {"disc_irradiance: two coaxial discs", coaxial_discs, disc_hint},
        {"directional_albedo: Lambert's", albedo_of_lambert, albedo},
        {"directional_albedo: a product of cosines", albedo_of_cosines, albedo},
        {"directional_albedo: Phong's lobe, straight on and grazing", albedo_of_phong, albedo},
        {"directional_albedo: asks f as promised", albedo_asks_as_promised,
         "n_theta times n_phi unit directions w_i about n, each in the middle of its cell; "
         "paint, n and w_o are handed on."},
        {"own_brdf: finite and not negative", own_finite, lobe},
        {"own_brdf: reciprocal", own_reciprocal,
         "f(w_i, w_o) = f(w_o, w_i): does a cosine, or a clamp, treat one of them alone?"},
        {"own_brdf: never more than rho comes back", own_conserves,
         "The lobe's integral with the cosine must not exceed rho: from which w_o is it "
         "largest?"},
        {"own_brdf: something comes back", own_reflects,
         "Is the factor before the lobe large enough, and is rho in it?"},
        {"own_brdf: a lobe", own_has_a_lobe, "Anything but Lambert's."},
        {"own_brdf: shine changes it", own_uses_shine,
         "Use shine: as the power of a cosine, or the width of the lobe."},
        {"own_brdf: the same when all is turned", own_turned,
         "f may use n, w_i and w_o, and no axis of the world."},
        {"quadrature_rule: polynomials", rule_degrees, given_code},
        {"quadrature_rule: points and weights", rule_points, given_code},
        {"integrate_cube: 1 to 8 dimensions", cube_products, given_code},
        {"direction_at: angles and lengths", directions, given_code},
        {"sphere_irradiance: known values", known_spheres, given_code},
        {"sphere_irradiance: cut by the horizon", cut_spheres, given_code},
        {"sphere_irradiance: as a point of the same flux", sphere_like_a_point, given_code},
        {"rectangle_irradiance: known values", known_rectangles, given_code},
        {"rectangle_irradiance: cut in two, and over the area", rectangles_anywhere,
         given_code},
        {"rectangle_irradiance: small and far", far_rectangles, given_code},
        {"form_factor: known values", known_form_factors, given_code},
        {"form_factor: reciprocity", form_factor_reciprocity, given_code},
        {"outgoing_radiance: emission and a sky", equation, given_code},
    };
    return run_tests("07-rendering-equation", tests, COUNT(tests));
}
