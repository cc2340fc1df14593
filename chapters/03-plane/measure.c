// measure.c: ways to work out t for a plane, their error and their cost.
#include "chapters/03-plane/plane.h"
#include "common/exact3.h"
#include "common/wide3.h"

enum { CASES = 4096, ROUNDS = 9 };

typedef struct {
    plane P[CASES];
    ray r[CASES];
    plane_equations E[CASES / EQUATIONS]; // of the planes
} cases;

// ---- the variants ------------------------------------------------------------

static real accept(real t, real t_min, real t_max) {
    return t > t_min && t < t_max ? t : NO_HIT;
}

// As on the slide.
static real slide(plane P, ray r, real t_min, real t_max) {
    return accept(dot(sub(P.x, r.O), P.n) / dot(r.d, P.n), t_min, t_max);
}

// The plane stored as n and D = n·x, as most textbooks do.
static real stored_distance(plane P, ray r, real t_min, real t_max) {
    const real D = dot(P.n, P.x);
    return accept((D - dot(P.n, r.O)) / dot(r.d, P.n), t_min, t_max);
}

// The slide's formula, with a threshold against "nearly parallel" rays.
static real threshold(plane P, ray r, real t_min, real t_max) {
    const real along = dot(r.d, P.n);
    if (fabs(along) < (real)1e-6) return NO_HIT;
    return accept(dot(sub(P.x, r.O), P.n) / along, t_min, t_max);
}

// stored_distance, with D and all else in double.
static real equation(plane P, ray r, real t_min, real t_max) {
    const plane_equations E = plane_equations_of(&P, 1);
    real t[EQUATIONS];
    equations_hit(&E, r, t_min, t);
    return accept(t[0], t_min, t_max);
}

#define TIMED(f)                                                                     \
    static void run_##f(void *data) {                                                \
        const cases *c = data;                                                       \
        real sum = 0;                                                                \
        for (int i = 0; i < CASES; i++) sum += f(c->P[i], c->r[i], -NO_HIT, NO_HIT); \
        keep(sum);                                                                   \
    }
TIMED(slide)
TIMED(stored_distance)
TIMED(threshold)
TIMED(plane_hit)

// One ray for every EQUATIONS planes, as in a scene.
static void run_equations(void *data) {
    const cases *c = data;
    real sum = 0;
    for (int i = 0; i < CASES; i += EQUATIONS) {
        real t[EQUATIONS];
        equations_hit(&c->E[i / EQUATIONS], c->r[i], -NO_HIT, t);
        for (int k = 0; k < EQUATIONS; k++) sum += t[k];
    }
    keep(sum);
}

typedef struct {
    const char *name;
    real (*hit)(plane P, ray r, real t_min, real t_max);
} variant;

// The order of the rows; the first is what costs are compared with.
static const variant variants[] = {
    {"slide", slide},
    {"stored D", stored_distance},
    {"|d.n| < 1e-6 misses", threshold},
    {"plane_hit (double inside)", plane_hit},
    {"equations_hit (stored D, in double)", equation},
};
static const timed timings[] = {
    {"slide", run_slide},
    {"stored D", run_stored_distance},
    {"|d.n| < 1e-6 misses", run_threshold},
    {"plane_hit (double inside)", run_plane_hit},
    {"equations_hit (stored D, in double)", run_equations},
};

// ---- the cases ----------------------------------------------------------------

// Planes within `size` of `centre`, met at the given slope d·n / |d||n| by
// directions about `speed` long.
static void fill(cases *c, vec3 centre, real size, real slope, real speed) {
    rng g = rng_seed(1, 3);
    for (int i = 0; i < CASES; i++) {
        const vec3 n = in_cube(&g), unit = normalize(n), d = normalize(in_cube(&g));
        const vec3 along = normalize(sub(d, scale(dot(d, unit), unit)));
        c->P[i] = (plane){add(centre, scale(size, in_cube(&g))), n};
        c->r[i] = (ray){add(centre, scale(size, in_cube(&g))),
                        scale(speed, add(along, scale(slope, unit)))};
    }
    for (int i = 0; i < CASES; i += EQUATIONS)
        c->E[i / EQUATIONS] = plane_equations_of(&c->P[i], EQUATIONS);
}

static exact reference(plane P, ray r) {
    const exact3 n = exact_of(P.n);
    return exact_dot(exact_sub(P.x, r.O), n) / exact_dot(exact_of(r.d), n);
}

static double error_of(double t, exact want) {
    return relative_error(t, want) * REAL_EPSILON;
}

// ---- the tables ----------------------------------------------------------------

// Median relative error of t, and ns per call.
static void errors(const cases *c, const char *table, const char *x_name, double x) {
    double ns[COUNT(variants)];
    measure_ns(timings, COUNT(timings), (void *)c, CASES, ROUNDS, ns);
    for (int v = 0; v < COUNT(variants); v++) {
        static double error[CASES];
        for (int i = 0; i < CASES; i++) {
            const real t = variants[v].hit(c->P[i], c->r[i], -NO_HIT, NO_HIT);
            error[i] = error_of(t, reference(c->P[i], c->r[i]));
        }
        csv_row(table, variants[v].name, x_name, x, "relative error of t, median",
                quantile(error, CASES, 0.5), "ns", ns[v]);
    }
}

// The share of true hits that is lost.
static void losses(const cases *c, const char *table, const char *x_name, double x) {
    for (int v = 0; v < COUNT(variants); v++) {
        int lost = 0;
        for (int i = 0; i < CASES; i++)
            lost += variants[v].hit(c->P[i], c->r[i], -NO_HIT, NO_HIT) == NO_HIT;
        csv_row(table, variants[v].name, x_name, x, "share of hits lost", (double)lost / CASES,
                "ns", NAN);
    }
}

int main(void) {
    static cases c;
    const vec3 origin = {0, 0, 0};
    for (int k = 0; k >= -6; k--) {
        fill(&c, origin, 5, (real)pow(10, k), 1);
        errors(&c, "plane: grazing", "d.n / |d||n|", pow(10, k));
    }
    for (int k = 0; k <= 6; k += 2) {
        const real far = (real)pow(10, k);
        fill(&c, (vec3){far, -far / 3, far / 7}, 5, (real)0.5, 1);
        errors(&c, "plane: far from the origin", "coordinates", pow(10, k));
    }
    for (int k = -6; k <= 9; k += 3) {
        fill(&c, origin, (real)pow(10, k), (real)0.5, 1);
        errors(&c, "plane: size of the scene", "size", pow(10, k));
    }
    for (int k = -12; k <= 9; k += 3) {
        fill(&c, origin, 5, (real)0.5, (real)pow(10, k));
        losses(&c, "plane: hits lost", "|d|", pow(10, k));
    }
}
