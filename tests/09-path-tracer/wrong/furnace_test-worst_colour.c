// Wrong: the worst of the three colours, which is off more often than one.
// Expect: One value a path
#include "chapters/09-path-tracer/path.h"

enum { BOUNCES = 10 }; // one is enough for a right tracer

static color unit_sky(vec3 d) {
    (void)d;
    return (color){1, 1, 1};
}

// From anywhere around S to anywhere in it.
static ray towards(sphere S, rng *g) {
    const vec3 O = add(S.c, scale(3 * S.r, unit_vector(g)));
    const vec3 inside = add(S.c, scale((real)0.9 * S.r, unit_vector(g)));
    return (ray){O, sub(inside, O)};
}

double furnace_test(path_tracer f, real albedo, long n, rng *g) {
    const sphere ball = {{(real)0.3, (real)-0.7, (real)0.4}, (real)1.3};
    const matte skin = {{albedo, albedo, albedo}, {1, 1, 1}};
    const room furnace = {{.spheres = &ball, .sphere_count = 1, .sky = unit_sky}, &skin};
    const double truth = 1 + (double)albedo;
    running light[3] = {{0}};
    for (long i = 0; i < n; i++) {
        const color L = f(&furnace, towards(ball, g), BOUNCES, g);
        running_add(&light[0], (double)L.x);
        running_add(&light[1], (double)L.y);
        running_add(&light[2], (double)L.z);
    }
    double worst = 0;
    for (int k = 0; k < 3; k++) {
        const double off = light[k].mean - truth;
        const double z = off / running_standard_error(&light[k]);
        const bool rounded = fabs(off) <= 4 * (double)REAL_EPSILON * truth;
        if (!rounded && !(fabs(z) <= fabs(worst))) worst = z;
    }
    return worst;
}
