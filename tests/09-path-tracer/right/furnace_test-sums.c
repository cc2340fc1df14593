// Right: from the sum and the sum of squares, along one fixed ray.
#include "chapters/09-path-tracer/path.h"

static color unit_sky(vec3 d) {
    (void)d;
    return (color){1, 1, 1};
}

double furnace_test(path_tracer f, real albedo, long n, rng *g) {
    const sphere ball = {{2, 1, -4}, 2};
    const matte skin = {{albedo, albedo, albedo}, {1, 1, 1}};
    const room furnace = {{.spheres = &ball, .sphere_count = 1, .sky = unit_sky}, &skin};
    const ray r = {{0, 0, 0}, {2, 2, -4}};
    double sum = 0, squares = 0; // of what is too much
    for (long i = 0; i < n; i++) {
        const color L = f(&furnace, r, 1, g);
        const double off = ((double)L.x + (double)L.y + (double)L.z) / 3 - 1 - (double)albedo;
        sum += off;
        squares += off * off;
    }
    const double mean = sum / (double)n;
    if (fabs(mean) < 10 * (double)REAL_EPSILON) return 0;
    const double variance = (squares - (double)n * mean * mean) / (double)(n - 1);
    return variance > 1e-20 ? mean / sqrt(variance / (double)n)
                            : copysign((double)INFINITY, mean);
}
