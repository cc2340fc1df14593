// Tests of 06-bounce: the mirror, fuzzy and matte bounces, the loop, and where
// the next ray starts.
#include "chapters/06-bounce/bounce.h"
#include "common/exact3.h"
#include "common/wide3.h"
#include "tests/check-directions.h"
#include "tests/check.h"

// A unit direction, half of the time anywhere, else grazing: cosines from 1e-6.
static vec3 some_direction(vec3 n, rng *g) {
    const vec3 v = generic_unit(g);
    if (rng_bits(g) & 1) return dot(v, n) < 0 ? neg(v) : v;
    const vec3 along = normalize(sub(v, scale(dot(v, n), n)));
    const real slope = (real)pow(10, (double)between(g, -6, -1));
    return normalize(add(along, scale(slope, n)));
}

// One that leaves the surface with normal n. Within a few roundings of the surface
// float cannot tell the sides: those are drawn again.
static vec3 next_direction(vec3 n, rng *g) {
    for (;;) {
        const vec3 d = some_direction(n, g);
        if (wide_dot(widen(d), widen(n)) > 4 * (double)REAL_EPSILON) return d;
    }
}

// ---- reflect ---------------------------------------------------------------------

static void mirror_by_hand(void) {
    // d·n = (3 - 2 + 4)/3 = 5/3, so r = d - (10/9) (1, 2, 2).
    const vec3 d = {3, -1, 2}, n = scale((real)1 / 3, (vec3){1, 2, 2});
    const real k = (real)5 / 9;
    given("d = (3, -1, 2), n = (1, 2, 2)/3, so d·n = 5/3");
    suspect_vec3("d + 2 (d·n) n: the sign, or |d·n| in place of d·n",
                 add(d, scale(2 * k, (vec3){1, 2, 2})));
    suspect_vec3("d - (d·n) n: it slides along the surface; the 2 is missing",
                 sub(d, scale(k, (vec3){1, 2, 2})));
    suspect_vec3("2 (d·n) n - d: it goes back, since d points towards the surface",
                 sub(scale(2 * k, (vec3){1, 2, 2}), d));
    suspect_vec3("-d: all of d was turned round, not only its part along n", neg(d));
    CHECK_VEC3(reflect(d, n), ((vec3){(real)17 / 9, (real)-29 / 9, (real)-2 / 9}),
               roundings(8, "two dot products' worth"));
}

// d less twice its part along n, in higher precision and for n of any length.
static vec3 mirrored_wide(vec3 d, vec3 n) {
    const wide3 D = widen(d), N = widen(n);
    const double k = 2 * wide_dot(D, N) / wide_dot(N, N);
    return narrow((wide3){D.x - k * N.x, D.y - k * N.y, D.z - k * N.z});
}

// From in front and from behind by turns.
static void mirror_generic(void) {
    rng g = rng_seed(6, 1);
    for (int i = 0; i < 2000; i++) {
        const vec3 n = generic_unit(&g), v = scale((real)pow(10, i % 7 - 3), in_cube(&g));
        const bool behind = i % 2;
        const vec3 d = (dot(v, n) > 0) == behind ? v : neg(v);
        const vec3 along = scale(dot(d, n), n);
        given("d = " VEC ", n = " VEC ", so d·n = %.6g", ARG(d), ARG(n), (double)dot(d, n));
        suspect_vec3(behind ? "d + 2 |d·n| n: right only where d·n < 0"
                            : "d + 2 (d·n) n: the sign",
                     add(d, scale(2, along)));
        suspect_vec3("d - (d·n) n: the 2 is missing", sub(d, along));
        suspect_vec3("2 (d·n) n - d: it goes back", sub(scale(2, along), d));
        suspect_vec3("-d: all of d was turned round, not only its part along n", neg(d));
        CHECK_VEC3(reflect(d, n), mirrored_wide(d, n),
                   absolute_of(16 * REAL_EPSILON * wide_length(d),
                               "n's length is 1 only within a few roundings, and the formula "
                               "makes up to four times as much of them"));
    }
}

static void mirror_sides(void) {
    rng g = rng_seed(6, 2);
    for (int i = 0; i < 200; i++) {
        const vec3 n = generic_unit(&g), d = in_cube(&g);
        given("d = " VEC ", and the normal " VEC " turned round", ARG(d), ARG(n));
        CHECK_VEC3(reflect(d, neg(n)), reflect(d, n), exactly());
        given("d = " VEC ", n = " VEC ": mirrored twice", ARG(d), ARG(n));
        CHECK_VEC3(reflect(reflect(d, n), n), d,
                   roundings(64,
                             "n's length is 1 within a few roundings; two mirrors make up to "
                             "eight times as much of them"));
    }
}

// ---- keep_unit -------------------------------------------------------------------

static void unit_again(void) {
    const double off[] = {0, 1e-7, -1e-7, 3e-5, -3e-5, 1e-3, -1e-3, 0.1, -0.5, 1, 639, 1e15};
    rng g = rng_seed(6, 3);
    for (int i = 0; i < 100 * COUNT(off); i++) {
        const double size = 1 + off[i % COUNT(off)];
        const vec3 u = generic_unit(&g), d = scale((real)size, u);
        given("d = " VEC ", of length %.9g", ARG(d), size);
        suspect_vec3("d itself: nothing was done", d);
        suspect_vec3("d (3 - |d|²): the half is missing", scale((real)(3 - size * size), u));
        suspect_vec3("one Newton step, from a guess that was far off",
                     scale((real)(size * (3 - size * size) / 2), u));
        suspect_vec3("d (2 - |d|²): the step for 1/|d|², not 1/|d|: it only swaps too long "
                     "and too short",
                     scale((real)(size * (2 - size * size)), u));
        CHECK_VEC3(keep_unit(d), u, roundings(10, "two unit vectors, each rounded"));
        CHECK_REAL(wide_length(keep_unit(d)), 1, roundings(6, "a sum, a root, a quotient"));
    }
}

static void million_mirrors(void) {
    rng g = rng_seed(6, 4);
    vec3 d = generic_unit(&g);
    for (int i = 0; i < 1000000; i++) {
        vec3 n = unit_vector(&g);
        n = scale((real)1.0001, n);
        d = keep_unit(reflect(d, n));
    }
    given("1,000,000 times keep_unit(reflect(d, n)), |n| = 1.0001");
    CHECK_REAL(wide_length(d), 1,
               absolute_of(1.7 * REAL_EPSILON, "the last step's own roundings: 2e-7 in float"));
}

// ---- fuzzy_bounce ----------------------------------------------------------------

static void fuzz_none(void) {
    rng g = rng_seed(6, 5);
    for (int i = 0; i < 500; i++) {
        const vec3 n = generic_unit(&g);
        vec3 d = scale(between(&g, (real)0.1, 9), generic_unit(&g));
        if (dot(d, n) > 0) d = neg(d);
        given("fuzz = 0: a mirror. d = " VEC ", n = " VEC, ARG(d), ARG(n));
        CHECK_VEC3(fuzzy_bounce(d, n, 0, &g), normalize(reflect(d, n)),
                   roundings(16, "a mirror and two unit vectors"));
    }
}

// A direction of length `size` that meets the surface at the cosine `cosine`.
static vec3 arriving(vec3 n, real cosine, real size) {
    const vec3 along = perpendicular(n);
    return scale(size, sub(scale(sqrt(1 - cosine * cosine), along), scale(cosine, n)));
}

static void fuzz_above(void) {
    rng g = rng_seed(6, 6);
    for (int i = 0; i < 100000; i++) {
        const vec3 n = generic_unit(&g);
        const real cosine = (real)pow(10, (double)between(&g, -4, 0)), fuzz = rng_real(&g);
        const vec3 d = arriving(n, cosine, 2);
        const vec3 v = fuzzy_bounce(d, n, i % 5 ? fuzz : 1, &g);
        given("d = " VEC ", n = " VEC ", cos θ = %.3g, fuzz = %.3g: the bounce is " VEC, ARG(d),
              ARG(n), (double)cosine, i % 5 ? (double)fuzz : 1.0, ARG(v));
        CHECK_REAL(wide_length(v), 1, roundings(10, "a unit vector"));
        CHECK(dot(v, n) > 0, "the bounce leaves the surface: result·n > 0");
    }
}

// fuzz = 0 and an angle so grazing that rounding puts the mirrored ray anywhere.
static void fuzz_grazing(void) {
    rng g = rng_seed(6, 7);
    for (int i = 0; i < 5000; i++) {
        const vec3 n = generic_unit(&g);
        vec3 d = arriving(n, REAL_EPSILON * (real)pow(10, (double)between(&g, -2, 1)), 1);
        if (!(dot(d, n) < 0)) continue;
        given("fuzz = 0, every draw is the same; d = " VEC ", n = " VEC, ARG(d), ARG(n));
        const vec3 v = fuzzy_bounce(d, n, 0, &g);
        given("fuzz = 0, d = " VEC ", n = " VEC ": the bounce is " VEC, ARG(d), ARG(n), ARG(v));
        CHECK(dot(v, n) > 0, "the bounce leaves the surface: result·n > 0");
    }
}

// While fuzz < cos θ nothing falls below the surface, and the mean is known: the
// mean of x/|x| over a sphere of radius f about a unit vector is 1 - f²/3 of it.
static void fuzz_mean(void) {
    const real fuzzes[] = {(real)0.2, (real)0.6};
    rng g = rng_seed(6, 8);
    for (int k = 0; k < COUNT(fuzzes); k++) {
        const vec3 n = generic_unit(&g), d = arriving(n, (real)0.7, 3);
        const vec3 mirrored = normalize(reflect(d, n)), across = perpendicular(mirrored);
        running along = {0}, aside = {0};
        for (int i = 0; i < 200000; i++) {
            const vec3 v = fuzzy_bounce(d, n, fuzzes[k], &g);
            running_add(&along, wide_dot(widen(v), widen(mirrored)));
            running_add(&aside, wide_dot(widen(v), widen(across)));
        }
        const double f = fuzzes[k];
        given("d = " VEC ", n = " VEC ", fuzz = %g, 200,000 bounces: the mean component along "
              "the mirrored ray",
              ARG(d), ARG(n), f);
        suspect_value("the random vector weighs 1/3: d was not made a unit vector first",
                      1 - f * f / 27);
        suspect_value("a random point in the ball, not on the sphere", 1 - f * f / 5);
        CHECK_REAL(along.mean, 1 - f * f / 3,
                   standard_errors(5, running_standard_error(&along) + 1e-7));
        given("the same bounces: the mean component across the mirrored ray");
        CHECK_REAL(aside.mean, 0, standard_errors(5, running_standard_error(&aside) + 1e-7));
    }
}

static void fuzz_from_g(void) {
    rng g = rng_seed(6, 30);
    for (int i = 0; i < 200; i++) {
        const vec3 n = generic_unit(&g), d = neg(next_direction(n, &g));
        rng one = rng_seed(1, (uint64_t)i), other = one;
        const vec3 first = fuzzy_bounce(d, n, (real)0.3, &one),
                   second = fuzzy_bounce(d, n, (real)0.3, &other);
        given("d = " VEC ", n = " VEC ", fuzz 0.3, " ASKED_TWICE, ARG(d), ARG(n), ARG(first),
              ARG(second));
        check_from_g(first, second);
    }
}

// ---- matte_bounce ----------------------------------------------------------------

static void matte_differs(void) {
    rng g = rng_seed(6, 28);
    for (int i = 0; i < 20; i++) {
        const vec3 n = generic_unit(&g), first = matte_bounce(n, &g);
        int alike = 0;
        for (int k = 0; k < 100; k++) {
            const vec3 v = matte_bounce(n, &g);
            alike += v.x == first.x && v.y == first.y && v.z == first.z;
        }
        given("n = " VEC ": the first draw is " VEC ", and %d of the next 100 are the same",
              ARG(n), ARG(first), alike);
        CHECK(alike < 50, "all draws are alike: is g used?");
    }
}

typedef struct {
    int draws, below;
    vec3 n, v; // the first of those below
} matte_draws;

// One draw: a unit vector; those that point into the surface are counted.
static void matte_draw(matte_draws *all, vec3 n, rng *g) {
    const vec3 v = matte_bounce(n, g);
    all->draws++;
    given("n = " VEC ": draw %d is " VEC ", of length %.9g", ARG(n), all->draws, ARG(v),
          wide_length(v));
    CHECK(wide_dot(widen(v), widen(v)) >= 0, "not NaN: what is normalize(n + u) when u is -n?");
    CHECK(fabs(wide_length(v) - 1) < 0.01, "a unit vector: normalize the sum");
    CHECK_REAL(wide_length(v), 1, roundings(10, "a unit vector"));
    if (dot(v, n) >= 0) return;
    if (all->below++ == 0) all->n = n, all->v = v;
}

static void matte_from_g(void) {
    rng g = rng_seed(6, 31);
    for (int i = 0; i < 200; i++) {
        const vec3 n = generic_unit(&g);
        rng one = rng_seed(1, (uint64_t)i), other = one;
        const vec3 first = matte_bounce(n, &one), second = matte_bounce(n, &other);
        given("n = " VEC ", " ASKED_TWICE, ARG(n), ARG(first), ARG(second));
        check_from_g(first, second);
    }
}

static void matte_unit(void) {
    rng g = rng_seed(6, 9);
    matte_draws all = {0};
    for (int i = 0; i < 300000; i++) matte_draw(&all, generic_unit(&g), &g);
    given("%d of %d draws point into the surface; the first: " VEC " for n = " VEC "%s",
          all.below, all.draws, ARG(all.v), ARG(all.n),
          all.below > all.draws / 1000 ? "" : ". So few: -n was nearly drawn");
    CHECK(all.below == 0, "every bounce leaves the surface: result·n >= 0");
}

// n is what the next unit_vector is the opposite of, but for a little. For those who
// draw otherwise it is a normal like all others.
static void matte_opposite(void) {
    rng g = rng_seed(6, 29);
    matte_draws all = {0};
    for (int i = 0; i < 20000; i++) {
        const vec3 off = scale((real)pow(10, -3 - i % 7), in_cube(&g));
        rng peek = g;
        const vec3 u = unit_vector(&peek);
        matte_draw(&all, normalize(sub(i % 8 ? off : (vec3){0, 0, 0}, u)), &g);
    }
    given("%d of %d draws point into the surface, where unit_vector(g) gives nearly -n: the "
          "sum with n is then little but rounding. The first: " VEC " for n = " VEC,
          all.below, all.draws, ARG(all.v), ARG(all.n));
    CHECK(all.below == 0, "every bounce leaves the surface: result·n >= 0");
}

static void matte_mean(void) {
    rng g = rng_seed(6, 10);
    for (int i = 0; i < 6; i++) {
        const vec3 n = test_normal(i, &g);
        running cosine = {0};
        for (int k = 0; k < 50000; k++)
            running_add(&cosine, wide_dot(widen(matte_bounce(n, &g)), widen(n)));
        given("n = " VEC ": the mean cosine between n and 50,000 bounces", ARG(n));
        CHECK(cosine.max > cosine.min, "the draws differ: is g used?");
        suspect_value("uniform over the hemisphere: the cosine is missing", 0.5);
        suspect_value("a density of cos³: n plus a point *in* the ball?", 0.8);
        suspect_value("a density of cos²", 0.75);
        suspect_value("uniform over the whole sphere", 0);
        CHECK_REAL(cosine.mean, 2.0 / 3, standard_errors(5, running_standard_error(&cosine)));
    }
}

static void matte_cells(void) {
    rng g = rng_seed(6, 11);
    const long count = 200000;
    for (int i = 0; i < 5; i++) {
        const vec3 n = test_normal(i, &g);
        tally cells = {{0}, 0};
        long below = 0;
        for (long k = 0; k < count; k++) {
            const vec3 v = matte_bounce(n, &g);
            const double c = cosine(v, n);
            below += c < BELOW_BY_ROUNDING;
            tally_add(&cells, c * c, turn(v, n));
        }
        given("n = " VEC ": 200,000 bounces", ARG(n));
        CHECK_AT_MOST(below, 0, "none points into the surface (within a few roundings)");
        given("n = " VEC ": 200,000 bounces counted in 8 x 12 cells of cos²θ and of the angle "
              "about n, all equally likely for cos θ / π",
              ARG(n));
        CHECK_UNIFORM(&cells);
    }
}

// Inside a sphere Lambert's cosine sends light to every part of the wall alike,
// so a window that is a share w of the sphere lets out w of it at each bounce: with
// albedo a and at most s bounces w a (1 - q^s) / (1 - q) comes out, q = a (1 - w).
static void matte_hollow_sphere(void) {
    const double w = 0.1, a = 0.8, q = a * (1 - w);
    const int s = 10;
    rng g = rng_seed(6, 12);
    running light = {0};
    for (int i = 0; i < 40000; i++) {
        vec3 p = generic_unit(&g);
        double C = 1, seen = 0;
        for (int k = 0; k < s && seen == 0; k++) {
            const vec3 d = matte_bounce(neg(p), &g);
            p = normalize(add(p, scale(-2 * dot(p, d), d)));
            C *= a;
            if (p.y > 1 - 2 * w) seen = C;
        }
        running_add(&light, seen);
    }
    given("a hollow matte sphere of albedo 0.8 with a window of a tenth of its surface: the "
          "light that 40,000 paths of at most 10 bounces find");
    CHECK_REAL(light.mean, w * a * (1 - pow(q, s)) / (1 - q),
               standard_errors(5, running_standard_error(&light)));
}

// ---- trace -----------------------------------------------------------------------

static color white_sky(vec3 d) {
    (void)d;
    return (color){1, 1, 1};
}

// Another colour in every direction, so that a wrong last direction shows.
static color telling_sky(vec3 d) {
    const vec3 u = normalize(d);
    return scale((real)0.25, (vec3){2 + u.x, 2 + u.y, 2 + u.z});
}

static const vec3 nowhere = {(real)123.25, (real)-77.5, (real)31.75};

static scene one_sphere(const sphere *S, const material *m, start_rule start) {
    return (scene){.spheres = S,
                   .sphere_materials = m,
                   .sphere_count = 1,
                   .sky = white_sky,
                   .start = start};
}

// A ray from about `far` radii away towards a point inside S.
static ray towards(sphere S, real far, rng *g) {
    const vec3 O = add(S.c, scale(far * S.r, generic_unit(g)));
    const vec3 aim = add(S.c, scale((real)0.55 * S.r, in_cube(g)));
    return (ray){O, sub(aim, O)};
}

static void furnace(void) {
    const finish finishes[] = {MATTE, MIRROR, FUZZY};
    rng g = rng_seed(6, 13);
    for (int i = 0; i < 6000; i++) {
        const sphere S = {in_cube(&g), between(&g, (real)0.2, 2)};
        const material m = {
            finishes[i % 3], {(real)0.25, (real)0.5, (real)0.75}, {0, 0, 0}, false, (real)0.5};
        const scene sc = one_sphere(&S, &m, START_BOUND);
        const ray r = towards(S, 3, &g);
        if (sphere_hit(S, r, 0, NO_HIT) == NO_HIT) continue;
        given("a lone %s sphere, c = " VEC ", r = %.9g, albedo (0.25, 0.5, 0.75), in a sky of "
              "1; ray O = " VEC ", d = " VEC ", s = %d",
              i % 3 == 0   ? "matte"
              : i % 3 == 1 ? "mirror"
                           : "fuzzy",
              ARG(S.c), (double)S.r, ARG(r.O), ARG(r.d), 1 + i % 4);
        suspect_vec3("the light of the sky, unfiltered by the object: is it multiplied by C?",
                     (vec3){1, 1, 1});
        suspect_vec3("black: out of bounces before the sky could be reached", (vec3){0, 0, 0});
        suspect_vec3("albedo twice: the sphere hit itself, or was counted twice",
                     mul(m.albedo, m.albedo));
        suspect_vec3("1 + albedo: added (add), not multiplied (mul)",
                     add((vec3){1, 1, 1}, m.albedo));
        CHECK_VEC3(trace(&sc, r, 1 + i % 4, &g), m.albedo, exactly());
    }
}

static void no_bounces(void) {
    const sphere S = {{1, 2, -5}, (real)1.5};
    const material m = {.finish = MIRROR, .albedo = {1, 1, 1}};
    scene sc = one_sphere(&S, &m, START_BOUND);
    sc.sky = telling_sky;
    rng g = rng_seed(6, 14);
    const ray past = {{0, 0, 0}, {1, 2, 5}}, at = {{0, 0, 0}, {1, 2, -5}};
    given("s = 0 and a ray that meets nothing");
    suspect_vec3("white: the sky was never asked", (vec3){1, 1, 1});
    suspect_vec3("1 + the sky: added (add), not multiplied (mul)",
                 add((vec3){1, 1, 1}, telling_sky(past.d)));
    suspect_vec3("black: the sky needs no bounce", (vec3){0, 0, 0});
    CHECK_VEC3(trace(&sc, past, 0, &g), telling_sky(past.d), exactly());
    given("s = 0 and a ray that meets a white mirror");
    suspect_vec3("white: what the slide's loop gives for s = 0", (vec3){1, 1, 1});
    suspect_vec3("the sky in the mirror: one bounce more than s",
                 telling_sky((vec3){-1, -2, 5}));
    CHECK_VEC3(trace(&sc, at, 0, &g), ((vec3){0, 0, 0}), exactly());
}

// Two mirror planes that meet at `angle` along the line through `nowhere` along w.
typedef struct {
    plane P[2];
    vec3 u, v, w; // right-handed; the first plane holds u and w
} wedge;

static vec3 at_angle(const wedge *W, double angle) {
    return add(scale((real)cos(angle), W->u), scale((real)sin(angle), W->v));
}

static wedge wedge_of(double angle, rng *g) {
    wedge W = {.u = generic_unit(g)};
    W.v = perpendicular(W.u);
    W.w = cross(W.u, W.v);
    W.P[0] = (plane){nowhere, at_angle(&W, PI / 2)};
    W.P[1] = (plane){nowhere, at_angle(&W, angle - PI / 2)};
    return W;
}

// Seen unfolded the path is one straight line, and crosses a picture of a mirror
// at each multiple of the angle between where it starts and where it goes. So the
// number of bounces, which mirror each is, and the last direction are known.
static void wedge_of_mirrors(void) {
    const double angle = 0.3;
    const material m[2] = {{.albedo = {(real)0.5, 1, (real)0.75}},
                           {.albedo = {(real)0.75, (real)0.5, 1}}};
    rng g = rng_seed(6, 15);
    int most = 0;
    for (int i = 0; i < 1000; i++) {
        const wedge W = wedge_of(angle, &g);
        const double from = angle * (0.2 + 0.6 * rng_double(&g)),
                     to = from + 3 * rng_double(&g);
        const int k = (int)floor(to / angle);
        if (fabs(to / angle - round(to / angle)) < 0.05 || to - from > 3) continue;
        const scene sc = {
            .planes = W.P, .plane_materials = m, .plane_count = 2, .sky = telling_sky};
        const ray r = {add(nowhere, scale(2, at_angle(&W, from))),
                       add(at_angle(&W, to), scale((real)0.3, W.w))};
        // Folded back: every second picture of the wedge is mirrored.
        const double last = k % 2 ? (k + 1) * angle - to : to - k * angle;
        const color F_B = telling_sky(add(at_angle(&W, last), scale((real)0.3, W.w)));
        color C = F_B, sum = {1, 1, 1};
        for (int b = 1; b <= k; b++) {
            C = mul(C, m[b % 2].albedo);
            sum = add(sum, m[b % 2].albedo);
        }
        most = k > most ? k : most;
        given("two mirrors at 0.3 radians and a ray that bounces exactly %d times: s = %d", k,
              k);
        suspect_vec3("black: the last bounce was not allowed to reach the sky",
                     (vec3){0, 0, 0});
        if (k > 0) suspect_vec3("the sky's light without C", F_B);
        suspect_vec3("the albedos added (add), not multiplied (mul)", mul(sum, F_B));
        CHECK_VEC3(trace(&sc, r, k, &g), C,
                   roundings(400 * (k + 1), "each bounce turns d by a few roundings"));
        CHECK_VEC3(trace(&sc, r, k + 3, &g), C, roundings(400 * (k + 1), "as before"));
        if (k == 0) continue;
        given("the same ray, that bounces %d times, with s = %d", k, k - 1);
        suspect_vec3(k > 1 ? "its light after all bounces: is s counted down, and looked at?"
                           : "its light after all bounces: with s = 0 none is allowed",
                     C);
        CHECK_VEC3(trace(&sc, r, k - 1, &g), ((vec3){0, 0, 0}), exactly());
    }
    CHECK(most == 10, "the test itself: some of its rays bounce 10 times");
}

static void closed_cavity(void) {
    const sphere S = {{3, -2, 7}, 5};
    const material m = {.finish = MATTE, .albedo = {1, 1, 1}};
    const scene sc = one_sphere(&S, &m, START_BOUND);
    rng g = rng_seed(6, 16);
    for (int i = 0; i < 300; i++) {
        const int s = i % 30;
        const ray r = {add(S.c, scale(2, in_cube(&g))), generic_unit(&g)};
        given("inside a closed white sphere, s = %d: no path can see the sky, and the ray "
              "bounces for ever unless s is counted down",
              s);
        CHECK_VEC3(trace(&sc, r, s, &g), ((vec3){0, 0, 0}), exactly());
    }
}

// Each ray that fell for its own surface again would see albedo² or black.
static void no_acne(start_rule start, sphere S, int rays) {
    const material m = {.finish = MATTE, .albedo = {(real)0.5, (real)0.5, (real)0.5}};
    const scene sc = one_sphere(&S, &m, start);
    rng g = rng_seed(6, 17);
    for (int i = 0; i < rays; i++) {
        const vec3 O = add(S.c, scale(S.r + 2, generic_unit(&g)));
        const ray r = {O, sub(add(S.c, scale(S.r / 2, in_cube(&g))), O)};
        given("a matte sphere, c = " VEC ", r = %.9g, albedo 0.5 in a sky of 1; ray O = " VEC
              ", d = " VEC "; sc->start is %s",
              ARG(S.c), (double)S.r, ARG(r.O), ARG(r.d),
              start == START_BOUND ? "START_BOUND" : "START_EPSILON");
        suspect_vec3("the light of the sky, unfiltered by the object: is it multiplied by C?",
                     (vec3){1, 1, 1});
        suspect_vec3("1 + albedo: added (add), not multiplied (mul)",
                     (vec3){(real)1.5, (real)1.5, (real)1.5});
        for (int k = 2; k <= 8; k++)
            suspect_vec3("albedo more than once: the next ray hit the surface that it started "
                         "from; was t_min set for it?",
                         scale((real)pow(0.5, k), (vec3){1, 1, 1}));
        suspect_vec3("black: the next ray hit the surface that it started from, until s was "
                     "used up; was t_min set for it?",
                     (vec3){0, 0, 0});
        CHECK_VEC3(trace(&sc, r, 8, &g), m.albedo, exactly());
    }
}

// A next ray with a cosine below 6e-4 may graze past 0.0001 and hit again: with 1000
// rays a right answer fails with probability 2e-4 in float.
static void epsilon_rule(void) {
    no_acne(START_EPSILON, (sphere){{(real)0.3, (real)-0.7, (real)0.2}, (real)1.25}, 1000);
}

static void bound_rule(void) {
    no_acne(START_BOUND, (sphere){{(real)0.3, (real)-0.7, (real)0.2}, (real)1.25}, 20000);
    no_acne(START_BOUND, (sphere){{20, -1000, 30}, 1000}, 20000);
    no_acne(START_BOUND, (sphere){{-4000, 9000, 70}, 3}, 20000);
}

// Dim straight ahead of the first ray below, where no next ray can go; else 1.
static color sky_dim_ahead(vec3 d) {
    const vec3 ahead = normalize((vec3){1, 2, -5});
    return dot(normalize(d), ahead) > (real)0.9 ? (color){(real)0.125, (real)0.25, (real)0.375}
                                                : (color){1, 1, 1};
}

static void long_first_ray(void) {
    const sphere S = {{1, 2, -5}, (real)1.5};
    const material m = {.finish = MATTE, .albedo = {(real)0.5, (real)0.5, (real)0.5}};
    rng g = rng_seed(6, 18);
    for (int start = START_BOUND; start <= START_EPSILON; start++) {
        scene sc = one_sphere(&S, &m, (start_rule)start);
        sc.sky = sky_dim_ahead;
        const ray r = {{0, 0, 0}, {1e6f, 2e6f, -5e6f}};
        given("a camera ray with |d| = 5.5 million, so that it meets the sphere at t = 7e-7; "
              "the sky behind the sphere is (0.125, 0.25, 0.375), elsewhere 1");
        suspect_vec3("the sky behind the sphere: t_min of the next rays was used for the first",
                     sc.sky(r.d));
        suspect_vec3("the light of the sky, unfiltered by the object: is it multiplied by C?",
                     (vec3){1, 1, 1});
        suspect_vec3("1 + albedo: added (add), not multiplied (mul)",
                     (vec3){(real)1.5, (real)1.5, (real)1.5});
        suspect_vec3("albedo twice: the next ray hit the surface that it started from; was "
                     "t_min set for it?",
                     mul(m.albedo, m.albedo));
        CHECK_VEC3(trace(&sc, r, 2, &g), m.albedo, exactly());
    }
}

static void checkered_floor(void) {
    const plane P = {{0, -1, 0}, {0, 1, 0}};
    const material m = {MATTE,
                        {(real)0.75, (real)0.5, (real)0.25},
                        {(real)0.125, (real)0.25, (real)0.375},
                        true,
                        0};
    const scene sc = {.planes = &P, .plane_materials = &m, .plane_count = 1, .sky = white_sky};
    rng g = rng_seed(6, 19);
    for (int i = 0; i < 1000; i++) {
        const vec3 square = {floor(between(&g, -9, 9)) + between(&g, (real)0.1, (real)0.9), -1,
                             floor(between(&g, -9, 9)) + between(&g, (real)0.1, (real)0.9)};
        const vec3 O = {between(&g, -5, 5), between(&g, 0, 5), between(&g, -5, 5)};
        const bool second = checks(square.x, square.z);
        const color here = second ? m.albedo_2 : m.albedo;
        given("a checkered floor in a sky of 1, seen at " VEC, ARG(square));
        suspect_vec3("the colour of the other squares", second ? m.albedo : m.albedo_2);
        suspect_vec3("the light of the sky, unfiltered by the object: is it multiplied by C?",
                     (vec3){1, 1, 1});
        suspect_vec3("1 + albedo: added (add), not multiplied (mul)",
                     add((vec3){1, 1, 1}, here));
        CHECK_VEC3(trace(&sc, (ray){O, sub(square, O)}, 3, &g), here, exactly());
    }
}

// ---- offset_origin ---------------------------------------------------------------
// Every start must lie on the right side of the true surface, judged in higher
// precision, and the next ray must not meet the surface again.

enum { PER_SETTING = 2500 };
static const double sizes[] = {1e-6, 1e-3, 1, 1e3, 1e6};
static const double distances[] = {0, 1, 100, 1e4}; // of the body from the origin, in sizes

static exact exact_height(vec3 q, vec3 x, exact nx, exact ny, exact nz) {
    return ((exact)q.x - x.x) * nx + ((exact)q.y - x.y) * ny + ((exact)q.z - x.z) * nz;
}

static double sign_of(exact x) {
    return x > 0 ? 1 : x < 0 ? -1 : 0;
}

// Where q lies: 1 on the side that the normal points to, -1 on the other, 0 in it.
static double sphere_side(sphere S, vec3 q) {
    const exact x = (exact)q.x - S.c.x, y = (exact)q.y - S.c.y, z = (exact)q.z - S.c.z;
    return sign_of(x * x + y * y + z * z - (exact)S.r * S.r);
}

static double plane_side(plane P, vec3 q) {
    return sign_of(exact_height(q, P.x, P.n.x, P.n.y, P.n.z));
}

static double triangle_side(triangle T, vec3 q) {
    const exact ax = (exact)T.p2.x - T.p1.x, ay = (exact)T.p2.y - T.p1.y,
                az = (exact)T.p2.z - T.p1.z, bx = (exact)T.p3.x - T.p1.x,
                by = (exact)T.p3.y - T.p1.y, bz = (exact)T.p3.z - T.p1.z;
    return sign_of(
        exact_height(q, T.p1, ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx));
}

static void report(const char *what, hit h, vec3 d, vec3 q) {
    given("%s: p = " VEC ", error = " VEC ", n = " VEC ", next direction " VEC ": start " VEC,
          what, ARG(h.p), ARG(h.error), ARG(h.n), ARG(d), ARG(q));
}

static void check_side(const char *what, hit h, vec3 d, vec3 q, double side, double want) {
    if (side == want) return;
    report(what, h, d, q);
    const bool off_the_surface = side != 0;
    CHECK(off_the_surface, "the start lies off the surface, on the side that d points to");
    const bool on_the_side_of_d = side == want;
    CHECK(on_the_side_of_d, "the start lies on the side of the surface that d points to");
}

// The next direction leaves on the side that the ray came from, or on the other.
static vec3 leave(hit h, double side, rng *g) {
    return next_direction(side > 0 ? h.n : neg(h.n), g);
}

static void spheres_at(double size, double distance, bool inside) {
    rng g = rng_seed(6, 20);
    for (int i = 0; i < 2 * PER_SETTING; i++) {
        const sphere S = {scale((real)(size * distance), generic_unit(&g)),
                          (real)size * between(&g, (real)0.5, 2)};
        ray r = towards(S, i % 2 ? 3 : 300, &g);
        if (inside) r.O = add(S.c, scale((real)0.5 * S.r, in_cube(&g)));
        const real t = sphere_hit(S, r, 0, NO_HIT);
        if (t == NO_HIT) continue;
        const hit h = sphere_surface(S, r, t);
        const double side = inside ? -1 : 1;
        const vec3 d = leave(h, side, &g), q = offset_origin(h.p, h.error, h.n, d);
        check_side(inside ? "inside a sphere" : "outside a sphere", h, d, q, sphere_side(S, q),
                   side);
        const real again = sphere_hit(S, (ray){q, d}, 0, NO_HIT);
        const double across = -2 * wide_dot(wide_sub(q, S.c), widen(d)); // to the far side
        report(inside ? "inside a sphere" : "outside a sphere", h, d, q);
        if (!inside) CHECK_REAL(again, NO_HIT, exactly());
        const bool at_the_far_side = again >= across / 2;
        if (inside) CHECK(at_the_far_side, "the next hit is the far side of the sphere");
    }
}

// t of the plane, by its equation when there is one.
static real meet_plane(plane P, const plane_equations *E, ray r) {
    real t[EQUATIONS];
    if (!E) return plane_hit(P, r, 0, NO_HIT);
    equations_hit(E, r, 0, t);
    return t[0];
}

static void planes_at(double size, double distance, bool by_equation) {
    rng g = rng_seed(6, 21);
    for (int i = 0; i < PER_SETTING; i++) {
        const vec3 there = scale((real)(size * distance), generic_unit(&g));
        const plane P = {add(there, scale((real)size, in_cube(&g))), in_cube(&g)};
        const ray r = {add(there, scale((real)size, in_cube(&g))), in_cube(&g)};
        const plane_equations known = plane_equations_of(&P, 1),
                              *E = by_equation ? &known : NULL;
        const real t = meet_plane(P, E, r);
        if (t == NO_HIT || t > 1e4f * (real)size) continue;
        const hit h = E ? equations_surface(E, 0, r, t) : plane_surface(P, r, t);
        const double side = i % 2 ? 1 : -1;
        const vec3 d = leave(h, side, &g), q = offset_origin(h.p, h.error, h.n, d);
        check_side("a plane", h, d, q, plane_side(P, q), side);
        report("a plane", h, d, q);
        CHECK_REAL(meet_plane(P, E, (ray){q, d}), NO_HIT, exactly());
    }
}

static void triangles_at(double size, double distance, real width) {
    rng g = rng_seed(6, 22);
    for (int i = 0; i < PER_SETTING; i++) {
        const vec3 p1 = add(scale((real)(size * distance), generic_unit(&g)),
                            scale((real)size, in_cube(&g)));
        const vec3 e1 = scale((real)size, generic_unit(&g));
        const vec3 e2 =
            add(scale((real)0.7, e1), scale((real)size * width, perpendicular(normalize(e1))));
        const triangle T = {p1, add(p1, e1), add(p1, e2)};
        const vec3 inside = add(p1, scale((real)0.3, add(e1, e2)));
        const vec3 O = add(inside, scale((real)size * (i % 2 ? 3 : 300), generic_unit(&g)));
        const ray r = {O, sub(inside, O)};
        const triangle_point at = triangle_hit(T, r, 0, NO_HIT);
        if (at.t == NO_HIT) continue;
        const hit h = triangle_surface(T, r, at);
        const double side = i % 4 < 2 ? 1 : -1;
        const vec3 d = leave(h, side, &g), q = offset_origin(h.p, h.error, h.n, d);
        check_side("a triangle", h, d, q, triangle_side(T, q), side);
        report("a triangle", h, d, q);
        CHECK_REAL(triangle_hit(T, (ray){q, d}, 0, NO_HIT).t, NO_HIT, exactly());
    }
}

static void sphere_starts(void) {
    for (int i = 0; i < COUNT(sizes); i++)
        for (int k = 0; k < COUNT(distances); k++) spheres_at(sizes[i], distances[k], false);
}

static void sphere_starts_inside(void) {
    for (int i = 0; i < COUNT(sizes); i++)
        for (int k = 0; k < COUNT(distances); k++) spheres_at(sizes[i], distances[k], true);
}

static void plane_starts(void) {
    for (int i = 0; i < COUNT(sizes); i++)
        for (int k = 0; k < COUNT(distances); k++) planes_at(sizes[i], distances[k], false);
}

static void equation_starts(void) {
    for (int i = 0; i < COUNT(sizes); i++)
        for (int k = 0; k < COUNT(distances); k++) planes_at(sizes[i], distances[k], true);
}

static void triangle_starts(void) {
    for (int i = 0; i < COUNT(sizes); i++)
        for (int k = 0; k < COUNT(distances); k++) {
            triangles_at(sizes[i], distances[k], 1);
            if (k < 2) triangles_at(sizes[i], distances[k], (real)0.01);
        }
}

static vec3 copied_signs(vec3 a, vec3 signs) {
    return (vec3){copysign(a.x, signs.x), copysign(a.y, signs.y), copysign(a.z, signs.z)};
}

static vec3 offset_moved(vec3 p, vec3 error, vec3 n, vec3 d) {
    return sub(offset_origin(p, error, n, d), p);
}

static void offset_by_hand(void) {
    const vec3 p = {3, -5, 7}, n = {(real)2 / 7, (real)-3 / 7, (real)6 / 7};
    const vec3 error = {(real)0.125, (real)0.25, (real)0.0625}, d = {1, 1, 1};
    // |n|·error = (2/8 + 3/4 + 6/16)/7 = 1.375/7
    const real reach = (real)(1.375 / 7);
    const vec3 step = scale(reach, n);
    given("p = (3, -5, 7), error = (1/8, 1/4, 1/16), n = (2, -3, 6)/7; d on the side of n");
    suspect_vec3("moved against n: the sign", neg(step));
    suspect_vec3("p itself: not moved", (vec3){0, 0, 0});
    suspect_vec3("n·error with the signs of n: they cancel", scale((real)(-0.125 / 7), n));
    suspect_vec3("p + error: moved by the error, not along n", error);
    suspect_vec3("|error| along n, not |n|·error", scale(length(error), n));
    suspect_vec3("to the corner of the box p ± error: not along n", copied_signs(error, n));
    suspect_vec3("n times error, axis by axis: not along n", mul(n, error));
    const allowance fair = absolute_of(8 * REAL_EPSILON * length(p),
                                       "the sum, and one step further in each component");
    CHECK_VEC3(offset_moved(p, error, n, d), step, fair);
    given("the same with d on the other side");
    suspect_vec3("along n, whatever side d is on", step);
    CHECK_VEC3(offset_moved(p, error, n, neg(d)), neg(step), fair);
}

// Rounding p + step to the nearest may take the step back: without an error, the
// start must still move, and the rounding may only ever lead away.
static void offset_rounded_away(void) {
    rng g = rng_seed(6, 23);
    for (int i = 0; i < 5000; i++) {
        const vec3 n = generic_unit(&g), p = scale((real)pow(10, i % 13 - 6), in_cube(&g));
        const vec3 error = scale(REAL_EPSILON / 64, absolute(p));
        const vec3 q = offset_origin(p, error, n, n);
        const wide3 moved = wide_sub(q, p);
        given("p = " VEC ", an error far under its last digit, n = " VEC ": start " VEC, ARG(p),
              ARG(n), ARG(q));
        const bool all_along_n =
            moved.x * (double)n.x > 0 && moved.y * (double)n.y > 0 && moved.z * (double)n.z > 0;
        CHECK(all_along_n, "every component moves, in the direction of n");
        CHECK_AT_MOST(sqrt(wide_dot(moved, moved)), 4 * REAL_EPSILON * wide_length(p),
                      "no further than needed: a step or two of the last digit");
    }
}

// ---- what was given --------------------------------------------------------------

static void unit_vectors(void) {
    rng g = rng_seed(6, 24);
    const long count = 200000;
    const vec3 up = {0, 0, 1};
    tally cells = {{0}, 0};
    for (long k = 0; k < count; k++) {
        const vec3 v = unit_vector(&g);
        CHECK_REAL(wide_length(v), 1, roundings(6, "a unit vector"));
        tally_add(&cells, ((double)v.z + 1) / 2, turn(v, up));
    }
    given("200,000 unit vectors in 8 x 12 cells of equal area");
    CHECK_UNIFORM(&cells);
}

static void slide_slips(void) {
    const sphere S = {{1, 2, -5}, (real)1.5};
    const material m = {.finish = MIRROR, .albedo = {(real)0.5, (real)0.5, (real)0.5}};
    const scene sc = one_sphere(&S, &m, START_BOUND);
    const ray at = {{0, 0, 0}, {1, 2, -5}};
    rng g = rng_seed(6, 25);
    given("the slide's loop, one bounce needed to reach a sky of 1 from albedo 0.5");
    CHECK_VEC3(trace_slide(&sc, at, 0, &g), ((vec3){1, 1, 1}), exactly());
    CHECK_VEC3(trace_slide(&sc, at, 1, &g), ((vec3){0, 0, 0}), exactly());
    CHECK_VEC3(trace_slide(&sc, at, 2, &g), m.albedo, exactly());
}

// Everything tried by hand against scene_hit.
static void nearest_of_all(void) {
    rng g = rng_seed(6, 26);
    const vec3 points[] = {{2, 0, -6}, {0, 2, -5}, {-1, -1, -7}, {1, 2, -4}};
    const int corners[][3] = {{0, 1, 2}, {1, 3, 2}};
    const mesh body = {.points = points, .corners = corners, .count = COUNT(corners)};
    const sphere S[2] = {{{0, 0, -5}, 1}, {{(real)0.6, (real)0.4, -6}, (real)1.5}};
    const plane P[2] = {{{0, -1, 0}, {(real)0.1, 1, (real)0.2}}, {{0, 0, -8}, {0, 0, 2}}};
    const material m[5] = {{0}};
    const scene sc = {.spheres = S,
                      .sphere_materials = m,
                      .sphere_count = 2,
                      .planes = P,
                      .plane_materials = m + 2,
                      .plane_count = 2,
                      .meshes = &body,
                      .mesh_materials = m + 4,
                      .mesh_count = 1,
                      .sky = white_sky};
    for (int i = 0; i < 3000; i++) {
        const ray r = {in_cube(&g), add((vec3){0, 0, -2}, in_cube(&g))};
        const real t_min = between(&g, 0, 2), t_max = between(&g, 2, 9);
        int which = 0;
        const real t[5] = {sphere_hit(S[0], r, t_min, t_max), sphere_hit(S[1], r, t_min, t_max),
                           plane_hit(P[0], r, t_min, t_max), plane_hit(P[1], r, t_min, t_max),
                           mesh_hit(&body, r, t_min, t_max, &which).t};
        int first = 0;
        for (int k = 1; k < 5; k++) first = t[k] < t[first] ? k : first;
        const material *found = NULL;
        const hit h = scene_hit(&sc, r, t_min, t_max, &found);
        given("two spheres, two planes and a mesh; ray O = " VEC ", d = " VEC
              ", t from %.3g to %.3g",
              ARG(r.O), ARG(r.d), (double)t_min, (double)t_max);
        CHECK_REAL(h.t, t[first], exactly());
        CHECK((t[first] == NO_HIT) == (found == NULL), "a miss leaves *m untouched");
        if (found) CHECK_INT(found - m, first);
    }
}

// Up to 20 planes, so that their equations fill several blocks, and a sphere.
static void prepared(void) {
    enum { MOST = 20 };
    rng g = rng_seed(6, 28);
    int hits = 0;
    for (int i = 0; i < 6000; i++) {
        plane P[MOST];
        const int count = i % (MOST + 1);
        for (int k = 0; k < count; k++) P[k] = (plane){scale(4, in_cube(&g)), in_cube(&g)};
        const sphere S = {in_cube(&g), (real)0.5};
        const scene plain = {
            .spheres = &S, .sphere_count = 1, .planes = P, .plane_count = count};
        scene ready = scene_prepare(plain);
        const ray r = {scale(3, in_cube(&g)), in_cube(&g)};
        const real t_min = between(&g, 0, 2), t_max = i % 2 ? between(&g, 2, 9) : NO_HIT;
        int body = -1, same = -1;
        const hit want = scene_nearest(&plain, r, t_min, t_max, &body);
        const hit h = scene_nearest(&ready, r, t_min, t_max, &same);
        given("%d planes and a sphere; ray O = " VEC ", d = " VEC ", t from %.3g to %.3g",
              count, ARG(r.O), ARG(r.d), (double)t_min, (double)t_max);
        CHECK_REAL(h.t, want.t,
                   relative_to(1e4 * DBL_EPSILON + REAL_EPSILON,
                               "a rounding, and what cancels in double"));
        CHECK_INT(same, body);
        bool blocked = false;
        for (int k = 0; k < count; k++) blocked |= plane_hit(P[k], r, t_min, t_max) != NO_HIT;
        CHECK_BOOL(planes_block(&plain, r, t_min, t_max), blocked);
        CHECK_BOOL(planes_block(&ready, r, t_min, t_max), blocked);
        hits += body > 0;
        scene_release(&ready);
    }
    CHECK(hits > 2000, "the test itself: enough of its rays hit a plane");
}

// From both sides of a surface: the next ray stays on the side that the ray came from.
static void either_side(void) {
    rng g = rng_seed(6, 27);
    const finish finishes[] = {MIRROR, FUZZY, MATTE};
    const plane P = {{1, -2, 3}, {2, -3, 6}};
    for (int i = 0; i < 3000; i++) {
        const material m = {.finish = finishes[i % 3], .fuzz = (real)0.5};
        const scene sc = {.planes = &P, .plane_materials = &m, .plane_count = 1};
        const ray r = {scale(9, in_cube(&g)), scale(2, generic_unit(&g))};
        const real t = plane_hit(P, r, 0, NO_HIT);
        if (t == NO_HIT) continue;
        const ray next = bounce(&sc, &m, r, plane_surface(P, r, t), &g);
        given("a plane seen from side %g; next ray O = " VEC ", d = " VEC, plane_side(P, r.O),
              ARG(next.O), ARG(next.d));
        CHECK_REAL(plane_side(P, next.O), plane_side(P, r.O), exactly());
        CHECK_REAL(wide_length(next.d), 1, roundings(10, "a unit vector"));
        CHECK_REAL(plane_hit(P, next, 0, NO_HIT), NO_HIT, exactly());
    }
}

int main(void) {
    static const char *const mirror = "What must happen to the part of d along n, and what to "
                                      "the rest?";
    static const char *const newton =
        "One step of Newton's method for 1/|d|, started at 1, is only good near 1.";
    static const char *const fuzzy = "Mirrored unit direction, plus fuzz times a point of the "
                                     "unit sphere, made a unit vector; what if it points down?";
    static const char *const lambert =
        "The density must be cos θ / π: which sum of n and a random vector, drawn "
        "with g, has it? On or in the sphere?";
    static const char *const loop = "Go through the loop by hand with one object and s = 1.";
    static const char *const away = "How far does the box p ± error reach along n? And which "
                                    "way does a rounding go?";
    static const char *const from_g = "Whatever is drawn comes from g, by unit_vector(g) or "
                                      "rng_real(g), and nothing is kept for the next call.";
    static const test tests[] = {
        {"reflect: worked out by hand", mirror_by_hand, mirror},
        {"reflect: 2000 generic mirrors", mirror_generic, mirror},
        {"reflect: either side, and twice", mirror_sides, mirror},
        {"keep_unit: lengths near 1 and far from it", unit_again, newton},
        {"keep_unit: a million mirrors", million_mirrors, newton},
        {"fuzzy_bounce: fuzz 0 is a mirror", fuzz_none, fuzzy},
        {"fuzzy_bounce: a unit vector, never into the surface", fuzz_above, fuzzy},
        {"fuzzy_bounce: grazing, without fuzz", fuzz_grazing,
         "Here every new draw is the same: rounding put the mirrored ray into the surface."},
        {"fuzzy_bounce: the mean of 200,000", fuzz_mean, fuzzy},
        {"fuzzy_bounce: the same g, the same draw", fuzz_from_g, from_g},
        {"matte_bounce: the same g, the same draw", matte_from_g, from_g},
        {"matte_bounce: another direction every time", matte_differs,
         "Its random numbers come from g, and g must be the caller's: a fresh rng starts anew "
         "each time."},
        {"matte_bounce: a unit vector above the surface", matte_unit,
         "Can the sum be zero, or end below the surface?"},
        {"matte_bounce: when the random vector is nearly -n", matte_opposite,
         "Of a sum that is tiny only rounding is left: draw again from g."},
        {"matte_bounce: the mean cosine is 2/3", matte_mean, lambert},
        {"matte_bounce: chi² against cos θ / π", matte_cells, lambert},
        {"matte_bounce: the light in a hollow sphere", matte_hollow_sphere, lambert},
        {"trace: a lone body in a sky of 1 shows its albedo", furnace, loop},
        {"trace: s = 0", no_bounces, "The sky needs no bounce; an object does."},
        {"trace: exactly as many bounces as needed", wedge_of_mirrors,
         "A path of s bounces may still look where its last ray goes."},
        {"trace: a closed room is black", closed_cavity,
         "No bounces left and something in the way: what light has been found?"},
        {"trace: a fixed epsilon, when the scene asks for one", epsilon_rule,
         "Which t_min belongs to rays that bounce made? See start_t_min."},
        {"trace: no acne", bound_rule, "Which t_min belongs to rays that bounce made?"},
        {"trace: the first ray starts at t_min = 0", long_first_ray,
         "start_t_min is for rays that bounce made; t counts in |d|."},
        {"trace: a checkered floor", checkered_floor, "albedo_at the point that was hit."},
        {"offset_origin: worked out by hand", offset_by_hand, away},
        {"offset_origin: rounded away, not to the nearest", offset_rounded_away, away},
        {"offset_origin: spheres, from outside", sphere_starts, away},
        {"offset_origin: spheres, from inside", sphere_starts_inside, away},
        {"offset_origin: planes", plane_starts, away},
        {"offset_origin: planes by their equations", equation_starts, away},
        {"offset_origin: triangles", triangle_starts, away},
        {"unit_vector: chi² over the sphere", unit_vectors, "Given code: did it change?"},
        {"trace_slide: the slide's two slips", slide_slips, "Given code: did it change?"},
        {"scene_hit: the nearest of everything", nearest_of_all, "Given code: did it change?"},
        {"scene_prepare: the same hits", prepared, "Given code: did it change?"},
        {"bounce: stays on its side", either_side, "n turned towards the ray."},
    };
    return run_tests("06-bounce", tests, COUNT(tests));
}
