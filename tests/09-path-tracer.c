// Tests of 09-path-tracer: directions, the bounce, the path as a loop, roulette, and
// the furnace test; each mean against a closed form.
#define _POSIX_C_SOURCE 200809L
#include <stdio.h>
#include <string.h>

#include "chapters/09-path-tracer/box.h"
#include "common/exact3.h"
#include "common/wide3.h"
#include "tests/check-directions.h"
#include "tests/check-threads.h"
#include "tests/check.h"

#define GREY(a) ((color){(real)(a), (real)(a), (real)(a)})

// For what is itself a statistic: `got` is within `slack` of the guess.
static void suspect_about(const char *what, double got, double guess, double slack) {
    if (fabs(got - guess) < slack) suspect_value(what, got);
}

static color white_sky(vec3 d) {
    (void)d;
    return (color){1, 1, 1};
}

// ---- hemisphere_direction ----------------------------------------------------------

static void direction_differs(void) {
    rng g = check_rng(1);
    for (int i = 0; i < 20; i++) {
        const vec3 n = generic_unit(&g);
        given("n = " VEC, ARG(n));
        const vec3 first = hemisphere_direction(n, &g);
        int alike = 0;
        for (int k = 0; k < 100; k++) {
            const vec3 v = hemisphere_direction(n, &g);
            alike += v.x == first.x && v.y == first.y && v.z == first.z;
        }
        given("n = " VEC ": the first draw is " VEC ", and %d of the next 100 are the same",
              ARG(n), ARG(first), alike);
        CHECK(alike < 50, "all draws are alike: is g used?");
    }
}

static void direction_from_g(void) {
    rng g = check_rng(6);
    for (int i = 0; i < 200; i++) {
        const vec3 n = generic_unit(&g);
        rng one = rng_seed(1, (uint64_t)i), other = one;
        const vec3 first = hemisphere_direction(n, &one),
                   second = hemisphere_direction(n, &other);
        given("n = " VEC ", " ASKED_TWICE, ARG(n), ARG(first), ARG(second));
        check_from_g(first, second);
    }
}

static void direction_unit(void) {
    rng g = check_rng(2);
    long below = 0;
    vec3 worst = {0, 0, 0}, worst_n = {0, 0, 0};
    for (int i = 0; i < 100000; i++) {
        const vec3 n = test_normal(i % 100, &g);
        given("n = " VEC ": draw %d", ARG(n), i + 1);
        const vec3 v = hemisphere_direction(n, &g);
        given("n = " VEC ": draw %d is " VEC, ARG(n), i + 1, ARG(v));
        const double length_of_v = wide_length(v);
        CHECK_REAL(length_of_v, 1, roundings(10, "a unit vector"));
        if (dot(v, n) >= 0) continue;
        if (below++ == 0) worst = v, worst_n = n;
    }
    given("%ld of 100,000 directions point into the surface; the first: " VEC " for n = " VEC
          "%s",
          below, ARG(worst), ARG(worst_n),
          below > 33000 ? ". Half of them: the whole sphere, not the half above n" : "");
    const long directions_below = below;
    CHECK(directions_below == 0, "every direction leaves the surface: v·n >= 0");
}

// The height of a uniform point of the half sphere is uniform (Archimedes).
static void direction_mean(void) {
    rng g = check_rng(3);
    for (int i = 0; i < 8; i++) {
        const vec3 n = test_normal(i, &g), across = perpendicular(n);
        given("n = " VEC ": the mean cosine between n and 50,000 directions", ARG(n));
        running height = {0}, aside = {0};
        for (int k = 0; k < 50000; k++) {
            const vec3 v = hemisphere_direction(n, &g);
            running_add(&height, wide_dot(widen(v), widen(n)));
            running_add(&aside, wide_dot(widen(v), widen(across)));
        }
        const bool draws_differ = height.max > height.min;
        const double mean_cosine = height.mean, mean_across = aside.mean;
        CHECK(draws_differ, "the draws differ: is g used?");
        suspect_value("the density cos θ / π: Lambert's bounce of chapter 06, not uniform",
                      2.0 / 3);
        suspect_about("uniform over the whole sphere: those below the surface too", mean_cosine,
                      0, 0.02);
        suspect_value("uniform in the angle θ: crowded around n (dω = sin θ dθ dφ)", 2 / PI);
        suspect_value("all in the lower half: which sign is turned round?", -0.5);
        CHECK_REAL(mean_cosine, 0.5, standard_errors(5, running_standard_error(&height)));
        given("n = " VEC ": the same, along " VEC ", which is perpendicular to n", ARG(n),
              ARG(across));
        CHECK_REAL(mean_across, 0, standard_errors(5, running_standard_error(&aside)));
    }
}

static void direction_cells(void) {
    rng g = check_rng(4);
    const long count = 200000;
    for (int i = 0; i < 6; i++) {
        const vec3 n = test_normal(i, &g);
        tally cells = {{0}, 0};
        given("n = " VEC ": 200,000 directions counted in 8 x 12 cells of the height above the "
              "surface and of the angle about n, all equally likely for 1/(2π)",
              ARG(n));
        for (long k = 0; k < count; k++) {
            const vec3 v = hemisphere_direction(n, &g);
            tally_add(&cells, cosine(v, n), turn(v, n));
        }
        CHECK_UNIFORM(&cells);
    }
}

// The samples 2 (n·v) L of a wall with albedo 1: under a sky of 1 their variance is 1/3; under
// a ball lamp straight above, of radius R at the height 3 R, 4/3 (1 - (8/9)^1.5) - 1/81.
static void direction_variance(void) {
    rng g = check_rng(5);
    const double edge = sqrt(8.0 / 9); // the cosine at the lamp's rim
    const vec3 n = generic_unit(&g);
    running sky = {0}, lamp = {0};
    given("n = " VEC ": 200,000 samples 2 (n·v)", ARG(n));
    for (int i = 0; i < 200000; i++) {
        const double sample = 2 * wide_dot(widen(n), widen(hemisphere_direction(n, &g)));
        const double of_lamp = sample > 2 * edge ? sample : 0;
        running_add(&sky, (sample - 1) * (sample - 1));
        running_add(&lamp, (of_lamp - 1.0 / 9) * (of_lamp - 1.0 / 9));
    }
    const double variance_of_sky = sky.mean, variance_of_lamp = lamp.mean;
    given("200,000 samples 2 (n·v) under a sky of 1: their mean squared distance from 1");
    suspect_about("no spread: all directions have one cosine", variance_of_sky, 0, 1e-3);
    CHECK_REAL(variance_of_sky, 1.0 / 3, standard_errors(5, running_standard_error(&sky)));
    given("the same under a ball lamp of radius 1 at the height 3: from its mean, 1/9");
    CHECK_REAL(variance_of_lamp, 4.0 / 3 * (1 - edge * edge * edge) - 1.0 / 81,
               standard_errors(5, running_standard_error(&lamp)));
}

// ---- what a bunch of paths brings ----------------------------------------------------

typedef struct {
    running red, green, blue;
    long black, negative, odd; // samples that are 0; below 0; NaN or infinite
    char call[80];             // the mean in the student's words
} light;

static void light_add(light *all, color L) {
    running_add(&all->red, (double)L.x);
    running_add(&all->green, (double)L.y);
    running_add(&all->blue, (double)L.z);
    all->black += L.x == 0 && L.y == 0 && L.z == 0;
    all->negative += L.x < 0 || L.y < 0 || L.z < 0;
    all->odd += !is_finite(L);
}

static void call_it(light *all, path_tracer f, int s) {
    const char *loop = "path_trace(&sc, r, %d, &g), mean";
    const char *slide = "trace_ray_slide(&sc, r, %d, &g), mean";
    const char *recursion = "trace_ray(&sc, r, %d, &g), which asks bounce_ray, mean";
    const char *words = f == path_trace ? loop : f == trace_ray ? recursion : slide;
    snprintf(all->call, sizeof all->call, words, s);
}

static light paths(path_tracer f, const room *sc, ray r, int s, long n, rng *g) {
    light all = {0};
    call_it(&all, f, s);
    for (long i = 0; i < n; i++) light_add(&all, f(sc, r, s, g));
    return all;
}

static vec3 mean_of(const light *all) {
    return (vec3){(real)all->red.mean, (real)all->green.mean, (real)all->blue.mean};
}

static void check_finite(int line, const light *all) {
    char found[80];
    snprintf(found, sizeof found, "%ld of %ld are NaN or infinite", all->odd, all->red.n);
    check_that(__FILE__, line, found, all->odd == 0, "no sample is NaN or infinite");
}

// Five standard errors of each colour, and what rounding may add to an exact answer.
static void check_channels(int line, const light *all, color truth) {
    const running *means[] = {&all->red, &all->green, &all->blue};
    const char *const names[] = {"red", "green", "blue"};
    const real truths[] = {truth.x, truth.y, truth.z};
    check_finite(line, all);
    for (int i = 0; i < 3; i++) {
        char call[100];
        snprintf(call, sizeof call, "%s of %s", all->call, names[i]);
        const double rounding = 8 * (double)REAL_EPSILON * (double)truths[i];
        const double error = running_standard_error(means[i]) + rounding;
        check_real(__FILE__, line, call, means[i]->mean, (double)truths[i],
                   standard_errors(5, error));
    }
    char found[80];
    snprintf(found, sizeof found, "%ld of %ld are negative", all->negative, all->red.n);
    check_that(__FILE__, line, found, all->negative == 0,
               "no sample is negative: is v always on the side of n?");
}

// All colours are off by one factor: says which, unless tests/check.c knows it.
static void suspect_scaled(color mean, color truth) {
    static char words[80];
    static const double known[] = {-1, 2, 4, PI, 2 * PI, 0};
    const real k = dot(mean, truth) / dot(truth, truth);
    for (int i = 0; i < COUNT(known); i++)
        if (fabs((double)k - known[i]) < 0.03 * fabs(known[i]) ||
            fabs(1 / (double)k - known[i]) < 0.03 * fabs(known[i]))
            return;
    if (!(length(sub(mean, scale(k, truth))) < (real)0.02 * length(truth))) return;
    snprintf(words, sizeof words, "%.3g times the light, alike in all colours", (double)k);
    suspect_vec3(words, mean);
}

static void check_colour(int line, const light *all, color truth) {
    check_finite(line, all);
    suspect_scaled(mean_of(all), truth);
    const double error = running_standard_error(&all->blue) * 1.3 + 1e-6;
    check_vec3(__FILE__, line, all->call, mean_of(all), truth, standard_errors(5, error));
    check_channels(line, all, truth);
}

#define CHECK_COLOUR(all, truth) check_colour(__LINE__, all, truth)
#define CHECK_CHANNELS(all, truth) check_channels(__LINE__, all, truth)

// Nothing comes back from the surface that is seen.
static const char *own_surface(path_tracer f) {
    return f == path_trace
               ? "the bounce is missing, or C times the sky on a miss; or the next ray "
                 "meets its own surface at once: offset_origin"
               : "the bounce is missing, or its ray meets its own surface at once: "
                 "offset_origin";
}

// ---- scenes with closed forms --------------------------------------------------------

// A place, three axes and a size, so that no scene lies along x, y, z.
typedef struct {
    vec3 O, x, y, z;
    real size;
} frame;

static frame some_frame(real far, real size, rng *g) {
    const vec3 y = generic_unit(g), x = perpendicular(y);
    return (frame){scale(far * size, generic_unit(g)), x, y, cross(x, y), size};
}

static vec3 along(const frame *F, vec3 v) {
    return add(scale(F->size * v.x, F->x),
               add(scale(F->size * v.y, F->y), scale(F->size * v.z, F->z)));
}

static vec3 place(const frame *F, vec3 p) {
    return add(F->O, along(F, p));
}

// A ray of the length `reach` times the distance, from p to q, both in the frame.
static ray from_to(const frame *F, vec3 p, vec3 q, real reach) {
    const vec3 O = place(F, p);
    return (ray){O, scale(reach, sub(place(F, q), O))};
}

static const color tint = {(real)0.25, (real)0.5, (real)0.75};

typedef struct {
    sphere ball;
    matte skin;
    room sc;
} lone_ball;

// A ball of radius 1.25 of the frame in a sky of 1.
static void lone_ball_at(lone_ball *b, const frame *F, matte skin) {
    b->ball = (sphere){F->O, (real)1.25 * F->size};
    b->skin = skin;
    b->sc = (room){{.spheres = &b->ball, .sphere_count = 1, .sky = white_sky}, &b->skin};
}

// Meets the ball where its normal is y, at the angle θ.
static ray arriving_at(const frame *F, double theta, real reach) {
    const vec3 p = {0, (real)1.25, 0};
    const vec3 from = {(real)sin(theta), (real)cos(theta), 0};
    return from_to(F, add(p, scale(2, from)), p, reach);
}

// The furnace: a convex body of albedo a in a sky of 1 sends out a.
static void furnace_of(path_tracer f, uint64_t stream) {
    rng g = check_rng(stream);
    const double degrees[] = {45, 10, 80};
    for (int i = 0; i < 3 * COUNT(degrees); i++) {
        const double theta = degrees[i % COUNT(degrees)] * PI / 180;
        const frame F = some_frame(3, (real)pow(10, i / 3 - 1), &g);
        lone_ball b;
        lone_ball_at(&b, &F, (matte){.albedo = tint});
        const real reach = i % 2 ? (real)0.2 : 13; // |d| cos θ is not 1
        const ray r = arriving_at(&F, theta, reach);
        const double d = wide_length(r.d);
#define BALL                                                                       \
    "a ball of albedo (0.25, 0.5, 0.75) in a sky of 1, seen at %g degrees; |d| = " \
    "%.3g, s = %d: the mean of 40,000 paths"
        given(BALL, degrees[i % COUNT(degrees)], d, 1 + i % 4);
        const light all = paths(f, &b.sc, r, 1 + i % 4, 40000, &g);
        const bool spread = all.green.max - all.green.min > 1e-3;
        given(BALL ", %ld of which are negative and %ld black", degrees[i % COUNT(degrees)], d,
              1 + i % 4, all.negative, all.black);
        const double slip = -cos(theta);
        suspect_factor("-dot(n, v): the sign of the cosine is wrong", -1);
        suspect_factor("dot(d, v) in place of dot(n, v): the slide's slip", slip);
        suspect_factor("dot(d, v) in place of dot(n, v), and d not of unit length", slip * d);
        suspect_factor("|dot(d, v)| in place of dot(n, v)", -slip);
        suspect_factor(spread ? "the density 1/(4π) of the whole sphere, not 1/(2π)"
                              : "the cosine n·v is missing",
                       2);
        suspect_factor("the BRDF of Lambert is albedo/π: its π is missing", PI);
        suspect_factor("not divided by the probability 1/(2π)", 1 / (2 * PI));
        suspect_factor("multiplied by the probability in place of divided", 1 / (4 * PI * PI));
        suspect_factor("π and 2: the BRDF's π and the density's 2 are missing", 2 * PI);
        suspect_vec3("the light of the sky, unfiltered by the ball", (vec3){1, 1, 1});
        suspect_vec3("the albedo squared: it counts twice", mul(tint, tint));
        if (all.black == 40000) suspect_vec3(own_surface(f), mean_of(&all));
        if (all.black > 400)
            suspect_vec3("part of the rays bring nothing: they meet their own surface at once "
                         "(offset_origin), or v points into the surface",
                         mean_of(&all));
        CHECK_COLOUR(&all, tint);
    }
}

// The ball shines as well: e + a.
static void shining_ball(path_tracer f, uint64_t stream) {
    rng g = check_rng(stream);
    const color e = {(real)0.7, (real)1.3, (real)2.9};
    const double theta = 0.9;
    char alone[240];
    for (int i = 0; i < 4; i++) {
        const frame F = some_frame(2, 1, &g);
        lone_ball b;
        lone_ball_at(&b, &F, (matte){tint, e});
        const ray r = arriving_at(&F, theta, 2);
        given("a ball of albedo a = (0.25, 0.5, 0.75) that shines with the radiance (0.7, 1.3, "
              "2.9), in a sky of 1; s = %d",
              i);
        suspect_vec3("no emission at all", i == 0 ? (vec3){0, 0, 0} : tint);
        suspect_vec3("the emission filtered by the albedo: C is coloured before L collects",
                     mul(tint, e));
        if (i == 0) {
            const light one = paths(f, &b.sc, r, 0, 1, &g);
            if (one.red.mean > (double)e.x)
                suspect_vec3("a bounce is made although s is 0", mean_of(&one));
            check_vec3(__FILE__, __LINE__, one.call, mean_of(&one), e, exactly());
            continue;
        }
        const light all = paths(f, &b.sc, r, i, 20000, &g);
        given("the same ball and sky, s = %d: the mean of 20,000 paths", i);
        suspect_vec3("the reflected light is negative: the sign of the cosine is wrong",
                     sub(e, tint));
        suspect_vec3("the emission is missing", tint);
        suspect_vec3("the emission counts twice", add(tint, scale(2, e)));
        suspect_vec3(
            "the reflected light twice: is the cosine n·v there, and the density 1/(2π)?",
            add(scale(2, tint), e));
        suspect_vec3("the emission filtered by the albedo: C is coloured before L collects",
                     add(tint, mul(tint, e)));
        const real slip = (real)-cos(theta);
        suspect_vec3("dot(d, v) in place of dot(n, v): the slide's slip",
                     add(e, scale(slip, tint)));
        suspect_vec3("dot(d, v) in place of dot(n, v), and d not of unit length",
                     add(e, scale(slip * length(r.d), tint)));
        suspect_vec3("the sky is not multiplied by C", add(e, (vec3){1, 1, 1}));
        snprintf(alone, sizeof alone, "the emission alone: %s", own_surface(f));
        suspect_vec3(alone, e);
        CHECK_COLOUR(&all, add(e, tint));
    }
}

// 1 on one side of this plane, 0.15 on the other.
static const vec3 slanted = {(real)0.48, (real)0.6, (real)0.64};

static color two_skies(vec3 d) {
    return dot(d, slanted) > 0 ? GREY(1) : GREY(0.15);
}

// A wall under a sky that is bright on one side: lit by the side that it is seen from.
static void both_sides(path_tracer f, uint64_t stream) {
    rng g = check_rng(stream);
    const color e = {2, 3, 4};
    for (int i = 0; i < 4; i++) {
        const bool bright = i & 1, front = i & 2;        // which side of the sky, of the wall
        const vec3 up = bright ? slanted : neg(slanted); // towards the eye
        const plane wall = {scale(3, generic_unit(&g)), scale((real)1.7, front ? up : neg(up))};
        const matte skin = {tint, e};
        const room sc = {{.planes = &wall, .plane_count = 1, .sky = two_skies}, &skin};
        const vec3 O = add(wall.x, add(scale(2, up), scale((real)1.5, perpendicular(up))));
        const ray r = {O, normalize(sub(wall.x, O))};
        const real slip = dot(r.d, up); // the slide's cosine in the mean, times 2
        const real here = bright ? 1 : (real)0.15, there = bright ? (real)0.15 : 1;
        const color shine = front ? e : (color){0, 0, 0};
        given("a wall of albedo (0.25, 0.5, 0.75) whose front shines with (2, 3, 4), seen from "
              "%s; the sky on that side is %g, on the other %g: the mean of 20,000 paths",
              front ? "in front" : "behind", (double)here, (double)there);
        const light all = paths(f, &sc, r, 2, 20000, &g);
        const color lit = scale(here, tint), other = scale(there, tint);
        suspect_vec3("minus the reflected light: the sign of the cosine is wrong",
                     sub(shine, lit));
        suspect_vec3("dot(d, v) in place of dot(n, v): the slide's slip",
                     add(scale(slip, lit), shine));
        suspect_vec3("dot(d, v) in place of dot(n, v), and n is not turned to where the ray "
                     "came from",
                     add(scale(-slip, other), shine));
        suspect_vec3(own_surface(f), shine);
        suspect_vec3("the emission filtered by the albedo: C is coloured before L collects",
                     add(lit, mul(tint, shine)));
        suspect_vec3("the light of the other side: n must be turned to where the ray came from",
                     add(other, shine));
        suspect_vec3("the back shines too, or n was turned before it was asked", add(lit, e));
        CHECK_COLOUR(&all, add(lit, shine));
    }
}

// A closed room of six walls that face inwards and shine.
typedef struct {
    plane walls[6];
    matte skins[6];
    room sc;
} cavity;

static void cavity_of(cavity *c, const frame *F, matte skin) {
    const vec3 out[] = {{2, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 3}, {0, 0, -1}};
    for (int i = 0; i < 6; i++) {
        c->walls[i] = (plane){place(F, out[i]), neg(along(F, out[i]))};
        c->skins[i] = skin;
    }
    c->sc = (room){{.planes = c->walls, .plane_count = 6}, c->skins};
}

static double truncated(double a, int s) {
    return s < 0 ? 0 : (1 - pow(a, s + 1)) / (1 - a);
}

// With at most s bounces E (1 - a^(s+1)) / (1 - a) comes from each wall. The albedo is below
// 0.75, so that four moments exist and the standard error can be trusted.
static void cavities(path_tracer f, const int *bounces, int count, uint64_t stream) {
    rng g = check_rng(stream);
    const double a = 0.6;
    const color E = {(real)0.5, 1, 2};
    for (int i = 0; i < count; i++) {
        const int s = bounces[i];
        const frame F = some_frame(1, (real)pow(10, i % 3 - 1), &g);
        cavity c;
        cavity_of(&c, &F, (matte){GREY(a), E});
        const ray r = from_to(&F, scale((real)0.8, in_cube(&g)), in_cube(&g), 3);
        const double truth = truncated((double)(real)a, s);
        given("inside a closed room whose walls have the albedo 0.6 and shine with (0.5, 1, "
              "2); s = %d: the mean of 30,000 paths",
              s);
        const light all = paths(f, &c.sc, r, s, 30000, &g);
        suspect_vec3("one bounce more than s", scale((real)truncated(a, s + 1), E));
        if (s == 0)
            suspect_vec3(
                f == path_trace
                    ? "no emission: L collects before bounce == s ends the path, and "
                      "before C is coloured"
                    : "no emission where the path ends: s = 0 still brings emitted(m, h)",
                (color){0, 0, 0});
        if (s > 0) suspect_vec3("one bounce less than s", scale((real)truncated(a, s - 1), E));
        if (s > 0) suspect_vec3("the emission of the first wall only", E);
        if (s > 0)
            suspect_vec3("the first wall's emission is missing, or C is coloured before L "
                         "collects",
                         scale((real)(truth - 1), E));
        suspect_vec3("the emission filtered by the wall that sends it: C is coloured before L "
                     "collects",
                     scale((real)(a * truth), E));
        suspect_vec3("the emission counts twice", scale((real)(2 * truth), E));
        const double found = all.green.mean / truth, sure = truncated(a, 3) / truth;
        char lost[120];
        snprintf(
            lost, sizeof lost,
            "light is lost after the three sure bounces: does C carry 1/q? Or is a path cut "
            "after about %.0f bounces?",
            log(1 - found) / log(a) - 1);
        if (f == path_trace && s > 3 && found > sure + 0.01 && found < 0.98)
            suspect_vec3(lost, mean_of(&all));
        CHECK_COLOUR(&all, scale((real)truth, E));
    }
}

// ---- lights with closed forms ----------------------------------------------------------
// A floor of albedo rho, y = 0, under a black lamp: L = rho E/π, and E grows with the radiance.

typedef struct {
    const char *name;
    bool square;  // a rectangle; else a ball of radius 1 at c
    vec3 c, u, v; // the corner and the sides of a rectangle, that shines to u x v
    double share; // E/π, for the radiance 1
} lamp_case;

static const lamp_case lamp_cases[] = {
    {"a ball of radius 1 straight above, at 1.5", false, {0, (real)1.5, 0}, .share = 1 / 2.25},
    {"a ball of radius 1 straight above, at 2", false, {0, 2, 0}, .share = 0.25},
    {"a ball of radius 1 at the height 2, 1.5 to the side",
     false,
     {(real)1.5, 2, 0},
     .share = 2 / 15.625},
    {"a ball of radius 1 at the height 0.5, 2 to the side: part of it below the horizon",
     false,
     {2, (real)0.5, 0},
     .share = 0.196801876179 / PI},
    {"a ball of radius 1 at the height 0, 2 to the side: half of it below the horizon",
     false,
     {0, 0, -2},
     .share = 0.090586073706 / PI},
    {"a square of side 1 at the height 1, a corner straight above",
     true,
     {0, 1, 0},
     {1, 0, 0},
     {0, 0, 1},
     0.138531605995},
    {"a square of side 1 at the height 1, its centre straight above",
     true,
     {(real)-0.5, 1, (real)-0.5},
     {1, 0, 0},
     {0, 0, 1},
     0.239456470461},
    {"a square of side 1 that stands on the floor, a corner at the distance 1",
     true,
     {1, 0, 0},
     {0, 0, 1},
     {0, 1, 0},
     0.055734197003},
};

typedef struct {
    sphere ball;
    plane floor;
    vec3 points[4];
    mesh square;
    matte skins[2];
    room sc;
} lamp_scene;

static const int square_corners[][3] = {{0, 1, 2}, {0, 2, 3}};

static void lamp_scene_of(lamp_scene *l, const frame *F, const lamp_case *k, real rho,
                          real L_e) {
    const matte lamp = {.emittance = GREY(L_e)}, stone = {.albedo = GREY(rho)};
    const vec3 far = add(k->c, add(k->u, k->v));
    l->ball = (sphere){place(F, k->c), F->size};
    l->floor = (plane){place(F, (vec3){0, 0, 0}), scale((real)0.7, F->y)};
    l->points[0] = place(F, k->c), l->points[1] = place(F, add(k->c, k->u));
    l->points[2] = place(F, far), l->points[3] = place(F, add(k->c, k->v));
    l->square =
        (mesh){.points = l->points, .corners = square_corners, .count = COUNT(square_corners)};
    l->skins[k->square ? 0 : 1] = stone, l->skins[k->square ? 1 : 0] = lamp;
    l->sc = (room){{.planes = &l->floor, .plane_count = 1}, l->skins};
    if (k->square) l->sc.bodies.meshes = &l->square, l->sc.bodies.mesh_count = 1;
    if (!k->square) l->sc.bodies.spheres = &l->ball, l->sc.bodies.sphere_count = 1;
}

// The share of the hemisphere's directions that meet a ball wholly above the horizon.
static double share_of_directions(vec3 c) {
    return 1 - sqrt(1 - 1 / (double)dot(c, c));
}

static void suspect_lamp(const lamp_case *k, const light *all, double L_e, double rho,
                         double cosine_of_eye) {
    suspect_factor("-dot(n, v): the sign of the cosine is wrong", -1);
    suspect_factor("the density 1/(4π) of the whole sphere, not 1/(2π)", 2);
    suspect_factor("the BRDF of Lambert is albedo/π: its π is missing", PI);
    if (k->square || k->c.y < 1) return;
    const double share = L_e * share_of_directions(k->c);
    if (all->green.max == L_e)
        suspect_value(
            "the emission of the lamp is not multiplied by C: what the floor lets through",
            share);
    suspect_value(
        "the density cos θ / π, though the directions are uniform: sampler and density "
        "do not belong together",
        rho * share);
    suspect_value("the cosine n·v is missing", 2 * rho * share);
    if (k->c.x == 0)
        suspect_factor("|dot(d, v)| in place of dot(n, v), which no furnace can see",
                       cosine_of_eye);
}

static void lamps(path_tracer f, int s, uint64_t stream) {
    rng g = check_rng(stream);
    const real rho = (real)0.8;
    const vec3 eye = {-2, 2, (real)0.3}; // sees past the balls, and none is behind its back
    for (int i = 0; i < COUNT(lamp_cases); i++) {
        const lamp_case *k = &lamp_cases[i];
        const frame F = some_frame(2, (real)pow(10, i % 5 - 2), &g);
        const double L_e = (double[]){1, 1000, 0.001}[i % 3];
        lamp_scene l;
        lamp_scene_of(&l, &F, k, rho, (real)L_e);
        const ray r = from_to(&F, eye, (vec3){0, 0, 0}, 5);
        given("a floor of albedo 0.8, lit by %s, of radiance %g, alone; s = %d. L = rho E/π is "
              "the mean of 60,000 paths",
              k->name, L_e, s);
        const light all = paths(f, &l.sc, r, s, 60000, &g);
        const bool lamp_is_found = all.black < 60000;
        CHECK(lamp_is_found, "some paths find the lamp: is its emission collected, and does "
                             "the next ray leave the floor (offset_origin)?");
        suspect_lamp(k, &all, L_e, (double)rho, (double)normalize(eye).y);
        if (L_e > 1 && all.green.max < 0.05 * L_e)
            suspect_value("no sample is as bright as this lamp can make it: is light cut off?",
                          all.green.mean);
        CHECK_CHANNELS(&all, GREY((double)rho * k->share * L_e));
    }
}

// ---- acne and extremes -------------------------------------------------------------------

// s = 1 and a convex body: a next ray that meets the body again brings nothing. The
// cosine itself is 0 once in 2^24 draws at most, and then the ray is grazing anyway.
static void no_acne(path_tracer f, uint64_t stream) {
    rng g = check_rng(stream);
    const real sizes[] = {(real)1e-6, (real)1e-3, 1, (real)1e3, (real)1e6},
               distances[] = {0, 1, 100, 10000};
    for (int i = 0; i < COUNT(sizes) * COUNT(distances); i++) {
        const real far = distances[i / COUNT(sizes)];
        const frame F = some_frame(far, sizes[i % COUNT(sizes)], &g);
        lone_ball b;
        lone_ball_at(&b, &F, (matte){.albedo = GREY(0.5)});
        light all = {0};
        call_it(&all, f, 1);
        given("a ball of radius %.3g, %g radii from the origin, in a sky of 1; s = 1",
              (double)b.ball.r, (double)far / 1.25);
        for (int k = 0; k < 2000; k++) {
            const vec3 O = add(b.ball.c, scale(3 * b.ball.r, unit_vector(&g)));
            const vec3 aim = add(b.ball.c, scale((real)0.9 * b.ball.r, unit_vector(&g)));
            light_add(&all, f(&b.sc, (ray){O, sub(aim, O)}, 1, &g));
        }
        given("a ball of radius %.3g, %g radii from the origin, in a sky of 1; s = 1: %ld of "
              "2000 paths bring nothing",
              (double)b.ball.r, (double)far / 1.25, all.black);
        const long paths_that_bring_nothing = all.black;
        if (f == path_trace && all.black == 2000)
            suspect_slip(
                "the sky is missing: does a path that meets nothing add C times the sky?");
        CHECK(paths_that_bring_nothing <= 1,
              "every next ray leaves the surface that it starts from: does it "
              "start off the surface, on the right side?");
        if (all.green.min == 1)
            suspect_value("the sky itself: not multiplied by the albedo", 1);
        CHECK_CHANNELS(&all, GREY(0.5));
    }
}

typedef struct {
    sphere balls[4];
    plane walls[2];
    vec3 points[3];
    mesh flake;
    matte skins[7];
    room sc;
} odd_scene;

static const int flake_corners[][3] = {{0, 1, 2}};

static real some_share(rng *g) {
    const real u = rng_real(g);
    const uint32_t kind = rng_bits(g) % 4;
    return kind == 0 ? 0 : kind == 1 ? 1 : u;
}

static matte some_matte(rng *g) {
    matte m = {{0, 0, 0}, {0, 0, 0}};
    m.albedo.x = some_share(g), m.albedo.y = some_share(g), m.albedo.z = some_share(g);
    if (rng_bits(g) % 3 == 0) {
        const real e = (real)pow(10, (double)between(g, -4, 4));
        m.emittance = (color){e, 0, 2 * e};
    }
    return m;
}

static void odd_scene_of(odd_scene *o, rng *g) {
    const real size = (real)pow(10, (double)between(g, -4, 4));
    for (int i = 0; i < 4; i++) {
        o->balls[i].c = scale(size, in_cube(g));
        o->balls[i].r = size * (real)pow(10, (double)between(g, -4, 0));
    }
    for (int i = 0; i < 2; i++) o->walls[i] = (plane){scale(size, in_cube(g)), generic_unit(g)};
    for (int i = 0; i < 3; i++) o->points[i] = scale(size, in_cube(g));
    for (int i = 0; i < 7; i++) o->skins[i] = some_matte(g);
    o->flake = (mesh){.points = o->points, .corners = flake_corners, .count = 1};
    o->sc = (room){{.spheres = o->balls,
                    .sphere_count = 4,
                    .planes = o->walls,
                    .plane_count = (int)(rng_bits(g) % 3),
                    .sky = rng_bits(g) % 2 ? white_sky : NULL},
                   o->skins};
    if (o->sc.bodies.plane_count == 2) o->sc.bodies.meshes = &o->flake;
    o->sc.bodies.mesh_count = o->sc.bodies.meshes != NULL;
}

// No sample is negative, infinite or NaN, in whatever scene and wherever the eye is.
static void odd_scenes(path_tracer f, int longest, uint64_t stream) {
    rng g = check_rng(stream);
    for (int i = 0; i < 2000; i++) {
        odd_scene o;
        odd_scene_of(&o, &g);
        for (int k = 0; k < 20; k++) {
            const vec3 O = scale(length(o.points[0]), in_cube(&g));
            const ray r = {O, scale((real)pow(10, k % 7 - 3), generic_unit(&g))};
            const int s = (int)(rng_bits(&g) % (uint32_t)(longest + 1));
            given("random balls, walls and lamps of all sizes; scene %d, ray %d, s = %d", i, k,
                  s);
            const color L = f(&o.sc, r, s, &g);
            const bool negative = L.x < 0 || L.y < 0 || L.z < 0;
            if (!is_finite(L) || negative)
                given("random balls, walls and lamps of all sizes; scene %d, ray %d, s = %d "
                      "brings " VEC,
                      i, k, s, ARG(L));
            CHECK(is_finite(L), "no sample is NaN or infinite");
            CHECK(!negative, "no sample is negative: is v always on the side of n?");
        }
    }
}

// ---- bounce_ray --------------------------------------------------------------------------

static void bounce_furnace(void) {
    furnace_of(trace_ray, 10);
}

static void bounce_shining(void) {
    shining_ball(trace_ray, 11);
}

static void bounce_sides(void) {
    both_sides(trace_ray, 12);
}

static void bounce_cavity(void) {
    const int bounces[] = {0, 1, 2, 3, 7};
    cavities(trace_ray, bounces, COUNT(bounces), 13);
}

static void bounce_lamps(void) {
    lamps(trace_ray, 1, 14);
}

static void bounce_acne(void) {
    no_acne(trace_ray, 15);
}

static void bounce_odd(void) {
    odd_scenes(trace_ray, 12, 16);
}

// ---- path_trace --------------------------------------------------------------------------

static void path_furnace(void) {
    furnace_of(path_trace, 20);
}

static void path_shining(void) {
    shining_ball(path_trace, 21);
}

static void path_sides(void) {
    both_sides(path_trace, 22);
}

static void path_cavity(void) {
    const int bounces[] = {0, 1, 2, 3}; // no roulette yet
    cavities(path_trace, bounces, COUNT(bounces), 23);
}

// With roulette; and E/(1 - a), what no s cuts.
static void path_cavity_deep(void) {
    const int bounces[] = {7, 1000000, 1000};
    cavities(path_trace, bounces, COUNT(bounces), 24);
}

static void path_lamps(void) {
    lamps(path_trace, 1, 25);
    lamps(path_trace, 50, 26);
}

static void path_acne(void) {
    no_acne(path_trace, 27);
}

static void path_odd(void) {
    odd_scenes(path_trace, 40, 28);
}

// Only roulette ends these paths.
static void path_ends(void) {
    rng g = check_rng(29);
    const frame F = some_frame(1, 1, &g);
    cavity c;
    cavity_of(&c, &F, (matte){.albedo = GREY(1)});
    const ray r = from_to(&F, (vec3){0, 0, 0}, in_cube(&g), 1);
    given("a closed black room whose walls reflect everything, s = 1,000,000,000: only "
          "roulette(survival(C, bounce), g) ends a path, after any bounce, by giving 0");
    const light all = paths(path_trace, &c.sc, r, 1000000000, 2000, &g);
    const long paths_that_bring_light = 2000 - all.black;
    CHECK(paths_that_bring_light == 0, "no wall shines: no path brings light");
}

// How many random numbers were drawn between two states of a generator.
static long drawn(rng before, rng after) {
    long count = 0;
    while (before.state != after.state && count < 1000000) rng_bits(&before), count++;
    return count;
}

static running numbers_drawn(const room *sc, int s, rng *g) {
    running all = {0};
    for (int i = 0; i < 100000; i++) {
        const rng before = *g;
        path_trace(sc, (ray){{0, (real)0.5, 0}, generic_unit(g)}, s, g);
        running_add(&all, (double)drawn(before, *g));
    }
    return all;
}

// In a white room a fifth of all bounces come after the eighth, a fourteenth after the sixteenth:
// a right path_trace draws more numbers then by 80 and by 25 standard errors.
static void path_long(void) {
    rng g = check_rng(31);
    const frame F = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 1};
    const int cuts[] = {8, 16};
    cavity c;
    cavity_of(&c, &F, (matte){.albedo = GREY(1)});
    const running far = numbers_drawn(&c.sc, 1000000, &g);
    for (int i = 0; i < COUNT(cuts); i++) {
        const running near = numbers_drawn(&c.sc, cuts[i], &g);
        const double error = hypot(running_standard_error(&far), running_standard_error(&near));
        given(
            "a closed room whose walls reflect everything: a path draws %.4f random numbers in "
            "the mean when s = 1,000,000, and %.4f when s = %d; standard error of the "
            "difference "
            "%.4f",
            far.mean, near.mean, cuts[i], error);
        const bool goes_further_with_the_larger_s = far.mean - near.mean > 5 * error;
        CHECK(goes_further_with_the_larger_s,
              "nothing but s and roulette ends a path: is there another limit?");
    }
}

// ---- a second opinion ----------------------------------------------------------------------
// Paths by other means: directions with the density cos θ / π (n plus a unit vector),
// which makes every weight the albedo, and no roulette.

static vec3 lambert_direction(vec3 n, rng *g) {
    vec3 v;
    do v = add(n, unit_vector(g));
    while (!(dot(v, v) > (real)1e-6 && dot(v, n) > 0));
    return normalize(v);
}

static color other_path(const room *sc, ray r, int s, rng *g) {
    color C = {1, 1, 1}, L = {0, 0, 0};
    for (;; s--) {
        int body = 0;
        const hit h = scene_nearest(&sc->bodies, r, 0, NO_HIT, &body);
        if (h.t == NO_HIT) return add(L, mul(C, sky_light(&sc->bodies, r.d)));
        const matte *m = &sc->surfaces[body];
        L = add(L, mul(C, emitted(m, h)));
        C = mul(C, m->albedo);
        if (s == 0 || (C.x == 0 && C.y == 0 && C.z == 0)) return L;
        const vec3 n = h.front ? h.n : neg(h.n);
        r = (ray){offset_origin(h.p, h.error, n, n), lambert_direction(n, g)};
    }
}

static void check_two_means(int line, const running *mine, const running *other,
                            const char *colour) {
    char call[80];
    snprintf(call, sizeof call, "path_trace(&sc, r, 60, &g), mean of %s", colour);
    const double error = hypot(running_standard_error(mine), running_standard_error(other));
    check_real(__FILE__, line, call, mine->mean, other->mean, standard_errors(5, error));
}

// The light of the box in eight pixels, by both.
static void path_box(void) {
    rng g = check_rng(30);
    const room sc = {box_bodies, box_surfaces};
    const camera cam = box_camera(100, 100);
    const real pixels[][2] = {{20, 50}, {50, 92}, {85, 40}, {50, 40},
                              {50, 4},  {33, 64}, {70, 78}, {33, 85}};
    for (int i = 0; i < COUNT(pixels); i++) {
        const ray r = camera_ray(&cam, pixels[i][0], pixels[i][1]);
        given("the box in 100 x 100 pixels, at (%g, %g): the mean of 40,000 paths, against "
              "20,000 by other means",
              (double)pixels[i][0], (double)pixels[i][1]);
        const light mine = paths(path_trace, &sc, r, 60, 40000, &g);
        const light other = paths(other_path, &sc, r, 60, 20000, &g);
        check_finite(__LINE__, &mine);
        check_two_means(__LINE__, &mine.red, &other.red, "red");
        check_two_means(__LINE__, &mine.green, &other.green, "green");
        check_two_means(__LINE__, &mine.blue, &other.blue, "blue");
    }
}

static color box_light(const void *data, ray r, rng *g) {
    return path_trace(data, r, 20, g);
}

static void path_threads(void) {
    const room sc = {box_bodies, box_surfaces};
    const camera cam = box_camera(31, 23);
    const options opt = {.samples = 8, .seed = 77};
    given("the box with 1 thread");
    threads(1);
    image one = render("test", &cam, box_light, &sc, &opt);
    for (int n = 2; n <= 4; n++) {
        threads(n);
        given("the box with 1 and with %d threads", n);
        image several = render("test", &cam, box_light, &sc, &opt);
        CHECK(same_pixels(one, several),
              "the same picture, bit for bit: all random numbers come from g");
        image_free(&several);
    }
    image_free(&one);
}

// ---- roulette --------------------------------------------------------------------------------

static const real chances[] = {(real)0.05, (real)0.3, (real)0.5, (real)0.9, (real)0.95};

static void roulette_values(void) {
    rng g = check_rng(40);
    for (int i = 0; i < 10000; i++) {
        const real q = i < 5 ? chances[i] : rng_real(&g);
        given("q = %.9g", (double)q);
        const real weight = roulette(q, &g);
        given("q = %.9g: roulette gives %.9g", (double)q, (double)weight);
        suspect_value("1: it goes on, but is not divided by q", 1);
        suspect_value("1/(1-q)", 1 / (1 - (double)q));
        suspect_value("q: multiplied in place of divided", (double)q);
        if (weight != 0) CHECK_REAL(weight, 1 / (double)q, roundings(2, "one division"));
    }
}

static void roulette_mean(void) {
    rng g = check_rng(41);
    for (int i = 0; i < COUNT(chances); i++) {
        const double q = (double)chances[i];
        running weight = {0}, alive = {0};
        given("q = %g, 200,000 times: the share that goes on", q);
        for (int k = 0; k < 200000; k++) {
            const real w = roulette(chances[i], &g);
            running_add(&weight, (double)w);
            running_add(&alive, w > 0);
        }
        const double share_that_goes_on = alive.mean, mean_weight = weight.mean;
        suspect_value("1 - q: it ends with the probability q", 1 - q);
        suspect_value("all go on", 1);
        suspect_value("none goes on", 0);
        CHECK_REAL(share_that_goes_on, q, standard_errors(5, sqrt(q * (1 - q) / 200000)));
        given("q = %g, 200,000 times: the mean of what roulette gives", q);
        suspect_value("not divided by q: the light of those that end is lost", q);
        suspect_value("divided by 1 - q", q / (1 - q));
        CHECK_REAL(mean_weight, 1, standard_errors(5, sqrt((1 - q) / q / 200000)));
    }
}

static void roulette_from_g(void) {
    for (int i = 0; i < 200; i++) {
        rng one = rng_seed(1, (uint64_t)i), other = one;
        const vec3 first = {roulette((real)0.5, &one), 0, 0},
                   second = {roulette((real)0.5, &other), 0, 0};
        given("q = 0.5 (the weights as x), " ASKED_TWICE, ARG(first), ARG(second));
        check_from_g(first, second);
    }
}

// A path that goes on with q has 1/(1-q) segments in the mean, with the variance
// q/(1-q)².
static void roulette_length(void) {
    rng g = check_rng(42);
    for (int i = 0; i < COUNT(chances); i++) {
        const double q = (double)chances[i];
        running segments = {0};
        given("q = %g: the mean number of segments of 50,000 paths", q);
        for (int k = 0; k < 50000; k++) {
            int n = 1;
            while (n < 10000 && roulette(chances[i], &g) > 0) n++;
            running_add(&segments, n);
        }
        const double variance = q / ((1 - q) * (1 - q));
        // The fourth central moment of a geometric number over its variance squared
        // is 9 + 1/variance.
        const double error_of_variance = variance * sqrt((8 + 1 / variance) / 50000);
        const double mean_length = segments.mean,
                     variance_of_length = running_variance(&segments);
        suspect_value("1/q: it goes on with 1 - q", 1 / q);
        CHECK_REAL(mean_length, 1 / (1 - q), standard_errors(5, sqrt(variance / 50000)));
        given("q = %g: the variance of the number of segments, over 50,000 paths", q);
        CHECK_REAL(variance_of_length, variance, standard_errors(6, error_of_variance));
    }
}

// A generator whose next number is 0, the smallest that rng_real gives.
static void roulette_certain(void) {
    static const char chance[] = "q is the chance to go on. Is 1/q worked out only then?";
    rng g = check_rng(43), zero = {0, 1};
    given("q = 0, and rng_real gives exactly 0, as it may: once in 16 million");
    suspect_value("1/0: is the random number compared by < ?", (double)INFINITY);
    CHECK_REAL(roulette(0, &zero), 0, exactly());
    for (int i = 0; i < 100000; i++) {
        given("q = 1: always goes on, with the weight 1");
        hint_instead(chance);
        CHECK_REAL(roulette(1, &g), 1, exactly());
        given("q = 0: never goes on");
        hint_instead(chance);
        CHECK_REAL(roulette(0, &g), 0, exactly());
    }
}

// ---- furnace_test ----------------------------------------------------------------------------
// Tracers that are right or wrong in a known way, made without the exercises.

typedef enum {
    RIGHT,
    ROULETTE, // right, with more spread
    SLIDE,
    TWICE,
    NO_COSINE,
    SQUARED,
    EMITS_TWICE,
    EMITS_NOT,
    DIM, // 3 % of the reflected light is missing
    RED, // right in red, else black
} habit;

static vec3 upwards(vec3 n, rng *g) {
    const vec3 v = unit_vector(g);
    return dot(v, n) < 0 ? neg(v) : v;
}

static real weight_of(habit which, vec3 d, vec3 n, vec3 v, rng *g) {
    const real cosine = 2 * dot(n, v);
    switch (which) {
    case SLIDE:
        return 2 * dot(normalize(d), v);
    case TWICE:
        return 2 * cosine;
    case NO_COSINE:
        return 2;
    case DIM:
        return (real)0.97 * cosine;
    case ROULETTE:
        return rng_real(g) < (real)0.25 ? 4 * cosine : 0;
    default:
        return cosine;
    }
}

static color walk(habit which, const room *sc, ray r, int s, rng *g) {
    int body = 0;
    const hit h = scene_nearest(&sc->bodies, r, 0, NO_HIT, &body);
    if (h.t == NO_HIT) return sky_light(&sc->bodies, r.d);
    const matte *m = &sc->surfaces[body];
    const color L_e = emitted(m, h), e = scale(which == EMITS_TWICE ? 2 : 1, L_e);
    if (s == 0) return e;
    const vec3 n = h.front ? h.n : neg(h.n), v = upwards(n, g);
    const ray next = {offset_origin(h.p, h.error, n, n), v};
    const color rho = which == SQUARED ? mul(m->albedo, m->albedo) : m->albedo;
    const real w = weight_of(which, r.d, n, v, g);
    const color L = scale(w, mul(rho, walk(which, sc, next, s - 1, g)));
    const color all = which == EMITS_NOT ? L : add(e, L);
    return which == RED ? (color){all.x, 0, 0} : all;
}

#define TRACER(name, which)                                   \
    static color name(const room *sc, ray r, int s, rng *g) { \
        return walk(which, sc, r, s, g);                      \
    }
TRACER(right, RIGHT)
TRACER(right_with_roulette, ROULETTE)
TRACER(by_the_slide, SLIDE)
TRACER(twice, TWICE)
TRACER(without_cosine, NO_COSINE)
TRACER(squared, SQUARED)
TRACER(emits_twice, EMITS_TWICE)
TRACER(emits_not, EMITS_NOT)
TRACER(dim, DIM)
TRACER(only_red, RED)

// Right in the mean, each colour with a noise of its own.
static real noise(rng *g) {
    return rng_bits(g) & 1 ? (real)0.5 : (real)-0.5;
}

static color right_in_colours(const room *sc, ray r, int s, rng *g) {
    const color L = right(sc, r, s, g);
    const real x = noise(g), y = noise(g), z = noise(g);
    return add(L, (color){x, y, z});
}

static color black(const room *sc, ray r, int s, rng *g) {
    (void)sc, (void)r, (void)s, (void)g;
    return (color){0, 0, 0};
}

static color only_sky(const room *sc, ray r, int s, rng *g) {
    (void)s, (void)g;
    return sky_light(&sc->bodies, r.d);
}

static color now_and_then_nan(const room *sc, ray r, int s, rng *g) {
    const color L = right(sc, r, s, g);
    return rng_bits(g) % 256 == 0 ? (color){(real)NAN, (real)NAN, (real)NAN} : L;
}

// Exact, but for a last digit that goes up or down.
static color exact_within_rounding(const room *sc, ray r, int s, rng *g) {
    const color L = other_path(sc, r, s, g);
    return rng_bits(g) % 4 ? L : scale(1 + REAL_EPSILON, L);
}

// Exact, but too bright or too dark by 1 in 10,000.
static color a_little_bright(const room *sc, ray r, int s, rng *g) {
    return scale((real)1.0001, other_path(sc, r, s, g));
}

static color a_little_dark(const room *sc, ray r, int s, rng *g) {
    return scale((real)0.9999, other_path(sc, r, s, g));
}

// Looks at what it is sent through: the furnace itself.
static struct { long paths, missed, inside, emitting, short_ones, odd_sky; } seen;

static color look_around(const room *sc, ray r, int s, rng *g) {
    int body = 0;
    const hit h = scene_nearest(&sc->bodies, r, 0, NO_HIT, &body);
    const color sky = sky_light(&sc->bodies, generic_unit(g));
    seen.paths++;
    seen.missed += h.t == NO_HIT;
    seen.inside += h.t != NO_HIT && !h.front;
    seen.short_ones += s < 1;
    seen.odd_sky += !(sky.x == 1 && sky.y == 1 && sky.z == 1);
    if (h.t != NO_HIT) seen.emitting += sc->surfaces[body].emittance.x == 1;
    return right(sc, r, s, g);
}

// What to say where the test "the furnace itself" fails, too.
static const char *mend_first(void) {
    rng g = check_rng(55);
    memset(&seen, 0, sizeof seen);
    furnace_test(look_around, (real)0.4, 500, &g);
    const bool sound = seen.paths == 500 && seen.emitting == 500 &&
                       !(seen.missed || seen.inside || seen.short_ones || seen.odd_sky);
    return sound ? "" : " (mend the test \"the furnace itself\" first)";
}

// z of a furnace test, and given() to go with it.
static double tested(const char *who, path_tracer f, double albedo, long n, rng *g) {
    static const char *first;
    given("%s, albedo %g, %ld paths", who, albedo, n);
    if (!first) first = mend_first();
    const double z = furnace_test(f, (real)albedo, n, g);
    given("%s, albedo %g, %ld paths: z = %g%s", who, albedo, n, z, first);
    return z;
}

static void accepts_right(void) {
    rng g = check_rng(50);
    static const struct {
        const char *name;
        path_tracer f;
    } tracers[] = {
        {"a right tracer", right},
        {"a right tracer with roulette, whose samples spread more", right_with_roulette}};
    const double albedos[] = {0.2, 0.5, 0.9, 1};
    for (int i = 0; i < COUNT(tracers) * COUNT(albedos); i++) {
        const int which = i % COUNT(tracers);
        const double z = tested(tracers[which].name, tracers[which].f,
                                albedos[i / COUNT(tracers)], 20000, &g);
        CHECK(!isinf(z), "these samples differ, so their mean has a standard error: does every "
                         "ray meet the ball, and may it bounce?");
        CHECK(fabs(z) < 5,
              "a right tracer is less than 5 standard errors off (it fails once in "
              "1.7 million)");
    }
}

static void suspect_no_spread(void) {
    const char *what = "a mean that is off, without any spread: is the truth 1 + albedo, are a "
                       "few roundings forgiven, and does every ray meet the ball?";
    suspect_value(what, (double)INFINITY);
    suspect_value(what, -(double)INFINITY);
}

static void accepts_exact(void) {
    rng g = check_rng(51);
    const real albedos[] = {0, (real)0.1, (real)0.7, 1};
    for (int i = 0; i < COUNT(albedos); i++) {
        const real a = albedos[i];
        given("a tracer whose samples are all 1 + albedo, albedo %g, 1000 paths", (double)a);
        suspect_no_spread();
        CHECK_REAL(furnace_test(other_path, a, 1000, &g), 0, exactly());
        given("a tracer whose samples are 1 + albedo but for the last digit, albedo %g",
              (double)a);
        suspect_no_spread();
        CHECK_REAL(furnace_test(exact_within_rounding, a, 1000, &g), 0, exactly());
    }
}

static void rejects_wrong(void) {
    rng g = check_rng(52);
    static const struct {
        const char *name;
        path_tracer f;
        int sign; // of what it brings too much
    } tracers[] = {
        {"the slide's tracer, with dot(d, v)", by_the_slide, -1},
        {"a tracer that reflects twice too much", twice, 1},
        {"a tracer without the cosine", without_cosine, 1},
        {"a tracer with the albedo squared", squared, -1},
        {"a tracer that counts emission twice", emits_twice, 1},
        {"a tracer without emission", emits_not, -1},
        {"a tracer that loses 3 % of the reflected light", dim, -1},
        {"a tracer that is black", black, -1},
        {"a tracer that sees only the sky", only_sky, -1},
        {"a tracer whose samples are all too bright by 1 in 10,000", a_little_bright, 1},
        {"a tracer whose samples are all too dark by 1 in 10,000", a_little_dark, -1},
        {"a tracer that is right in red, and black in green and blue", only_red, -1},
    };
    for (int i = 0; i < COUNT(tracers); i++) {
        const double z = tested(tracers[i].name, tracers[i].f, 0.6, 40000, &g);
        const bool sign_of_z_is_right = (z > 0) == (tracers[i].sign > 0);
        if (tracers[i].f == only_red)
            suspect_slip("red alone: is the mean of all three taken?");
        if (tracers[i].f == a_little_bright || tracers[i].f == a_little_dark)
            suspect_slip("more is forgiven than a few roundings");
        CHECK(!isnan(z), "z is a number: a wrong mean without spread is infinitely far off");
        CHECK(fabs(z) > 5, "a wrong tracer is more than 5 standard errors off");
        CHECK(sign_of_z_is_right,
              tracers[i].sign > 0
                  ? "too bright: z > 0. Is it mean - truth, with the truth 1 + albedo?"
                  : "too dark: z < 0. Is it mean - truth, with the truth 1 + albedo?");
    }
}

static void rejects_nan(void) {
    rng g = check_rng(53);
    const double z = tested("a tracer that is right, but for a NaN now and then",
                            now_and_then_nan, 0.6, 20000, &g);
    CHECK(!(fabs(z) < 5), "NaN must not pass for right");
}

// What a sound z of a right tracer is: mean 0, variance 1 (for 300 paths 299/297).
enum { SOUND_PATHS = 300 };

static void suspect_deviations(double variance_of_z) {
    const double spread = 0.25 / 3; // the variance of one path: uniform from 1 to 1 + 2a
    const double deviation = 1.0 / SOUND_PATHS;
    suspect_about("divided by the standard deviation of one path, not by the standard error "
                  "of the mean",
                  variance_of_z, deviation, 0.2 * deviation);
    suspect_about("divided by the variance in place of a standard error", variance_of_z,
                  deviation / spread, 0.2 * deviation / spread);
    suspect_about("divided by variance / n: its root is missing", variance_of_z,
                  SOUND_PATHS / spread, 0.2 * SOUND_PATHS / spread);
    suspect_about("three paths of each: its colours are not independent, so they count once",
                  variance_of_z, 3, 0.5);
}

static void check_sound(const char *who, path_tracer f, int runs, rng *g) {
    running z = {0};
    long z_exactly_0 = 0;
    for (int i = 0; i < runs; i++) {
        const double one = tested(who, f, 0.5, SOUND_PATHS, g);
        CHECK(isfinite(one), "these samples differ, so their mean has a standard error: does "
                             "every ray meet the ball, and may it bounce?");
        running_add(&z, one);
        z_exactly_0 += one == 0;
    }
    const double mean_of_z = z.mean, variance_of_z = running_variance(&z);
    given("%s, %d furnace tests of %d paths: the mean of their z", who, runs, SOUND_PATHS);
    if (fabs(mean_of_z) > 5) suspect_value("the truth is another than 1 + albedo", mean_of_z);
    suspect_about("|z|: without its sign", mean_of_z, sqrt(2 / PI), 0.1);
    CHECK_REAL(mean_of_z, 0, standard_errors(5, running_standard_error(&z)));
    given("%s, %d furnace tests of n = %d paths: the variance of their z, which is "
          "(n - 1)/(n - 3), nearly 1, as the standard error is measured, too (Student's t)",
          who, runs, SOUND_PATHS);
    suspect_deviations(variance_of_z);
    CHECK_REAL(variance_of_z, (SOUND_PATHS - 1.0) / (SOUND_PATHS - 3.0),
               standard_errors(5, sqrt(2.0 / runs)));
    given("%s, %d furnace tests of %d paths: how many of their z are exactly 0", who, runs,
          SOUND_PATHS);
    suspect_value("more is forgiven than a few roundings", (double)z_exactly_0);
    CHECK_AT_MOST(z_exactly_0, 10, "a few roundings are hit by chance once in 10,000 times");
}

static void sound_z(void) {
    rng g = check_rng(54);
    check_sound("a right tracer", right, 3000, &g);
}

static void sound_z_of_colours(void) {
    rng g = check_rng(56);
    check_sound("a right tracer whose three colours are noisy each by itself", right_in_colours,
                1000, &g);
}

static void the_furnace(void) {
    rng g = check_rng(55);
    memset(&seen, 0, sizeof seen);
    given("furnace_test(f, 0.4, 5000, g)");
    const double z = furnace_test(look_around, (real)0.4, 5000, &g);
    given("furnace_test(f, 0.4, 5000, g), z = %g: f was called %ld times, %ld rays missed the "
          "ball, %ld met it from inside, %ld met a ball that shines with 1, %ld had s < 1",
          z, seen.paths, seen.missed, seen.inside, seen.emitting, seen.short_ones);
    const long calls_of_f = seen.paths, rays_that_missed = seen.missed,
               rays_from_inside = seen.inside, paths_without_bounce = seen.short_ones,
               other_skies = seen.odd_sky, balls_that_do_not_shine = seen.paths - seen.emitting;
    CHECK_INT(calls_of_f, 5000);
    CHECK(rays_that_missed == 0, "every ray meets the ball: aim at a point inside it");
    CHECK(rays_from_inside == 0, "every ray starts outside the ball: inside it neither the "
                                 "front's emission nor the sky is seen");
    CHECK(paths_without_bounce == 0, "every path may bounce: s >= 1");
    CHECK(other_skies == 0, "the sky is 1 in every direction");
    CHECK(balls_that_do_not_shine == 0, "the ball shines with the radiance 1");
}

// ---- what is given ---------------------------------------------------------------------------

static void emitted_front(void) {
    const matte m = {tint, {3, 2, 1}};
    CHECK_VEC3(emitted(&m, (hit){.front = true}), m.emittance, exactly());
    CHECK_VEC3(emitted(&m, (hit){.front = false}), ((vec3){0, 0, 0}), exactly());
}

static void survival_rule(void) {
    rng g = check_rng(60);
    for (int i = 0; i < 10000; i++) {
        const color C = scale(2, absolute(in_cube(&g)));
        const real most = fmax(C.x, fmax(C.y, C.z)), q = survival(C, i % 8);
        given("C = " VEC ", bounce %d", ARG(C), i % 8);
        if (i % 8 < 3) CHECK_REAL(q, 1, exactly());
        if (i % 8 >= 3) CHECK_REAL(q, fmin(most, (real)0.95), exactly());
        CHECK_REAL(survival((color){0, 0, 0}, i % 8), 0, exactly());
    }
}

// By the slide a ball of albedo 0.5, seen at the angle θ, has the mean -0.5 cos θ: the mean
// of v is n/2, and d·n = -cos θ.
static void slide_slip(void) {
    rng g = check_rng(61);
    const double degrees[] = {45, 0, 60, 80};
    for (int i = 0; i < COUNT(degrees); i++) {
        const frame F = some_frame(1, 1, &g);
        lone_ball b;
        lone_ball_at(&b, &F, (matte){.albedo = GREY(0.5)});
        const double theta = degrees[i] * PI / 180;
        given("the slide's bounce_ray, albedo 0.5 in a sky of 1, seen at %g degrees",
              degrees[i]);
        const light all =
            paths(trace_ray_slide, &b.sc, arriving_at(&F, theta, 3), 1, 40000, &g);
        const double mean_of_red = all.red.mean;
        CHECK_REAL(mean_of_red, -0.5 * cos(theta),
                   standard_errors(5, running_standard_error(&all.red)));
    }
}

static void box_numbers(void) {
    const vec3 eye = {(real)0.1, (real)1.1, (real)1.3};
    const vec3 aims[BOX_BODIES] = {
        [BALL_LEFT] = {(real)-0.45, (real)0.42, (real)-0.4},
        [BALL_RIGHT] = {(real)0.47, (real)0.34, (real)0.25},
        [WALL_LEFT] = {-1, 1, 0},
        [WALL_RIGHT] = {1, (real)1.2, 0},
        [WALL_FLOOR] = {0, 0, (real)1.1},
        [WALL_CEILING] = {(real)0.8, 2, 1},
        [WALL_BACK] = {0, (real)1.5, -1},
        [WALL_FRONT] = {0, 1, (real)3.6},
        [LAMP] = {(real)0.1, (real)1.98, 0},
    };
    for (int i = 0; i < BOX_BODIES; i++) {
        int body = -1;
        const ray r = {eye, sub(aims[i], eye)};
        const hit h = scene_nearest(&box_bodies, r, 0, NO_HIT, &body);
        given("from " VEC " towards " VEC, ARG(eye), ARG(aims[i]));
        CHECK_INT(body, i);
        CHECK(h.front, "every body of the box is seen from its front");
    }
}

static void box_closed(void) {
    rng g = check_rng(62);
    for (int i = 0; i < 50000; i++) {
        const vec3 O = {between(&g, -1, 1), between(&g, 0, 2), between(&g, -1, (real)3.6)};
        int body = -1;
        const ray r = {O, generic_unit(&g)};
        given("in the box from " VEC " along " VEC, ARG(r.O), ARG(r.d));
        CHECK(scene_nearest(&box_bodies, r, 0, NO_HIT, &body).t != NO_HIT,
              "no ray leaves the box");
    }
}

int main(void) {
    static const char *const uniform =
        "As likely in every direction above the surface: which of the given directions are "
        "uniform already, and what is to be done with those below?";
    static const char *const equation =
        "L_e + f_r L_i (n·v) / probability: write down each of the five, with its π.";
    static const char *const from_g =
        "Whatever is drawn comes from g, and nothing is kept for the next call.";
    static const char *const facing = "n points to the side that r came from; h.front says.";
    static const char *const ends = "s bounces are left for this hit: none for s = 0, else "
                                    "s - 1 for the next.";
    static const char *const loop =
        "C is what the path still lets through, L what it has collected: in which order?";
    static const char *const honest = "Those that go on carry the light of those that end.";
    static const char *const sound = "Once \"the furnace itself\" passes: z = (mean - truth) / "
                                     "standard error of the mean. What "
                                     "is the truth here?";
    static const test tests[] = {
        {"hemisphere_direction: another direction every time", direction_differs,
         "Its random numbers come from g, and g must be the caller's."},
        {"hemisphere_direction: the same g, the same draw", direction_from_g, from_g},
        {"hemisphere_direction: unit vectors above the surface", direction_unit, uniform},
        {"hemisphere_direction: the mean cosine is 1/2", direction_mean, uniform},
        {"hemisphere_direction: chi² against 1/(2π)", direction_cells,
         "Some directions come more often than others: what shape are the random points taken "
         "from?"},
        {"hemisphere_direction: the variance of what it samples", direction_variance, uniform},
        {"bounce_ray: a ball in a furnace", bounce_furnace, equation},
        {"bounce_ray: a ball that shines", bounce_shining, "L_e counts once, unfiltered."},
        {"bounce_ray: a wall from both sides", bounce_sides, facing},
        {"bounce_ray: a closed room, cut after s bounces", bounce_cavity, ends},
        {"bounce_ray: lamps with closed forms", bounce_lamps, equation},
        {"bounce_ray: no acne, from 1e-6 to 1e6", bounce_acne, "offset_origin of chapter 06."},
        {"bounce_ray: 40,000 odd paths", bounce_odd, "No cosine here is negative."},
        {"roulette: 0 or 1/q", roulette_values, honest},
        {"roulette: goes on with probability q, and the mean is 1", roulette_mean, honest},
        {"roulette: the same g, the same weight", roulette_from_g, from_g},
        {"roulette: the length of paths", roulette_length, honest},
        {"roulette: q = 0 and q = 1", roulette_certain,
         "rng_real gives 0 now and then, and never 1: < or <= ?"},
        {"path_trace: a ball in a furnace", path_furnace,
         "At each bounce C is multiplied by rho/π (n·v) / (1/(2π)); a miss adds C times the "
         "sky."},
        {"path_trace: a ball that shines", path_shining, loop},
        {"path_trace: a wall from both sides", path_sides, facing},
        {"path_trace: a closed room, cut after s bounces", path_cavity,
         "At each hit first L collects, also at the last; then bounce == s ends the path; "
         "then C is coloured."},
        {"path_trace: ends by roulette", path_ends,
         "After each bounce: roulette(survival(C, bounce), g), and 0 ends the path."},
        {"path_trace: a closed room, to the end", path_cavity_deep,
         "C must be scaled by what roulette gives, or those that go on carry too little."},
        {"path_trace: as far as s and roulette allow", path_long,
         "A path that meets a wall goes on unless bounce == s or roulette gives 0."},
        {"path_trace: lamps with closed forms", path_lamps, loop},
        {"path_trace: no acne, from 1e-6 to 1e6", path_acne, "offset_origin of chapter 06."},
        {"path_trace: 40,000 odd paths", path_odd, "No cosine here is negative."},
        {"path_trace: the box, against other means", path_box, loop},
        {"path_trace: the same picture with any number of threads", path_threads,
         "All random numbers come from g; nothing is kept from path to path."},
        {"furnace_test: the furnace itself", the_furnace,
         "A ball of this albedo that shines with 1, in a sky of 1, met by every ray from "
         "outside."},
        {"furnace_test: accepts right tracers", accepts_right, sound},
        {"furnace_test: accepts an exact tracer", accepts_exact,
         "No spread and no error but a few roundings: nothing is wrong, and z is 0."},
        {"furnace_test: rejects wrong tracers", rejects_wrong, sound},
        {"furnace_test: rejects NaN", rejects_nan, "Which comparison does NaN pass?"},
        {"furnace_test: z has mean 0 and variance 1", sound_z, sound},
        {"furnace_test: three colours with a noise each", sound_z_of_colours,
         "One value a path: the mean of its three colours."},
        {"emitted: the front only", emitted_front, "Given code: did it change?"},
        {"survival: by C's largest component", survival_rule, "Given code: did it change?"},
        {"trace_ray_slide: the slide's slip", slide_slip, "Given code: did it change?"},
        {"box_bodies: numbered as box.h says", box_numbers, "Given code: did it change?"},
        {"box_bodies: closed", box_closed, "Given code: did it change?"},
    };
    return run_tests("09-path-tracer", tests, COUNT(tests));
}
