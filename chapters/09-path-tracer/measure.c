// measure.c: the error against the number of paths, where a path ends, what is
// averaged, the slide's slip, and recursion against the loop.
#include "chapters/09-path-tracer/box.h"

enum { CASES = 4096, ROUNDS = 9 };

static color white_sky(vec3 d) {
    (void)d;
    return (color){1, 1, 1};
}

// ---- scenes --------------------------------------------------------------------------

typedef struct {
    const char *name;
    room sc;
    ray r;
    double truth; // of the red light along r
} view;

static const sphere ball = {{0, 0, 0}, 1};
static const matte grey_skin = {.albedo = {(real)0.5, (real)0.5, (real)0.5}};

// A lamp of radius 1 and radiance 1 at the height 3 above a floor of albedo 0.5.
static const sphere lamp = {{0, 3, 0}, 1};
static const plane ground = {{0, 0, 0}, {0, 1, 0}};
static const matte lamp_and_ground[] = {{.emittance = {1, 1, 1}},
                                        {.albedo = {(real)0.5, (real)0.5, (real)0.5}}};

// The box's floor, below the middle of the picture: red, by 8e7 other paths, with a
// standard error of 5e-4 of it.
static const double floor_light = 0.4729;

static ray floor_ray(void) {
    const camera cam = box_camera(100, 100);
    return camera_ray(&cam, 50, 92);
}

static void fill_views(view *v) {
    v[0] = (view){"a ball in a furnace",
                  {{.spheres = &ball, .sphere_count = 1, .sky = white_sky}, &grey_skin},
                  {{0, 3, 3}, {0, (real)-0.8, -1}},
                  0.5};
    v[1] = (view){"a floor, a ball lamp at 3 radii",
                  {{.spheres = &lamp, .sphere_count = 1, .planes = &ground, .plane_count = 1},
                   lamp_and_ground},
                  {{-1, 1, 0}, {1, -1, 0}},
                  0.5 / 9};
    v[2] = (view){"the box's floor", {box_bodies, box_surfaces}, floor_ray(), floor_light};
}

// ---- the error against the number of paths -----------------------------------------------

static double mean_of_paths(const view *v, int n, rng *g) {
    double sum = 0;
    for (int i = 0; i < n; i++) sum += (double)path_trace(&v->sc, v->r, 100, g).x;
    return sum / n;
}

static void run_view(void *data) {
    const view *v = data;
    rng g = rng_seed(9, 1);
    keep(mean_of_paths(v, CASES, &g));
}

static void measure_samples(void) {
    enum { RUNS = 128 };
    view views[3];
    fill_views(views);
    for (int i = 0; i < COUNT(views); i++) {
        double ns;
        const timed timing = {views[i].name, run_view};
        measure_ns(&timing, 1, &views[i], CASES, ROUNDS, &ns);
        csv_row("cost of a path", views[i].name, "paths", 1, "not measured", NAN, "ns", ns);
        for (int n = 1; n <= CASES; n *= 4) {
            rng g = rng_seed(9, 2);
            double squares = 0;
            for (int k = 0; k < RUNS; k++) {
                const double off = mean_of_paths(&views[i], n, &g) / views[i].truth - 1;
                squares += off * off;
            }
            csv_row("error against paths", views[i].name, "paths", n, "relative RMSE",
                    sqrt(squares / RUNS), "ns", ns * n);
        }
    }
}

// ---- where a path ends ---------------------------------------------------------------------
// In a closed room each wall of which shines with 1: the light is 1/(1 - a). The cosine
// of a uniform direction is uniform, whatever the room, so none is built.

// The chance to go on after a bounce; x is the rule's own number.
typedef real rule(real x, real a, real C, int bounce);

static real cut(real x, real a, real C, int bounce) {
    (void)a, (void)C;
    return (real)bounce < x;
}

static real fixed(real x, real a, real C, int bounce) {
    (void)a, (void)C, (void)bounce;
    return x;
}

static real by_albedo(real x, real a, real C, int bounce) {
    (void)x, (void)C, (void)bounce;
    return a;
}

static real by_weight(real x, real a, real C, int bounce) {
    (void)a, (void)bounce;
    return fmin(C, x);
}

static real as_path_trace(real x, real a, real C, int bounce) {
    (void)x, (void)a;
    return survival((color){C, C, C}, bounce);
}

typedef struct {
    const char *name;
    rule *survives;
    real x;
} ending;

static const ending endings[] = {
    {"cut at s = 1", cut, 1},
    {"cut at s = 3", cut, 3},
    {"cut at s = 10", cut, 10},
    {"roulette, q = 0.5", fixed, (real)0.5},
    {"roulette, q = 0.9", fixed, (real)0.9},
    {"roulette, q = albedo", by_albedo, 0},
    {"roulette, q = C, at most 0.95", by_weight, (real)0.95},
    {"the same after 3 sure bounces: survival", as_path_trace, 0},
};

// The light of one path; counts its rays.
static double one_path(const ending *e, real a, long *rays, rng *g) {
    double L = 0;
    real C = 1;
    for (int bounce = 0;; bounce++) {
        *rays += 1;
        L += (double)C;
        C *= 2 * a * rng_real(g);
        const real weight = roulette(e->survives(e->x, a, C, bounce), g);
        if (weight == 0) return L;
        C *= weight;
    }
}

static void measure_end(const ending *e, double a) {
    enum { PATHS = 400000 };
    rng g = rng_seed(9, 3);
    running light = {0};
    long rays = 0;
    for (int n = 0; n < PATHS; n++) running_add(&light, one_path(e, (real)a, &rays, &g));
    const double each = (double)rays / PATHS, variance = running_variance(&light);
    const struct {
        const char *table, *what;
        double value;
    } rows[] = {
        {"end: light missing", "mean / truth - 1", light.mean * (1 - a) - 1},
        {"end: rays", "rays per path", each},
        {"end: variance", "variance", variance},
        {"end: efficiency", "1 / (variance x rays)", 1 / (variance * each)},
    };
    for (int i = 0; i < COUNT(rows); i++)
        csv_row(rows[i].table, e->name, "albedo", a, rows[i].what, rows[i].value, "ns", NAN);
}

static void measure_ends(void) {
    const double albedos[] = {0.3, 0.5, 0.7};
    for (int k = 0; k < COUNT(endings); k++)
        for (int i = 0; i < COUNT(albedos); i++) measure_end(&endings[k], albedos[i]);
}

// ---- white rooms -----------------------------------------------------------------------------
// The variance of a path cut at s: with B = 4a²/3 the mean of C_j C_k is B^j a^(k-j), j <= k.

static double variance_of_cut(double a, int s) {
    const double B = 4 * a * a / 3;
    double mean = 0, square = 0;
    for (int j = 0; j <= s; j++) {
        mean += pow(a, j);
        for (int k = j; k <= s; k++) square += (j == k ? 1 : 2) * pow(B, j) * pow(a, k - j);
    }
    return square - mean * mean;
}

static double variance_measured(double a, int s) {
    rng g = rng_seed(9, 4);
    running light = {0};
    for (int n = 0; n < 20000; n++) {
        double C = 1, L = 1;
        for (int k = 1; k <= s; k++) {
            C *= 2 * a * rng_double(&g);
            L += C;
        }
        running_add(&light, L);
    }
    return running_variance(&light);
}

static void measure_white(void) {
    static const struct {
        const char *name;
        double (*variance)(double a, int s);
        double albedo;
    } rows[] = {
        {"albedo 0.5, closed form", variance_of_cut, 0.5},
        {"albedo 0.5, 20,000 paths", variance_measured, 0.5},
        {"albedo 0.8, closed form", variance_of_cut, 0.8},
        {"albedo 0.8, 20,000 paths", variance_measured, 0.8},
        {"albedo 0.9, closed form", variance_of_cut, 0.9},
        {"albedo 0.9, 20,000 paths", variance_measured, 0.9},
        {"albedo 0.95, closed form", variance_of_cut, 0.95},
        {"albedo 0.95, 20,000 paths", variance_measured, 0.95},
    };
    for (int i = 0; i < COUNT(rows); i++)
        for (int s = 4; s <= 256; s *= 4)
            csv_row("white rooms", rows[i].name, "s", s, "variance",
                    rows[i].variance(rows[i].albedo, s), "ns", NAN);
}

// ---- what is averaged ------------------------------------------------------------------------

// The light of one view as three programs average it.
static void measure_averages(void) {
    view views[3];
    fill_views(views);
    for (int i = 0; i < COUNT(views); i++) {
        enum { PATHS = 200000 };
        rng g = rng_seed(9, 5);
        double light = 0, clamped = 0, encoded = 0;
        for (int n = 0; n < PATHS; n++) {
            const real L = path_trace(&views[i].sc, views[i].r, 100, &g).x;
            light += (double)L;
            clamped += fmin((double)L, 1);
            encoded += srgb_byte(L) / 255.0;
        }
        const double means[] = {light / PATHS, clamped / PATHS,
                                (double)srgb_light((real)(encoded / PATHS))};
        for (int k = 0; k < COUNT(means); k++)
            csv_row("what is averaged", views[i].name, "1 light, 2 clamped, 3 sRGB", k + 1,
                    "mean / truth - 1", means[k] / views[i].truth - 1, "ns", NAN);
    }
}

// ---- the slide's slip, and the loop ------------------------------------------------------------

static void measure_slip(void) {
    static const struct {
        const char *name;
        path_tracer f;
    } tracers[] = {{"dot(d, v), the slide", trace_ray_slide}, {"dot(n, v)", trace_ray}};
    const room sc = {{.spheres = &ball, .sphere_count = 1, .sky = white_sky}, &grey_skin};
    const double degrees[] = {0, 30, 45, 60, 80};
    for (int k = 0; k < COUNT(tracers); k++)
        for (int i = 0; i < COUNT(degrees); i++) {
            const double theta = degrees[i] * PI / 180;
            const vec3 d = {(real)-sin(theta), (real)-cos(theta), 0};
            const ray r = {sub((vec3){0, 1, 0}, scale(2, d)), d};
            rng g = rng_seed(9, 6);
            running light = {0};
            for (int n = 0; n < 200000; n++)
                running_add(&light, (double)tracers[k].f(&sc, r, 1, &g).x);
            csv_row("the slip", tracers[k].name, "degrees", degrees[i], "mean, 0.5 is right",
                    light.mean, "ns", NAN);
        }
}

static void run_tracer(path_tracer f, int s) {
    const room sc = {box_bodies, box_surfaces};
    rng g = rng_seed(9, 7);
    real sum = 0;
    for (int i = 0; i < CASES; i++) sum += f(&sc, floor_ray(), s, &g).x;
    keep((double)sum);
}

// Roulette ends no path before the fourth bounce, but for those on the black front wall:
// 3.86 rays a path for the loop, 4 for the recursion.
static void run_recursion(void *data) {
    (void)data;
    run_tracer(trace_ray, 3);
}

static void run_loop(void *data) {
    (void)data;
    run_tracer(path_trace, 3);
}

static void measure_loop(void) {
    static const timed timings[] = {{"recursion: trace_ray", run_recursion},
                                    {"loop: path_trace", run_loop}};
    double ns[COUNT(timings)];
    measure_ns(timings, COUNT(timings), NULL, CASES, ROUNDS, ns);
    for (int i = 0; i < COUNT(timings); i++)
        csv_row("recursion or loop", timings[i].name, "s", 3, "not measured", NAN, "ns", ns[i]);
}

int main(void) {
    measure_loop();
    if (sizeof(real) > sizeof(float)) return 0; // the rest is chance, not rounding
    measure_samples();
    measure_ends();
    measure_white();
    measure_averages();
    measure_slip();
}
