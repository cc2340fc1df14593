// samplers.h: ways to choose directions and points, how well they do it and what they cost;
// the energy that rough metal loses. measure.c prints it.
#ifndef CHAPTER_SAMPLERS_H
#define CHAPTER_SAMPLERS_H

#include "chapters/10-importance-sampling/scenes.h"

enum { DRAWS = 100000, TIMED_DRAWS = 1 << 12, SAMPLER_ROUNDS = 9 };

// Σ (n - expected)² / expected over cells of equal probability, for each degree of
// freedom: about 1 when the density is right.
static double chi2_of_cells(const int *n, int cells) {
    const double expected = (double)DRAWS / cells;
    double sum = 0;
    for (int i = 0; i < cells; i++) sum += (n[i] - expected) * (n[i] - expected) / expected;
    return sum / (cells - 1);
}

// ---- cosine --------------------------------------------------------------------------

static vec3 lifted(vec3 n, real a, real b) {
    const vec3 local = {a, b, sqrt(fmax(1 - a * a - b * b, 0))};
    return keep_unit(to_world(orthonormal_basis(n), local));
}

static vec3 cosine_polar(vec3 n, rng *g) {
    const real phi = (real)(2 * PI) * rng_real(g);
    const real radius = sqrt(rng_real(g));
    return lifted(n, radius * cos(phi), radius * sin(phi));
}

// Squares to rings: neighbours stay neighbours. Source: Shirley and Chiu 1997.
static vec3 cosine_concentric(vec3 n, rng *g) {
    const real a = 2 * rng_real(g) - 1;
    const real b = 2 * rng_real(g) - 1;
    if (a == 0 && b == 0) return n;
    const bool wide = fabs(a) > fabs(b);
    const real radius = wide ? a : b;
    const real phi =
        wide ? (real)(PI / 4) * (b / a) : (real)(PI / 2) - (real)(PI / 4) * (a / b);
    return lifted(n, radius * cos(phi), radius * sin(phi));
}

static vec3 cosine_disc(vec3 n, rng *g) {
    return cosine_direction(n, g);
}

static vec3 cosine_sum(vec3 n, rng *g) {
    return matte_bounce(n, g);
}

static const vec3 tilted = {(real)0.48, (real)-0.6, (real)0.64};

#define TIMED_COSINE(f)                                               \
    static void run_##f(void *data) {                                 \
        rng g = *(const rng *)data;                                   \
        real sum = 0;                                                 \
        for (int i = 0; i < TIMED_DRAWS; i++) sum += f(tilted, &g).x; \
        keep((double)sum);                                            \
    }
TIMED_COSINE(cosine_disc)
TIMED_COSINE(cosine_sum)
TIMED_COSINE(cosine_polar)
TIMED_COSINE(cosine_concentric)

static const struct {
    const char *name;
    vec3 (*draw)(vec3 n, rng *g);
    timed run;
} cosines[] = {
    {"disc by rejection", cosine_disc, {"disc", run_cosine_disc}},
    {"n + unit sphere", cosine_sum, {"sum", run_cosine_sum}},
    {"disc by angle and radius", cosine_polar, {"polar", run_cosine_polar}},
    {"disc, concentric", cosine_concentric, {"concentric", run_cosine_concentric}},
};

// cos² θ and φ are uniform: 16 x 16 cells.
static double chi2_of_cosine(vec3 (*draw)(vec3 n, rng *g)) {
    int cells[16 * 16] = {0};
    const frame f = orthonormal_basis(tilted);
    rng g = rng_seed(10, 1);
    for (int i = 0; i < DRAWS; i++) {
        const vec3 v = to_local(f, draw(tilted, &g));
        const int row = (int)(16 * v.z * v.z),
                  column = (int)(16 * (atan2(v.y, v.x) / (2 * PI) + 0.5));
        cells[16 * (row < 16 ? row : 15) + column % 16]++;
    }
    return chi2_of_cells(cells, COUNT(cells));
}

static void measure_cosines(void) {
    double ns[COUNT(cosines)];
    timed runs[COUNT(cosines)];
    rng g = rng_seed(10, 2);
    for (int v = 0; v < COUNT(cosines); v++) runs[v] = cosines[v].run;
    measure_ns(runs, COUNT(cosines), &g, TIMED_DRAWS, SAMPLER_ROUNDS, ns);
    for (int v = 0; v < COUNT(cosines); v++)
        csv_row("sampler: cosine", cosines[v].name, "draws", DRAWS,
                "chi² for each degree of freedom", chi2_of_cosine(cosines[v].draw), "ns",
                ns[v]);
}

// ---- a round lamp --------------------------------------------------------------------

// One estimate of E / π under a sphere of radiance 1: L (n·v) / p / π. It stands straight
// above x = 0; n = (0, 0, 1).
typedef double estimate_E(sphere S, rng *g);

static double lit_by(sphere S, vec3 v, real p) {
    if (!(v.z > 0) || sphere_hit(S, (ray){{0, 0, 0}, v}, 0, NO_HIT) == NO_HIT) return 0;
    return (double)v.z / ((double)p * PI);
}

static const vec3 upwards = {0, 0, 1};

static double by_uniform(sphere S, rng *g) {
    return lit_by(S, hemisphere_direction(upwards, g), (real)(1 / (2 * PI)));
}

static double by_cosine(sphere S, rng *g) {
    const vec3 v = cosine_direction(upwards, g);
    return lit_by(S, v, cosine_probability(upwards, v));
}

// A uniform point of the whole sphere: half of them face away.
static double by_area(sphere S, rng *g) {
    const vec3 out = unit_vector(g), y = add(S.c, scale(S.r, out));
    if (dot(out, y) >= 0) return 0;
    const real p = solid_angle_probability((vec3){0, 0, 0}, y, out, (real)(4 * PI) * S.r * S.r);
    return y.z > 0 ? (double)(y.z / length(y)) / ((double)p * PI) : 0;
}

static double by_cone(sphere S, rng *g) {
    const vec3 v = sphere_direction(S, (vec3){0, 0, 0}, g);
    return (double)v.z / ((double)sphere_probability(S, (vec3){0, 0, 0}, v) * PI);
}

#define TIMED_LAMP(f)                                           \
    static void run_##f(void *data) {                           \
        const sphere *S = data;                                 \
        rng g = rng_seed(10, 3);                                \
        double sum = 0;                                         \
        for (int i = 0; i < TIMED_DRAWS; i++) sum += f(*S, &g); \
        keep(sum);                                              \
    }
TIMED_LAMP(by_uniform)
TIMED_LAMP(by_cosine)
TIMED_LAMP(by_area)
TIMED_LAMP(by_cone)

static const struct {
    const char *name;
    estimate_E *estimate;
    timed run;
} lamp_ways[] = {
    {"uniform direction", by_uniform, {"uniform", run_by_uniform}},
    {"cosine", by_cosine, {"cosine", run_by_cosine}},
    {"point of the whole sphere", by_area, {"area", run_by_area}},
    {"cone", by_cone, {"cone", run_by_cone}},
};

static void measure_lamp(double distance) {
    sphere S = {{0, 0, (real)distance}, 1};
    double ns[COUNT(lamp_ways)];
    timed runs[COUNT(lamp_ways)];
    for (int v = 0; v < COUNT(lamp_ways); v++) runs[v] = lamp_ways[v].run;
    measure_ns(runs, COUNT(lamp_ways), &S, TIMED_DRAWS, SAMPLER_ROUNDS, ns);
    for (int v = 0; v < COUNT(lamp_ways); v++) {
        rng g = rng_seed(10, 4);
        running E = {0};
        for (int i = 0; i < DRAWS; i++) running_add(&E, lamp_ways[v].estimate(S, &g));
        csv_row("sampler: round lamp", lamp_ways[v].name, "distance / radius", distance,
                "variance of one estimate of E / π", running_variance(&E), "ns", ns[v]);
    }
}

// ---- a triangle ----------------------------------------------------------------------

static const triangle some_T = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

static triangle_point triangle_root(triangle T, rng *g) {
    (void)T;
    const real root = sqrt(rng_real(g));
    const real share = rng_real(g);
    return (triangle_point){0, root * (1 - share), root * share};
}

static triangle_point triangle_fold(triangle T, rng *g) {
    return triangle_sample(T, g);
}

#define TIMED_TRIANGLE(f)                                             \
    static void run_##f(void *data) {                                 \
        rng g = *(const rng *)data;                                   \
        real sum = 0;                                                 \
        for (int i = 0; i < TIMED_DRAWS; i++) sum += f(some_T, &g).u; \
        keep((double)sum);                                            \
    }
TIMED_TRIANGLE(triangle_fold)
TIMED_TRIANGLE(triangle_root)

// Lines parallel to the sides cut the triangle into 64 equal ones. In square (a, b) of the
// grid lies one below the diagonal and, mirrored into the empty half, one above it.
static double chi2_of_triangle(triangle_point (*draw)(triangle T, rng *g)) {
    int cells[64] = {0};
    rng g = rng_seed(10, 5);
    for (int i = 0; i < DRAWS; i++) {
        const triangle_point q = draw(some_T, &g);
        const int a = (int)(8 * q.u), b = (int)(8 * q.v), c = (int)(8 * (1 - q.u - q.v));
        const int cell = 8 * a + b;
        cells[a + b + c == 7 ? cell : 63 - cell]++;
    }
    return chi2_of_cells(cells, COUNT(cells));
}

static void measure_triangles(void) {
    const timed runs[] = {{"fold", run_triangle_fold}, {"root", run_triangle_root}};
    double ns[COUNT(runs)];
    rng g = rng_seed(10, 6);
    measure_ns(runs, COUNT(runs), &g, TIMED_DRAWS, SAMPLER_ROUNDS, ns);
    const char *table = "sampler: triangle", *error = "chi² for each degree of freedom";
    csv_row(table, "folded parallelogram", "draws", DRAWS, error,
            chi2_of_triangle(triangle_fold), "ns", ns[0]);
    csv_row(table, "square root", "draws", DRAWS, error, chi2_of_triangle(triangle_root), "ns",
            ns[1]);
}

// ---- rough metal ---------------------------------------------------------------------

// One estimate of the albedo of a perfect rough mirror (F = 1): f_r (n·v) / p, 0 for a
// direction below the surface.
typedef double estimate_albedo(vec3 o, real alpha, rng *g);

static double by_visible(vec3 o, real alpha, rng *g) {
    const vec3 v = neg(reflect(o, ggx_normal(o, alpha, g)));
    return v.z > 0 ? (double)ggx_weight(o, v, alpha) : 0;
}

// h with the density D(h) h.z, seen or not: tan² θ = alpha² u / (1 - u).
static double by_all_normals(vec3 o, real alpha, rng *g) {
    const real u = rng_real(g);
    const real phi = (real)(2 * PI) * rng_real(g);
    const real z = 1 / sqrt(1 + alpha * alpha * u / (1 - u)), sine = sqrt(fmax(1 - z * z, 0));
    const vec3 h = {sine * cos(phi), sine * sin(phi), z};
    const vec3 v = neg(reflect(o, h));
    const real p = ggx_density(h, alpha) * z / (4 * fabs(dot(o, h)));
    return v.z > 0 && p > 0 ? (double)(ggx_brdf(o, v, alpha) * v.z / p) : 0;
}

static double by_lambert(vec3 o, real alpha, rng *g) {
    const vec3 v = cosine_direction(upwards, g);
    const real p = cosine_probability(upwards, v);
    return p > 0 ? (double)(ggx_brdf(o, v, alpha) * v.z / p) : 0;
}

typedef struct {
    vec3 o;
    real alpha;
} view;

static vec3 at_cosine(double z) {
    return (vec3){(real)(0.6 * sqrt(1 - z * z)), (real)(0.8 * sqrt(1 - z * z)), (real)z};
}

#define TIMED_GGX(f)                                                        \
    static void run_##f(void *data) {                                       \
        const view *w = data;                                               \
        rng g = rng_seed(10, 7);                                            \
        double sum = 0;                                                     \
        for (int i = 0; i < TIMED_DRAWS; i++) sum += f(w->o, w->alpha, &g); \
        keep(sum);                                                          \
    }
TIMED_GGX(by_lambert)
TIMED_GGX(by_all_normals)
TIMED_GGX(by_visible)

static const struct {
    const char *name;
    estimate_albedo *estimate;
    timed run;
} metals[] = {
    {"cosine", by_lambert, {"cosine", run_by_lambert}},
    {"D cos θ", by_all_normals, {"D cos", run_by_all_normals}},
    {"visible normals", by_visible, {"visible", run_by_visible}},
};

static void measure_metal(const char *table, const char *x_name, double x, double cosine,
                          double alpha, bool clocked) {
    view w = {at_cosine(cosine), (real)alpha};
    double ns[COUNT(metals)];
    timed runs[COUNT(metals)];
    for (int v = 0; v < COUNT(metals); v++) runs[v] = metals[v].run, ns[v] = NAN;
    if (clocked) measure_ns(runs, COUNT(metals), &w, TIMED_DRAWS, SAMPLER_ROUNDS, ns);
    for (int v = 0; v < COUNT(metals); v++) {
        rng g = rng_seed(10, 8);
        running a = {0};
        for (int i = 0; i < DRAWS; i++) running_add(&a, metals[v].estimate(w.o, w.alpha, &g));
        csv_row(table, metals[v].name, x_name, x, "variance of one estimate of the albedo",
                running_variance(&a), "ns", ns[v]);
    }
}

static void measure_samplers(void) {
    static const double distances[] = {1.01, 1.5, 3, 10, 100},
                        alphas[] = {0.01, 0.05, 0.1, 0.2, 0.5, 1},
                        cosines_of_view[] = {1, 0.5, 0.2, 0.05, 0.01};
    measure_cosines();
    for (int i = 0; i < COUNT(distances); i++) measure_lamp(distances[i]);
    measure_triangles();
    for (int i = 0; i < COUNT(alphas); i++)
        measure_metal("sampler: metal, roughness", "alpha", alphas[i], 0.5, alphas[i], true);
    for (int i = 0; i < COUNT(cosines_of_view); i++)
        measure_metal("sampler: metal, grazing", "cos θ", cosines_of_view[i],
                      cosines_of_view[i], 0.2, false);
}

// ---- energy --------------------------------------------------------------------------

// What a perfect rough mirror does not give back: light that would need a second bounce
// between its microscopic facets. cosine 0: the mean over all directions, by the cosine.
static void measure_loss(const char *name, double cosine, double alpha) {
    rng g = rng_seed(10, 9);
    running kept = {0};
    for (int i = 0; i < DRAWS; i++) {
        const vec3 o = cosine > 0 ? at_cosine(cosine) : cosine_direction(upwards, &g);
        running_add(&kept, by_visible(o, (real)alpha, &g));
    }
    csv_row("metal: energy lost", name, "alpha", alpha, "share of the light", 1 - kept.mean,
            "ns", NAN);
}

static void measure_energy(void) {
    static const double alphas[] = {0.01, 0.1, 0.3, 0.5, 0.8, 1};
    for (int i = 0; i < COUNT(alphas); i++) {
        measure_loss("straight on", 1, alphas[i]);
        measure_loss("60° from the normal", 0.5, alphas[i]);
        measure_loss("all directions", 0, alphas[i]);
    }
}

#endif
