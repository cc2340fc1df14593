// measure.c: where the next ray starts, the drift of |d|, fuzzy bounces below the
// surface, random directions, and the light that is lost when a path is cut.
#include <string.h>

#include "chapters/06-bounce/bounce.h"
#include "common/exact3.h"
#include "common/wide3.h"

enum { CASES = 4096, ROUNDS = 9 };

static double wide_length(vec3 v) {
    return sqrt(wide_dot(widen(v), widen(v)));
}

// ---- where the next ray starts: the variants ---------------------------------------

// From the hit h of r on S, in the direction d.
typedef vec3 start(sphere S, ray r, hit h, vec3 d);

static vec3 at_the_hit(sphere S, ray r, hit h, vec3 d) {
    (void)S, (void)r, (void)d;
    return h.p;
}

#ifdef REAL_IS_DOUBLE
typedef int64_t bits;
#else
typedef int32_t bits;
#endif

// x moved by `steps` numbers, outwards for steps of x's sign.
static real stepped(real x, bits steps) {
    bits i;
    memcpy(&i, &x, sizeof i);
    i += x < 0 ? -steps : steps;
    memcpy(&x, &i, sizeof i);
    return x;
}

// 256 numbers further along n, or n / 65536 near a zero coordinate (as much less for
// double). Source: Wächter and Binder, Ray Tracing Gems, ch. 6.
static real integer_step(real x, real n) {
    if (fabs(x) < (real)1 / 32) return x + n * (REAL_EPSILON * 128);
    return stepped(x, (bits)(256 * n));
}

static vec3 by_integers(sphere S, ray r, hit h, vec3 d) {
    (void)S, (void)r;
    const vec3 n = dot(d, h.n) < 0 ? neg(h.n) : h.n;
    return (vec3){integer_step(h.p.x, n.x), integer_step(h.p.y, n.y), integer_step(h.p.z, n.z)};
}

static vec3 by_bound(sphere S, ray r, hit h, vec3 d) {
    (void)S, (void)r;
    return offset_origin(h.p, h.error, h.n, d);
}

// The same two from the point O + t d, which was not put back onto the sphere.
static vec3 by_integers_from_ray(sphere S, ray r, hit h, vec3 d) {
    h.p = ray_at(r, h.t);
    return by_integers(S, r, h, d);
}

// The same from the slide's t, in float throughout, which no bound knows.
static vec3 by_integers_from_slide(sphere S, ray r, hit h, vec3 d) {
    const real t = sphere_hit_slide(S, r, 0, NO_HIT);
    if (t != NO_HIT) h.p = ray_at(r, t);
    return by_integers(S, r, h, d);
}

static vec3 by_bound_from_ray(sphere S, ray r, hit h, vec3 d) {
    return by_bound(S, r, hit_at(r, h.t, h.n), d);
}

typedef struct {
    const char *name;
    start *from;
    real t_min;
} start_variant;

static const start_variant starts[] = {
    {"at the hit", at_the_hit, 0},
    {"t_min = 0.0001", at_the_hit, (real)1e-4},
    {"256 integer steps", by_integers, 0},
    {"256 integer steps from O + t d", by_integers_from_ray, 0},
    {"256 integer steps, the slide's t", by_integers_from_slide, 0},
    {"error bound", by_bound, 0},
    {"error bound of O + t d", by_bound_from_ray, 0},
};

// ---- where the next ray starts: the cases ------------------------------------------

typedef struct {
    int count;
    sphere S[CASES];
    ray r[CASES];
    hit h[CASES];
    vec3 d[CASES]; // of the next ray: leaves the surface
} cases;

static void add_case(cases *c, sphere S, ray r, rng *g) {
    const vec3 d = unit_vector(g);
    const real t = sphere_hit(S, r, 0, NO_HIT);
    if (t == NO_HIT) return;
    const hit h = sphere_surface(S, r, t);
    const int i = c->count++;
    c->S[i] = S, c->r[i] = r, c->h[i] = h;
    c->d[i] = dot(d, h.n) < 0 ? neg(d) : d;
}

// Spheres of radius `size`, `distance` from the world's origin, seen from `away`.
static void balls(cases *c, double size, double distance, double away) {
    rng g = rng_seed(6, 1);
    c->count = 0;
    while (c->count < CASES) {
        const vec3 centre = scale((real)distance, unit_vector(&g));
        const vec3 O = add(centre, scale((real)away, unit_vector(&g)));
        const vec3 aim = add(centre, scale((real)(0.5 * size), in_cube(&g)));
        add_case(c, (sphere){centre, (real)size}, (ray){O, normalize(sub(aim, O))}, &g);
    }
}

// A sphere of radius r whose top is near the origin, seen from one unit above.
static void ground(cases *c, double r) {
    rng g = rng_seed(6, 2);
    c->count = 0;
    while (c->count < CASES) {
        const sphere S = {scale((real)-r, unit_vector(&g)), (real)r};
        const wide3 centre = widen(S.c);
        const double k = (r + 1) / sqrt(wide_dot(centre, centre)); // up is -c
        const vec3 O =
            narrow((wide3){(1 - k) * centre.x, (1 - k) * centre.y, (1 - k) * centre.z});
        const vec3 d = unit_vector(&g), down = scale((real)(1 / r), S.c);
        add_case(c, S, (ray){O, dot(d, down) < 0 ? neg(d) : d}, &g);
    }
}

// The share of next rays that meet the sphere which they leave.
static void self_hits(const cases *c, const char *table, const char *x_name, double x) {
    for (int v = 0; v < COUNT(starts); v++) {
        int again = 0;
        for (int i = 0; i < c->count; i++) {
            const ray next = {starts[v].from(c->S[i], c->r[i], c->h[i], c->d[i]), c->d[i]};
            again += sphere_hit(c->S[i], next, starts[v].t_min, NO_HIT) != NO_HIT;
        }
        csv_row(table, starts[v].name, x_name, x, "share of next rays that hit again",
                (double)again / c->count, "ns", NAN);
    }
}

// How far the start moves, or how far hits are ignored: what is smaller gets lost.
static void holes(const cases *c, const char *table, const char *x_name, double x) {
    for (int v = 1; v < COUNT(starts); v++) {
        static double moved[CASES];
        for (int i = 0; i < c->count; i++) {
            const vec3 q = starts[v].from(c->S[i], c->r[i], c->h[i], c->d[i]);
            moved[i] = starts[v].t_min + wide_length(sub(q, c->h[i].p));
            moved[i] /= c->S[i].r;
        }
        csv_row(table, starts[v].name, x_name, x, "median distance skipped / radius",
                quantile(moved, c->count, 0.5), "ns", NAN);
    }
}

#define TIMED_START(f)                                                                  \
    static void run_##f(void *data) {                                                   \
        const cases *c = data;                                                          \
        real sum = 0;                                                                   \
        for (int i = 0; i < CASES; i++) sum += f(c->S[i], c->r[i], c->h[i], c->d[i]).x; \
        keep(sum);                                                                      \
    }
TIMED_START(by_integers)
TIMED_START(by_bound)

static void start_costs(cases *c) {
    static const timed timings[] = {{"256 integer steps", run_by_integers},
                                    {"error bound", run_by_bound}};
    double ns[COUNT(timings)];
    balls(c, 1, 1, 5);
    measure_ns(timings, COUNT(timings), c, CASES, ROUNDS, ns);
    for (int v = 0; v < COUNT(timings); v++)
        csv_row("start: cost", timings[v].name, "calls", CASES, "not measured", NAN, "ns",
                ns[v]);
}

static void measure_starts(void) {
    static cases c;
    for (int k = 0; k <= 6; k++) {
        balls(&c, 1, pow(10, k), 5);
        self_hits(&c, "start: far from the origin", "coordinates / radius", pow(10, k));
    }
    for (int k = 0; k <= 9; k++) {
        ground(&c, pow(10, k));
        self_hits(&c, "start: great ground", "radius of the ground", pow(10, k));
    }
    for (int k = 1; k <= 6; k++) {
        balls(&c, 1, 0, pow(10, k));
        self_hits(&c, "start: seen from afar", "distance / radius", pow(10, k));
    }
    for (int k = -6; k <= 6; k += 2) {
        balls(&c, pow(10, k), pow(10, k), 5 * pow(10, k));
        holes(&c, "start: holes", "radius", pow(10, k));
    }
    start_costs(&c);
}

// ---- the drift of |d| ----------------------------------------------------------------

typedef struct {
    const char *name;
    double stretch; // |n|
    bool rounded;   // n is a rounded unit vector; else normalize's, in real arithmetic
    int every;      // normalise every so many reflections; 0: never
    bool newton;    // keep_unit each time
} drift_variant;

static const drift_variant drifts[] = {
    {"n rounded from double", 1, true, 0, false},
    {"n from normalize", 1, false, 0, false},
    {"n from normalize, keep_unit", 1, false, 0, true},
    {"n from normalize, normalised each time", 1, false, 1, false},
    {"|n| = 1.0001", 1.0001, false, 0, false},
    {"|n| = 1.0001, normalised every 16", 1.0001, false, 16, false},
    {"|n| = 1.0001, keep_unit", 1.0001, false, 0, true},
};

static vec3 normal_of(const drift_variant *v, rng *g) {
    const real size = 1 + rng_real(g);
    const vec3 u = scale(size, unit_vector(g));
    if (!v->rounded) return scale((real)v->stretch, normalize(u));
    return narrow(wide_along((wide3){0, 0, 0}, v->stretch / wide_length(u), widen(u)));
}

static vec3 one_more(const drift_variant *v, vec3 d, vec3 n, long i) {
    d = reflect(d, n);
    if (v->newton) return keep_unit(d);
    return v->every && i % v->every == 0 ? normalize(d) : d;
}

// Every NaN is as far off as can be.
static double off_unit(vec3 d) {
    const double off = fabs(wide_length(d) - 1);
    return isnan(off) ? (double)INFINITY : off;
}

typedef struct {
    const drift_variant *v;
    vec3 n[CASES];
} mirrors;

static void mirrors_fill(mirrors *m, const drift_variant *v) {
    rng g = rng_seed(6, 3);
    m->v = v;
    for (int i = 0; i < CASES; i++) m->n[i] = normal_of(v, &g);
}

static void run_mirrors(void *data) {
    const mirrors *m = data;
    const drift_variant v = *m->v;
    vec3 d = {1, 0, 0};
    for (int i = 0; i < CASES; i++) d = one_more(&v, d, m->n[i], i);
    keep(d.x);
}

static void drift_costs(void) {
    static mirrors m;
    for (int k = 0; k < COUNT(drifts); k++) {
        double ns;
        mirrors_fill(&m, &drifts[k]);
        const timed timing = {drifts[k].name, run_mirrors};
        measure_ns(&timing, 1, &m, CASES, ROUNDS, &ns);
        csv_row("drift: cost", drifts[k].name, "reflections", CASES, "not measured", NAN, "ns",
                ns);
    }
}

static void measure_drift(void) {
    for (int k = 0; k < COUNT(drifts); k++) {
        rng g = rng_seed(6, 4);
        vec3 d = normalize((vec3){1, 2, 3});
        long next = 1;
        for (long i = 1; i <= 1000000; i++) {
            d = one_more(&drifts[k], d, normal_of(&drifts[k], &g), i);
            if (i != next) continue;
            csv_row("drift of |d|", drifts[k].name, "reflections", (double)i, "||d| - 1|",
                    off_unit(d), "ns", NAN);
            next *= 10;
        }
    }
}

// ---- the fuzzy bounce below the surface -----------------------------------------------

// The share of mirrored + fuzz * random unit vector that points into the surface, for
// light that arrives at the cosine `cosine`; < 0: from everywhere, as cos θ weighs it.
static double share_below(double fuzz, double cosine) {
    rng g = rng_seed(6, 5);
    const int n = 400000;
    int below = 0;
    for (int i = 0; i < n; i++) {
        const double c = cosine < 0 ? sqrt(rng_double(&g)) : cosine;
        below += c + fuzz * unit_vector(&g).z < 0;
    }
    return (double)below / n;
}

static void measure_fuzzy(void) {
    static const struct {
        const char *name;
        double cosine;
    } arrivals[] = {
        {"from everywhere", -1}, {"cos 0.5", 0.5}, {"cos 0.2", 0.2}, {"cos 0.05", 0.05}};
    const double fuzzes[] = {0.1, 0.3, 0.5, 1};
    for (int k = 0; k < COUNT(arrivals); k++)
        for (int i = 0; i < COUNT(fuzzes); i++)
            csv_row("fuzzy: below the surface", arrivals[k].name, "fuzz", fuzzes[i],
                    "share below the surface", share_below(fuzzes[i], arrivals[k].cosine), "ns",
                    NAN);
}

// ---- random directions -----------------------------------------------------------------

static vec3 from_ball(rng *g) {
    for (;;) {
        const vec3 v = in_cube(g);
        if (dot(v, v) <= 1 && dot(v, v) > 0) return normalize(v);
    }
}

static vec3 from_cube(rng *g) {
    return normalize(in_cube(g));
}

static vec3 by_angles(rng *g) {
    const real z = 1 - 2 * rng_real(g), turn = (real)(2 * PI) * rng_real(g);
    const real out = sqrt(fmax(0, 1 - z * z));
    return (vec3){out * cos(turn), out * sin(turn), z};
}

// For the matte ones n is the z axis.
static const vec3 up = {0, 0, 1};

static vec3 lambert(rng *g) {
    return matte_bounce(up, g);
}

static vec3 lifted_disc(rng *g) {
    real a, b, s;
    do {
        a = 2 * rng_real(g) - 1;
        b = 2 * rng_real(g) - 1;
        s = a * a + b * b;
    } while (s >= 1);
    return (vec3){a, b, sqrt(1 - s)};
}

static vec3 plus_ball(rng *g) {
    for (;;) {
        const vec3 v = in_cube(g);
        if (dot(v, v) <= 1) return normalize(add(up, v));
    }
}

static vec3 hemisphere(rng *g) {
    const vec3 v = unit_vector(g);
    return v.z < 0 ? neg(v) : v;
}

typedef vec3 sampler(rng *g);

// chi² over 8 x 12 cells that are equally likely for a right sampler: by z over the
// sphere, by z² = cos²θ for Lambert; 95 degrees of freedom.
static double chi2_of(sampler *draw, bool matte, int count) {
    enum { BANDS = 8, SECTORS = 12, CELLS = BANDS * SECTORS };
    int cells[CELLS] = {0};
    rng g = rng_seed(6, 6);
    for (int i = 0; i < count; i++) {
        const vec3 v = draw(&g);
        const double height = matte ? (double)v.z * v.z : (1 + (double)v.z) / 2;
        const double turn = atan2((double)v.y, (double)v.x) / (2 * PI) + 0.5;
        const int band = (int)fmin(BANDS - 1, fmax(0, BANDS * height));
        cells[band * SECTORS + (int)fmin(SECTORS - 1, SECTORS * turn)]++;
    }
    double chi2 = 0;
    const double want = (double)count / CELLS;
    for (int i = 0; i < CELLS; i++) chi2 += (cells[i] - want) * (cells[i] - want) / want;
    return chi2;
}

// Through a pointer, so that none is inlined and all pay for the call alike.
#define TIMED_SAMPLER(f)                                   \
    static void run_##f(void *data) {                      \
        sampler *const volatile draw = f;                  \
        rng g = *(rng *)data;                              \
        real sum = 0;                                      \
        for (int i = 0; i < CASES; i++) sum += draw(&g).x; \
        keep(sum);                                         \
    }
TIMED_SAMPLER(unit_vector)
TIMED_SAMPLER(from_ball)
TIMED_SAMPLER(by_angles)
TIMED_SAMPLER(from_cube)
TIMED_SAMPLER(lambert)
TIMED_SAMPLER(lifted_disc)
TIMED_SAMPLER(plus_ball)
TIMED_SAMPLER(hemisphere)

typedef struct {
    const char *name;
    sampler *draw;
    void (*run)(void *data);
} sampler_variant;

static void measure_samplers(const char *table, bool matte, const sampler_variant *v,
                             int count) {
    enum { MOST = 8, DRAWS = 500000 };
    timed timings[MOST];
    double ns[MOST];
    rng g = rng_seed(6, 7);
    for (int i = 0; i < count; i++) timings[i] = (timed){v[i].name, v[i].run};
    measure_ns(timings, count, &g, CASES, ROUNDS, ns);
    for (int i = 0; i < count; i++)
        csv_row(table, v[i].name, "draws", DRAWS, "chi², 95 expected",
                chi2_of(v[i].draw, matte, DRAWS), "ns", ns[i]);
}

static void measure_directions(void) {
    static const sampler_variant sphere_ones[] = {
        {"disc, lifted (unit_vector)", unit_vector, run_unit_vector},
        {"ball, normalised", from_ball, run_from_ball},
        {"angles", by_angles, run_by_angles},
        {"cube, normalised", from_cube, run_from_cube},
    };
    static const sampler_variant matte_ones[] = {
        {"n + unit vector (matte_bounce)", lambert, run_lambert},
        {"disc, lifted to the hemisphere", lifted_disc, run_lifted_disc},
        {"n + point in the ball", plus_ball, run_plus_ball},
        {"uniform hemisphere", hemisphere, run_hemisphere},
    };
    measure_samplers("unit vectors", false, sphere_ones, COUNT(sphere_ones));
    measure_samplers("matte directions", true, matte_ones, COUNT(matte_ones));
}

// ---- the light that is lost when a path is cut ------------------------------------------

enum { LONGEST = 1000 };

// The light found at each number of bounces in a hollow sphere with a window of a
// tenth of its surface (README.md: the closed form).
static void hollow_sphere(double albedo, double *light) {
    rng g = rng_seed(6, 8);
    for (int i = 0; i < 100000; i++) {
        vec3 p = unit_vector(&g);
        double C = 1;
        for (int k = 1; k <= LONGEST; k++) {
            const vec3 d = matte_bounce(neg(p), &g);
            p = normalize(add(p, scale(-2 * dot(p, d), d)));
            C *= albedo;
            if (p.y <= (real)0.8) continue;
            light[k] += C;
            break;
        }
    }
}

static void measure_cut(void) {
    static const double albedos[] = {0.5, 0.8, 0.95};
    static const char *const names[] = {"albedo 0.5", "albedo 0.8", "albedo 0.95"};
    for (int a = 0; a < COUNT(albedos); a++) {
        double light[LONGEST + 1] = {0}, total = 0, found = 0;
        hollow_sphere(albedos[a], light);
        for (int k = 1; k <= LONGEST; k++) total += light[k];
        for (int k = 1, s = 1; s <= 32; k++) {
            found += light[k];
            if (k != s) continue;
            csv_row("light lost by cutting", names[a], "s", s, "share of the light lost",
                    1 - found / total, "ns", NAN);
            s *= 2;
        }
    }
}

int main(void) {
    measure_starts();
    measure_drift();
    drift_costs();
    if (sizeof(real) > sizeof(float)) return 0; // the rest is chance, not rounding
    measure_fuzzy();
    measure_directions();
    measure_cut();
}
