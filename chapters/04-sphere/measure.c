// measure.c: ways to meet a sphere and to solve a quadratic, their error and their cost.
#include "common/measure.h"
#include "chapters/04-sphere/quadratics.h"
#include "chapters/04-sphere/variants.h"

enum {
    CASES = 1 << 16,
    FEW = 1 << 12,
    ROUNDS = 9
}; // many for shares, few for medians and times

typedef struct {
    int count;
    sphere S[CASES];
    ray r[CASES];
    exact t[CASES]; // the right answer, NO_HIT for a miss
} cases;

// ---- the variants of a sphere ------------------------------------------------------

#define RUN(f)                                                                        \
    static void run_##f(void *data) {                                                 \
        const cases *c = data;                                                        \
        real sum = 0;                                                                 \
        for (int i = 0; i < FEW; i++) sum += f(c->S[i], c->r[i], 0, NO_HIT) < NO_HIT; \
        keep(sum);                                                                    \
    }
RUN(sphere_hit_slide)
RUN(b_half)
RUN(plus_q)
RUN(hearn_baker)
RUN(gems)
RUN(crossed)
RUN(pbrt)
RUN(double_inside)
RUN(double_q)
RUN(double_gems)
RUN(sphere_hit)

typedef struct {
    const char *name;
    real (*hit)(sphere S, ray r, real t_min, real t_max);
    void (*run)(void *data);
} variant;

// The order of the rows; the first is what costs are compared with.
#define VARIANT(name, f) \
    { name, f, run_##f }
static const variant variants[] = {
    VARIANT("slide", sphere_hit_slide),
    VARIANT("b half", b_half),
    VARIANT("b half, q", plus_q),
    VARIANT("Hearn-Baker", hearn_baker),
    VARIANT("Ray Tracing Gems 7", gems),
    VARIANT("cross product", crossed),
    VARIANT("PBRT", pbrt),
    VARIANT("mixed, slide", double_inside),
    VARIANT("mixed, q", double_q),
    VARIANT("mixed, Gems 7", double_gems),
    VARIANT("sphere_hit (mixed, cross)", sphere_hit),
};

// In a build with double the mixed ones are others of the table again.
static int variant_count(void) {
    return sizeof(real) == sizeof(float) ? COUNT(variants) : COUNT(variants) - 4;
}

// ---- the right answer ----------------------------------------------------------------

static exact reference(sphere S, ray r) {
    const exact vx = (exact)r.O.x - S.c.x, vy = (exact)r.O.y - S.c.y, vz = (exact)r.O.z - S.c.z;
    const exact dx = r.d.x, dy = r.d.y, dz = r.d.z;
    const exact a = dx * dx + dy * dy + dz * dz, half_b = vx * dx + vy * dy + vz * dz;
    const exact c = vx * vx + vy * vy + vz * vz - (exact)S.r * S.r;
    const exact quarter = half_b * half_b - a * c;
    if (quarter < 0) return NO_HIT;
    const exact s = exact_sqrt(quarter), q = half_b > 0 ? -half_b - s : -half_b + s;
    const exact t = q / a, u = c / q, near = t < u ? t : u, far = t < u ? u : t;
    return near > 0 ? near : far > 0 ? far : (exact)NO_HIT;
}

// ---- the cases -------------------------------------------------------------------------

static vec3 in_ball(rng *g) {
    for (;;) {
        const real x = 2 * rng_real(g) - 1, y = 2 * rng_real(g) - 1, z = 2 * rng_real(g) - 1;
        const vec3 p = {x, y, z};
        if (dot(p, p) <= 1) return p;
    }
}

static vec3 direction(rng *g) {
    return normalize(in_ball(g));
}

typedef struct {
    double radius, distance; // of the eye to the surface, in radii
    double speed;            // |d|, within a factor of 2
} setting;

// Spheres about the origin, rays towards points of a ball 1.25 times as large: four in five
// hit.
static void fill(cases *c, int count, setting s) {
    c->count = count;
    rng g = rng_seed(4, 1);
    const real radius = (real)s.radius;
    for (int i = 0; i < count; i++) {
        const vec3 centre = scale(radius, in_ball(&g)), away = direction(&g);
        const vec3 target = add(centre, scale((real)1.25 * radius, in_ball(&g)));
        const real reach = radius * (real)(1 + s.distance);
        const vec3 O = add(centre, scale(reach, away));
        const real speed = (real)s.speed * ((real)0.5 + rng_real(&g));
        c->S[i] = (sphere){centre, radius};
        c->r[i] = (ray){O, scale(speed / length(sub(target, O)), sub(target, O))};
        c->t[i] = reference(c->S[i], c->r[i]);
    }
}

// The ground is a sphere with its top near the origin; the eye stands 1 above and looks down
// by at least 6 degrees.
static void fill_ground(cases *c, int count, setting s) {
    c->count = count;
    rng g = rng_seed(4, 2);
    for (int i = 0; i < count; i++) {
        const vec3 O = {rng_real(&g), 1, (real)0.25};
        vec3 d = direction(&g);
        d.y = -fabs(d.y) - (real)0.1;
        c->S[i] = (sphere){{0, -(real)s.radius, 0}, (real)s.radius};
        c->r[i] = (ray){O, d};
        c->t[i] = reference(c->S[i], c->r[i]);
    }
}

// ---- the tables ----------------------------------------------------------------------------

// The share of wrong decisions (hit or miss).
static double wrong_share(const cases *c, const variant *v) {
    int wrong = 0;
    for (int i = 0; i < c->count; i++) {
        const bool hits = v->hit(c->S[i], c->r[i], 0, NO_HIT) != NO_HIT;
        wrong += hits != (c->t[i] != NO_HIT);
    }
    return (double)wrong / c->count;
}

// A quantile of the relative error of t among the hits that were found. NAN: there are none.
static double error_of(const cases *c, const variant *v, double q) {
    static double error[CASES];
    int found = 0;
    for (int i = 0; i < c->count; i++) {
        const real t = v->hit(c->S[i], c->r[i], 0, NO_HIT);
        if (t == NO_HIT || c->t[i] == NO_HIT) continue;
        error[found++] = relative_error(t, c->t[i]) * REAL_EPSILON;
    }
    return found ? quantile(error, found, q) : NAN;
}

static void decisions(const cases *c, const char *table, const char *x_name, double x) {
    for (int v = 0; v < variant_count(); v++)
        csv_row(table, variants[v].name, x_name, x, "share of wrong decisions",
                wrong_share(c, &variants[v]), "ns", NAN);
}

static void medians(const cases *c, const char *table, const char *x_name, double x) {
    for (int v = 0; v < variant_count(); v++)
        csv_row(table, variants[v].name, x_name, x, "relative error of t, median",
                error_of(c, &variants[v], 0.5), "ns", NAN);
}

// The worst but for 1 in 100.
static void worst(const cases *c, const char *table, const char *x_name, double x) {
    for (int v = 0; v < variant_count(); v++)
        csv_row(table, variants[v].name, x_name, x, "relative error of t, 99 %",
                error_of(c, &variants[v], 0.99), "ns", NAN);
}

// What a call costs, beside its error.
static void costs(cases *c, const char *table, const char *x_name, double x) {
    timed timings[COUNT(variants)];
    double ns[COUNT(variants)];
    for (int v = 0; v < variant_count(); v++)
        timings[v] = (timed){variants[v].name, variants[v].run};
    measure_ns(timings, variant_count(), c, FEW, ROUNDS, ns);
    for (int v = 0; v < variant_count(); v++)
        csv_row(table, variants[v].name, x_name, x, "relative error of t, 99 %",
                error_of(c, &variants[v], 0.99), "ns", ns[v]);
}

int main(void) {
    static cases c;
    for (int k = 0; k <= 6; k++) {
        fill(&c, CASES, (setting){1, pow(10, k), 1});
        decisions(&c, "sphere: far away, decisions", "distance / radius", pow(10, k));
        medians(&c, "sphere: far away, t", "distance / radius", pow(10, k));
    }
    for (int k = 0; k <= 9; k += 3) {
        fill_ground(&c, FEW, (setting){.radius = pow(10, k)});
        medians(&c, "sphere: the ground", "radius", pow(10, k));
    }
    for (int k = -6; k <= 0; k++) {
        fill(&c, FEW, (setting){1, pow(10, k), 1});
        worst(&c, "sphere: near the surface", "gap / radius", pow(10, k));
    }
    for (int k = -20; k <= 20; k += 5) {
        fill(&c, FEW, (setting){1, 4, pow(10, k)});
        decisions(&c, "sphere: length of d, decisions", "|d|", pow(10, k));
        medians(&c, "sphere: length of d, t", "|d|", pow(10, k));
    }
    for (int k = -6; k <= 9; k += 3) {
        fill(&c, FEW, (setting){pow(10, k), 4, 1});
        worst(&c, "sphere: size", "radius", pow(10, k));
    }
    fill(&c, FEW, (setting){1, 4, 1});
    costs(&c, "sphere: cost", "distance / radius", 4);
    measure_quadratics();
}
