// 10-paths.h: the part of 10-importance-sampling.c about surfaces, lamps and whole paths.
#ifndef TESTS_10_PATHS_H
#define TESTS_10_PATHS_H

#include "chapters/09-path-tracer/box.h"
#include "tests/10-sphere.h"

// ---- surfaces ----------------------------------------------------------------------------

static surface some_surface(int i, rng *g) {
    const color albedo = absolute(in_cube(g));
    const real alpha = i % 4 == 3 ? (real)0.001 : (real)between(g, 0.05, 1);
    return (surface){i % 2 ? GGX : LAMBERT, albedo, {0, 0, 0}, alpha};
}

// Above n; every fourth one grazing.
static vec3 some_view(vec3 n, int i, rng *g) {
    const vec3 v = generic_unit(g), up = dot(v, n) < 0 ? neg(v) : v;
    if (i % 4) return up;
    const vec3 along = normalize(sub(up, scale(dot(up, n), n)));
    return normalize(add(along, scale((real)pow(10, between(g, -7, -1)), n)));
}

static void scatter_belongs(void) {
    rng g = check_rng(91);
    for (int i = 0; i < 40000; i++) {
        const surface m = some_surface(i, &g);
        const vec3 n = test_normal(i / 4, &g), o = some_view(n, i / 2, &g);
        const scattered next = surface_scatter(&m, n, o, &g);
        given("%s, alpha = %g, n = " VEC ", o = " VEC ": v = " VEC ", p = %.6g",
              m.lobe == GGX ? "GGX" : "Lambert", (double)m.alpha, ARG(n), ARG(o), ARG(next.v),
              (double)next.p);
        CHECK(isfinite(next.p) && next.p >= 0, "a density: finite, not negative");
        if (next.p == 0) continue;
        CHECK(is_finite(next.weight) && next.weight.x >= 0 && next.weight.y >= 0 &&
                  next.weight.z >= 0 && next.weight.x <= 1 + 8 * REAL_EPSILON,
              "a weight from 0 to 1");
        CHECK_REAL(wide_length(next.v), 1, roundings(16, "a unit vector"));
        const double c = cosine(next.v, n), high = cosine(o, n);
        if (c < 0.01 || high < 0.01) continue;
        // v is rounded, and h from it: as much against alpha, and against the cosines.
        const double off = 300 * REAL_EPSILON / (m.lobe == GGX ? m.alpha * c * high : c);
        CHECK_REAL(surface_probability(&m, n, o, next.v), next.p,
                   relative_to(off, "v is rounded, which alpha and the cosines enlarge"));
        const color f = surface_brdf(&m, n, o, next.v);
        const allowance allowed = {1e-6, off,
                                   "v is rounded, which alpha and the cosines enlarge"};
        CHECK_VEC3(scale((real)c / next.p, f), next.weight, allowed);
    }
}

// Uniform directions and the surface's own must find the same light, under a sky that is
// brighter on one side.
static void scatter_means(void) {
    rng g = check_rng(92);
    for (int i = 0; i < 8; i++) {
        const vec3 n = test_normal(i, &g), o = some_view(n, 1, &g), bright = generic_unit(&g);
        const surface m = {i % 2 ? GGX : LAMBERT,
                           {(real)0.9, (real)0.5, (real)0.2},
                           {0, 0, 0},
                           (real)between(&g, 0.4, 1)};
        running own = {0}, uniform = {0};
        for (int k = 0; k < 30000; k++) {
            const scattered next = surface_scatter(&m, n, o, &g);
            if (next.p > 0)
                running_add(&own, next.weight.y * (2 + cosine(next.v, bright)));
            else
                running_add(&own, 0);
            const vec3 v = hemisphere_direction(n, &g);
            running_add(&uniform, 2 * PI * surface_brdf(&m, n, o, v).y * fmax(cosine(v, n), 0) *
                                      (2 + cosine(v, bright)));
        }
        const double a = running_standard_error(&own), b = running_standard_error(&uniform);
        given("%s, alpha = %g, n = " VEC ", o = " VEC ": the light by surface_scatter, against "
              "that by uniform directions",
              m.lobe == GGX ? "GGX" : "Lambert", (double)m.alpha, ARG(n), ARG(o));
        const double mean_light = own.mean;
        CHECK_REAL(mean_light, uniform.mean, standard_errors(5, sqrt(a * a + b * b) + 1e-7));
    }
}

// ---- lamps -------------------------------------------------------------------------------

static const color black = {0, 0, 0};
static const surface white_wall = {LAMBERT, {(real)0.5, (real)0.5, (real)0.5}, {0, 0, 0}, 0};
static const surface bright = {LAMBERT, {0, 0, 0}, {1, 1, 1}, 0};

// Source: van Oosterom and Strackee 1983.
static double triangle_solid_angle(triangle T, vec3 x) {
    const wide3 a = wide_sub(T.p1, x), b = wide_sub(T.p2, x), c = wide_sub(T.p3, x);
    const double la = sqrt(wide_dot(a, a)), lb = sqrt(wide_dot(b, b)),
                 lc = sqrt(wide_dot(c, c));
    const double volume = fabs(wide_dot(a, wide_cross(b, c)));
    const double rest =
        la * lb * lc + wide_dot(a, b) * lc + wide_dot(b, c) * la + wide_dot(c, a) * lb;
    return 2 * atan2(volume, rest);
}

// A sphere, and a mesh of two triangles (of unlike sizes) that shines away from x.
static void aims_belong(void) {
    rng g = check_rng(93);
    for (int i = 0; i < 20; i++) {
        const vec3 x = in_cube(&g), n = generic_unit(&g);
        const sphere balls[] = {sphere_above(x, n, 0.5, 3, 2), sphere_above(x, n, 0.3, -4, 1)};
        const vec3 up = add(x, scale((real)2.5, n)); // no corner near x: 1/p would vary wildly
        vec3 corners[4];
        for (int k = 0; k < COUNT(corners); k++) corners[k] = add(up, in_cube(&g));
        const int which[][3] = {{0, 1, 2}, {1, 3, 2}};
        const mesh m = {.points = corners, .corners = which, .count = 2};
        const scene bodies = {
            .spheres = balls, .sphere_count = 2, .meshes = &m, .mesh_count = 1};
        const surface surfaces[] = {bright, white_wall, bright};
        lamps all = lamps_find(&bodies, surfaces);
        CHECK_INT(all.count, 2);
        running omega = {0};
        for (int k = 0; k < 2000; k++) {
            const aim a = lamps_aim(&all, x, &g);
            given("x = " VEC ": an aim at body %d, v = " VEC, ARG(x), a.body, ARG(a.v));
            CHECK(a.body == 0 || a.body == 2, "it aims at what shines");
            CHECK_REAL(wide_length(a.v), 1, roundings(16, "a unit vector"));
            running_add(&omega, 1 / (double)lamps_probability(&all, a.body, x, a.on));
        }
        CHECK_REAL(lamps_probability(&all, 1, x, (hit){0}), 0, exactly());
        given("x = " VEC ", a sphere and a mesh: the mean of 1/p over 2000 aims is the sum of "
              "their solid angles",
              ARG(x));
        const double expected = 2 * PI * cone_of(balls[0], x).width +
                                triangle_solid_angle(mesh_triangle(&m, 0), x) +
                                triangle_solid_angle(mesh_triangle(&m, 1), x);
        CHECK_MEAN("the mean of 1/p", &omega, expected, 1e-5);
        const vec3 inside = add(balls[0].c, scale((real)0.25, in_cube(&g)));
        for (int k = 0; k < 20; k++) {
            given("x = " VEC ", in the lamp that is body 0", ARG(inside));
            CHECK(lamps_aim(&all, inside, &g).body != 0, "a lamp that x is in is not aimed at");
        }
        lamps_free(&all);
    }
}

// r/|x - c| of a few millionths: every aim must still meet it, or its light is lost.
static void aims_at_tiny_spheres(void) {
    rng g = check_rng(94);
    for (int i = 0; i < 40; i++) {
        const vec3 x = in_cube(&g);
        const sphere S = sphere_at(x, 1000, 1e-3 * (1 + i % 5), &g);
        const scene bodies = {.spheres = &S, .sphere_count = 1};
        lamps all = lamps_find(&bodies, &bright);
        running p = {0};
        for (int k = 0; k < 500; k++) {
            const aim a = lamps_aim(&all, x, &g);
            const bool found = a.body == 0 && a.on.front;
            running_add(&p, found && lamps_probability(&all, 0, x, a.on) > 0 ? 1 : 0);
        }
        GIVEN_SPHERE(S, x, "the share of the aims at this lamp that find it");
        const double share_found = p.mean;
        CHECK_REAL(share_found, 1, absolute_of(0, "none is lost by rounding at the rim"));
        lamps_free(&all);
    }
}

// ---- light_trace -------------------------------------------------------------------------

static const strategy strategies[] = {BY_UNIFORM, BY_BRDF, BY_LAMPS, BY_BALANCE, BY_POWER};
static const char *const strategy_names[] = {"BY_UNIFORM", "BY_BRDF", "BY_LAMPS", "BY_BALANCE",
                                             "BY_POWER"};

static color sky_of_2(vec3 d) {
    (void)d;
    return (color){2, 2, 2};
}

static void constant_sky(void) {
    rng g = check_rng(101);
    const sphere S = {in_cube(&g), (real)1.5};
    const surface skin = {LAMBERT, {(real)0.6, (real)0.6, (real)0.6}, black, 0};
    const scene bodies = {.spheres = &S, .sphere_count = 1, .sky = sky_of_2};
    lit_room sc = lit(bodies, &skin, BY_UNIFORM);
    for (int i = 0; i < COUNT(strategies); i++) {
        sc.strategy = strategies[i];
        running L = {0}, square = {0};
        for (int k = 0; k < 30000; k++) {
            const vec3 O = add(S.c, scale(4, generic_unit(&g)));
            const ray r = {O, sub(add(S.c, in_cube(&g)), O)};
            if (sphere_hit(S, r, 0, NO_HIT) == NO_HIT) continue;
            const double x = light_trace(&sc, r, 4, &g).x;
            running_add(&L, x);
            add_square(&square, x, 1.2);
        }
        given("a lone matte sphere of albedo 0.6 under a sky of 2, %s: the mean light",
              strategy_names[i]);
        CHECK_MEAN("the mean light", &L, 1.2, 1e-7);
        given(
            "the same, %s: the variance of one path: (rho L)²/3 for uniform directions, 0 for "
            "those of the cosine",
            strategy_names[i]);
        if (strategies[i] == BY_UNIFORM)
            CHECK_MEAN("the variance", &square, 1.44 / 3, 0);
        else
            CHECK_REAL(square.mean, 0, absolute_of(1e-12, "every path finds exactly rho L"));
    }
    lit_free(&sc);
}

// The three closed forms, by whole paths.
static void lamp_variance(void) {
    rng g = check_rng(102);
    const variances v = variances_at(3);
    const double expected[] = {v.uniform, v.cosine, v.cone};
    const vec3 n = generic_unit(&g), x = in_cube(&g);
    const sphere S = sphere_above(x, n, 1, 3, 0);
    const plane floor_plane = {x, n};
    const surface surfaces[] = {bright, white_wall};
    const scene bodies = {
        .spheres = &S, .sphere_count = 1, .planes = &floor_plane, .plane_count = 1};
    lit_room sc = lit(bodies, surfaces, BY_UNIFORM);
    const vec3 O = add(x, add(scale(2, perpendicular(n)), n));
    for (int i = 0; i < COUNT(expected); i++) {
        sc.strategy = strategies[i];
        running L = {0}, square = {0};
        for (int k = 0; k < 50000; k++) {
            const double light = 2 * (double)light_trace(&sc, (ray){O, sub(x, O)}, 1, &g).x;
            running_add(&L, light);
            add_square(&square, light, v.mean);
        }
        given("a sphere light straight above, at 3 radii, %s: the mean light",
              strategy_names[i]);
        suspect_factor("the lamp's light is counted twice", 2);
        CHECK_MEAN("the mean light", &L, v.mean, 1e-7);
        given("the same, %s: the variance of one path, in units of (rho L)²",
              strategy_names[i]);
        CHECK_MEAN("the variance", &square, expected[i], 1e-10);
    }
    lit_free(&sc);
}

// A lamp of radius 1 at a distance of a million, straight above: rho (r/d)² L.
static void tiny_lamp(void) {
    rng g = check_rng(103);
    const vec3 n = generic_unit(&g), x = in_cube(&g);
    const sphere S = sphere_above(x, n, 1, 1e6, 0);
    const plane floor_plane = {x, n};
    const surface surfaces[] = {bright, white_wall};
    const scene bodies = {
        .spheres = &S, .sphere_count = 1, .planes = &floor_plane, .plane_count = 1};
    lit_room sc = lit(bodies, surfaces, BY_LAMPS);
    const vec3 O = add(x, add(scale(2, perpendicular(n)), n));
    running L = {0};
    for (int k = 0; k < 5000; k++)
        running_add(&L, 2e12 * (double)light_trace(&sc, (ray){O, sub(x, O)}, 1, &g).x);
    given(
        "a sphere light straight above, at a million radii, BY_LAMPS: the mean light in units "
        "of rho (r/d)² L");
    const double mean_light = L.mean;
    CHECK_REAL(mean_light, 1, absolute_of(0.002, "the end of a shadow ray is rounded too"));
    lit_free(&sc);
}

// All strategies must find the same light; BY_POWER, the least noisy, is what the
// others are compared with.
static void same_means(lit_room *sc, const camera *cam, int width, int height, long paths,
                       int depth, uint64_t stream) {
    double mean = 0, error = 0;
    for (int i = COUNT(strategies) - 1; i >= 0; i--) {
        rng g = check_rng(stream + (uint64_t)i);
        sc->strategy = strategies[i];
        running L = {0};
        for (long k = 0; k < paths; k++) {
            const real a = rng_real(&g) * (real)width, b = rng_real(&g) * (real)height;
            const color c = light_trace(sc, camera_ray(cam, a, b), depth, &g);
            running_add(&L, (double)c.x + (double)c.y + (double)c.z);
        }
        const double own = running_standard_error(&L);
        given("%ld paths of at most %d bounces, %s against BY_POWER", paths, depth,
              strategy_names[strategies[i]]);
        const double mean_light = L.mean;
        if (strategies[i] == BY_POWER)
            mean = L.mean, error = own;
        else
            CHECK_REAL(mean_light, mean, standard_errors(5, sqrt(own * own + error * error)));
    }
}

static void box_means(void) {
    surface surfaces[BOX_BODIES];
    for (int i = 0; i < BOX_BODIES; i++)
        surfaces[i] = (surface){LAMBERT, box_surfaces[i].albedo, box_surfaces[i].emittance, 1};
    surfaces[BALL_RIGHT].lobe = GGX, surfaces[BALL_RIGHT].alpha = (real)0.3;
    lit_room sc = lit(box_bodies, surfaces, BY_UNIFORM);
    const camera cam = box_camera(100, 80);
    same_means(&sc, &cam, 100, 80, 25000, 5, 110);
    lit_free(&sc);
}

static color dim_sky(vec3 d) {
    const real high = (real)0.1 * (2 + normalize(d).y);
    return (color){high, high, high};
}

// A large spherical lamp and a small one, a lamp of two triangles, under a sky.
static void sphere_means(void) {
    static const sphere balls[] = {{{-2, 2, -6}, 1},
                                   {{2, (real)1.5, -5}, (real)0.3},
                                   {{0, 0, -6}, 1},
                                   {{(real)1.8, (real)-0.3, -4}, (real)0.7}};
    static const plane floor_plane = {{0, -1, 0}, {0, 1, 0}};
    static const vec3 corners[] = {{0, 2, -3}, {1, 2, -3}, {1, (real)2.5, -5}, {0, 3, -5}};
    static const int which[][3] = {{0, 2, 1}, {0, 3, 2}};
    static const mesh roof = {.points = corners, .corners = which, .count = 2};
    const surface surfaces[] = {{LAMBERT, {(real)0.5, (real)0.5, (real)0.5}, {1, 2, 1}, 0},
                                {LAMBERT, black, {9, 6, 4}, 0},
                                {GGX, {(real)0.9, (real)0.8, (real)0.7}, black, (real)0.4},
                                white_wall,
                                {GGX, {(real)0.3, (real)0.3, (real)0.3}, black, (real)0.6},
                                {LAMBERT, {(real)0.5, (real)0.5, (real)0.5}, {3, 3, 3}, 0}};
    const scene bodies = {.spheres = balls,
                          .sphere_count = COUNT(balls),
                          .planes = &floor_plane,
                          .plane_count = 1,
                          .meshes = &roof,
                          .mesh_count = 1,
                          .sky = dim_sky};
    lit_room sc = lit(bodies, surfaces, BY_UNIFORM);
    const camera cam =
        camera_look_at((vec3){0, 1, 1}, (vec3){0, (real)0.5, -5}, (vec3){0, 1, 0}, 60, 100, 80);
    same_means(&sc, &cam, 100, 80, 40000, 4, 120);
    lit_free(&sc);
}

// Rooms of anything, in which light may be hard to find but never negative or no number.
static surface any_surface(rng *g) {
    const int kind = (int)(rng_bits(g) % 8);
    surface m = some_surface(kind, g);
    if (rng_bits(g) % 3 == 0) m.emittance = (color){1, (real)pow(10, between(g, -3, 3)), 1};
    if (m.lobe == GGX && rng_bits(g) % 4 == 0) m.alpha = (real)0.001;
    return m;
}

static void clean_light(void) {
    rng g = check_rng(131);
    for (int i = 0; i < 500; i++) {
        sphere balls[3];
        vec3 corners[6];
        surface surfaces[6];
        plane walls[2];
        for (int k = 0; k < 3; k++) {
            balls[k].c = in_cube(&g);
            balls[k].r = (real)pow(10, between(&g, -4, k == 2 ? 1 : -0.3));
        }
        for (int k = 0; k < 6; k++) corners[k] = in_cube(&g), surfaces[k] = any_surface(&g);
        for (int k = 0; k < 2; k++)
            walls[k].x = scale(3, in_cube(&g)), walls[k].n = test_normal(k ? i : 9, &g);
        const int which[][3] = {{0, 1, 2}, {3, 4, 5}};
        const mesh m = {.points = corners, .corners = which, .count = 2};
        const scene bodies = {.spheres = balls,
                              .sphere_count = 3,
                              .planes = walls,
                              .plane_count = 2,
                              .meshes = &m,
                              .mesh_count = 1,
                              .sky = i % 2 ? dim_sky : NULL};
        lit_room sc = lit(bodies, surfaces, strategies[i % COUNT(strategies)]);
        for (int k = 0; k < 100; k++) {
            const vec3 O = scale(2, in_cube(&g)), d = in_cube(&g);
            const ray r = {O, d};
            const int depth = k % 13;
            const color L = light_trace(&sc, r, depth, &g);
            given("room %d, %s, at most %d bounces, ray O = " VEC ", d = " VEC ": " VEC, i,
                  strategy_names[i % COUNT(strategies)], depth, ARG(r.O), ARG(r.d), ARG(L));
            CHECK(is_finite(L), "finite, no NaN");
            CHECK(L.x >= 0 && L.y >= 0 && L.z >= 0, "light is never negative");
        }
        lit_free(&sc);
    }
}

#endif
