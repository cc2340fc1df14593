#include "chapters/09-path-tracer/path.h"

enum { BOUNCES = 50 };

static color unit_sky(vec3 d) {
    (void)d;
    return (color){1, 1, 1};
}

double furnace_test(path_tracer f, real albedo, long n, rng *g) {
    const sphere ball = {{0, 0, 0}, 1};
    const matte skin = {.albedo = {albedo, albedo, albedo}};
    const room furnace = {{.spheres = &ball, .sphere_count = 1, .sky = unit_sky}, &skin};
    running light = {0};
    for (long i = 0; i < n; i++) {
        const vec3 O = scale(3, unit_vector(g)), p = scale((real)0.9, unit_vector(g));
        const color L = f(&furnace, (ray){O, sub(p, O)}, BOUNCES, g);
        running_add(&light, (double)L.x);
    }
    const double off = light.mean - (double)albedo;
    if (fabs(off) <= 8 * REAL_EPSILON) return 0;
    return off / running_standard_error(&light);
}
