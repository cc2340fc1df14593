// measure.c: Schlick against Fresnel, what rounding does to both and to Snell's law, what
// they cost, whether to follow one ray or two, and glass_trace beside a page of plain C.
#include <stdlib.h>

#include "chapters/11-fresnel/plain.h"
#include "chapters/11-fresnel/variants.h"

enum { CASES = 4096, ROUNDS = 9 };

// ---- rounding ----------------------------------------------------------------------------

typedef struct {
    real cosine[CASES], eta[CASES];
} cases;

#define TIMED(f)                                                              \
    static void run_##f(void *data) {                                         \
        formula *const volatile call = f; /* so that all pay for the call */  \
        const cases *c = data;                                                \
        real sum = 0;                                                         \
        for (int i = 0; i < CASES; i++) sum += call(c->cosine[i], c->eta[i]); \
        keep((double)sum);                                                    \
    }
TIMED(textbook)
TIMED(factored)
TIMED(fresnel_dielectric)
TIMED(schlick_pow)
TIMED(schlick_slide)
TIMED(schlick)

static const struct {
    const char *name;
    formula *f;
} exact_ones[] = {
    {"textbook r_s, r_p", textbook},
    {"factored", factored},
    {"factored, double inside (fresnel_dielectric)", fresnel_dielectric},
};

// The 99 % quantile of the relative error.
static double error_of(formula *f, const cases *c) {
    static double errors[CASES];
    for (int i = 0; i < CASES; i++)
        errors[i] = REAL_EPSILON * relative_error((double)f(c->cosine[i], c->eta[i]),
                                                  exact_fresnel(c->cosine[i], c->eta[i]));
    return quantile(errors, CASES, 0.99);
}

static void error_rows(const char *table, const char *x_name, double x, const cases *c) {
    for (int v = 0; v < COUNT(exact_ones); v++)
        csv_row(table, exact_ones[v].name, x_name, x, "relative error, 99 %",
                error_of(exact_ones[v].f, c), "ns", NAN);
}

// eta from 1 + step to 1 + 2 step, cosines from 0.05 to 1.
static void near_one(cases *c, double step, rng *g) {
    for (int i = 0; i < CASES; i++) {
        c->eta[i] = (real)(1 + step * (1 + rng_double(g)));
        c->cosine[i] = (real)(0.05 + 0.95 * rng_double(g));
    }
}

// Cosines a little above that of the critical angle, cos²_c = 1 - eta².
static void near_critical(cases *c, double above, rng *g) {
    for (int i = 0; i < CASES; i++) {
        const double eta = 1 / (1.3 + 1.1 * rng_double(g));
        c->eta[i] = (real)eta;
        const double critical = sqrt((1 - (double)c->eta[i]) * (1 + (double)c->eta[i]));
        c->cosine[i] = (real)(critical * (1 + above * (1 + rng_double(g))));
    }
}

static void formula_costs(cases *c) {
    static const timed timings[] = {
        {"textbook r_s, r_p", run_textbook},
        {"factored", run_factored},
        {"factored, double inside (fresnel_dielectric)", run_fresnel_dielectric},
        {"Schlick with pow, the ray's cosine", run_schlick_pow},
        {"Schlick multiplied out (schlick_slide)", run_schlick_slide},
        {"Schlick, right cosine (schlick)", run_schlick},
    };
    const double etas[] = {1.5, 1 / 1.5};
    for (int k = 0; k < COUNT(etas); k++) {
        double ns[COUNT(timings)];
        rng g = rng_seed(11, 1);
        for (int i = 0; i < CASES; i++) {
            c->eta[i] = (real)etas[k];
            c->cosine[i] = (real)rng_double(&g);
        }
        measure_ns(timings, COUNT(timings), c, CASES, ROUNDS, ns);
        for (int v = 0; v < COUNT(timings); v++)
            csv_row("reflectance: cost", timings[v].name, "eta", etas[k], "not measured", NAN,
                    "ns", ns[v]);
    }
}

static void measure_rounding(void) {
    static cases c;
    rng g = rng_seed(11, 2);
    for (int k = -6; k <= 0; k++) {
        near_one(&c, pow(10, k), &g);
        error_rows("reflectance: entering", "eta - 1", pow(10, k), &c);
    }
    for (int k = -6; k <= -2; k++) {
        near_critical(&c, pow(10, k), &g);
        error_rows("reflectance: near the critical angle", "cosine / critical - 1", pow(10, k),
                   &c);
    }
    formula_costs(&c);
}

// ---- Schlick's own error -----------------------------------------------------------------

typedef struct {
    const char *name;
    formula *f;
    bool leaving;
} schlick_variant;

static const schlick_variant schlicks[] = {
    {"entering", schlick, false},
    {"leaving, the cosine outside (schlick)", schlick, true},
    {"leaving, the ray's own cosine (slide)", schlick_slide, true},
};

enum { STEPS = 20000 };

static double largest_error(const schlick_variant *v, real eta) {
    double largest = 0;
    for (int i = 0; i <= STEPS; i++) {
        const real c = (real)((double)i / STEPS);
        largest =
            fmax(largest, fabs((double)v->f(c, eta) - (double)fresnel_dielectric(c, eta)));
    }
    return largest;
}

// The share that is reflected of light from everywhere: ∫ 2 c R dc, midpoint rule.
static double diffuse_albedo(formula *f, real eta) {
    double sum = 0;
    for (int i = 0; i < STEPS; i++) {
        const double c = (i + 0.5) / STEPS;
        sum += 2 * c * (double)f((real)c, eta) / STEPS;
    }
    return sum;
}

static void measure_schlick(void) {
    const double n[] = {1.02, 1.05, 1.1, 1.2, 1.33, 1.5, 1.6, 2, 2.4, 3};
    for (int v = 0; v < COUNT(schlicks); v++)
        for (int i = 0; i < COUNT(n); i++) {
            const real eta = (real)(schlicks[v].leaving ? 1 / n[i] : n[i]);
            csv_row("Schlick: largest error", schlicks[v].name, "n", n[i], "largest |error|",
                    largest_error(&schlicks[v], eta), "ns", NAN);
            const double truth = diffuse_albedo(fresnel_dielectric, eta);
            csv_row("Schlick: diffuse albedo", schlicks[v].name, "n", n[i], "relative error",
                    diffuse_albedo(schlicks[v].f, eta) / truth - 1, "ns", NAN);
        }
}

// ---- metals --------------------------------------------------------------------------------

static double channel(color c, int i) {
    return (double)(i == 0 ? c.x : i == 1 ? c.y : c.z);
}

static void measure_metals(void) {
    const double nm[] = {650, 550, 450};
    for (const metal *m = metals; m->name; m++)
        for (int i = 0; i < 3; i++) {
            double largest = 0;
            for (int k = 0; k <= STEPS; k++) {
                const real c = (real)((double)k / STEPS);
                const double error = channel(schlick_conductor(c, m->eta, m->k), i) -
                                     channel(fresnel_conductor(c, m->eta, m->k), i);
                largest = fmax(largest, fabs(error));
            }
            csv_row("Schlick: metals", m->name, "wavelength in nm", nm[i], "largest |error|",
                    largest, "ns", NAN);
        }
}

// Beside them, a search for the nearest hit in the box: rays from its middle.
typedef struct {
    cases c;
    scene box;
    ray r[CASES];
} metal_cases;

static double all_channels(color c) {
    return (double)c.x + (double)c.y + (double)c.z;
}

static void run_conductor(void *data) {
    const metal_cases *m = data;
    double sum = 0;
    for (int i = 0; i < CASES; i++)
        sum +=
            all_channels(fresnel_conductor(m->c.cosine[i], metals[i % 7].eta, metals[i % 7].k));
    keep(sum);
}

static void run_schlick_conductor(void *data) {
    const metal_cases *m = data;
    double sum = 0;
    for (int i = 0; i < CASES; i++)
        sum +=
            all_channels(schlick_conductor(m->c.cosine[i], metals[i % 7].eta, metals[i % 7].k));
    keep(sum);
}

// R0 is worked out once for each metal.
static void run_schlick_color(void *data) {
    const metal_cases *m = data;
    const color R0 = schlick_conductor(1, metals[0].eta, metals[0].k);
    double sum = 0;
    for (int i = 0; i < CASES; i++) sum += all_channels(schlick_color(R0, m->c.cosine[i]));
    keep(sum);
}

__attribute__((flatten)) static void run_search(void *data) {
    const metal_cases *m = data;
    double sum = 0;
    int body = 0;
    for (int i = 0; i < CASES; i++)
        sum += (double)scene_nearest(&m->box, m->r[i], 0, NO_HIT, &body).t;
    keep(sum);
}

static void metal_costs(void) {
    static const timed timings[] = {{"exact (fresnel_conductor)", run_conductor},
                                    {"Schlick (schlick_conductor)", run_schlick_conductor},
                                    {"Schlick, R0 known (schlick_color)", run_schlick_color},
                                    {"a search in the box (scene_nearest)", run_search}};
    static metal_cases m;
    double ns[COUNT(timings)];
    rng g = rng_seed(11, 3);
    for (int i = 0; i < CASES; i++) m.c.cosine[i] = rng_real(&g);
    for (int i = 0; i < CASES; i++) m.r[i] = (ray){{0, 1, 1}, unit_vector(&g)};
    m.box = scene_prepare(box_bodies);
    measure_ns(timings, COUNT(timings), &m, CASES, ROUNDS, ns);
    scene_release(&m.box);
    for (int v = 0; v < COUNT(timings); v++)
        csv_row("metals: cost", timings[v].name, "calls", CASES, "not measured", NAN, "ns",
                ns[v]);
}

// ---- Snell's law near the critical angle -----------------------------------------------------

static const struct {
    const char *name;
    far_side *f;
} far_sides[] = {
    {"1 - sin², sin = sqrt(1 - c²)/eta", by_sine},
    {"1 - (1 - c²)/eta²", by_squares},
    {"1 - (1 - c)(1 + c)/eta²", by_product},
    {"((eta - 1)(eta + 1) + c²)/eta²", by_sum},
    {"the same, double inside (refract)", by_sum_wide},
};

// How often one side of the critical angle is taken for the other; where not, how wrong cos² is.
static void snell_rows(const cases *c, double off) {
    static double errors[CASES];
    for (int v = 0; v < COUNT(far_sides); v++) {
        long wrong = 0, right = 0;
        for (int i = 0; i < CASES; i++) {
            const exact e = c->eta[i], cosine = c->cosine[i];
            const exact want = ((e - 1) * (e + 1) + cosine * cosine) / (e * e);
            const real got = far_sides[v].f(c->cosine[i], c->eta[i]);
            if ((got >= 0) != (want >= 0))
                wrong++;
            else
                errors[right++] = REAL_EPSILON * relative_error((double)got, want);
        }
        csv_row("Snell: wrong side of the critical angle", far_sides[v].name,
                "|cosine / critical - 1|", off, "share of wrong decisions",
                (double)wrong / CASES, "ns", NAN);
        csv_row("Snell: cos² beyond the surface", far_sides[v].name, "|cosine / critical - 1|",
                off, "relative error, 99 %", quantile(errors, right, 0.99), "ns", NAN);
    }
}

static void measure_snell(void) {
    static cases c;
    rng g = rng_seed(11, 4);
    for (int k = -7; k <= -2; k++) {
        near_critical(&c, pow(10, k), &g);
        for (int i = 0; i < CASES; i += 2) { // every other one below it
            const double e = (double)c.eta[i], critical = sqrt((1 - e) * (1 + e));
            c.cosine[i] = (real)(2 * critical - (double)c.cosine[i]);
        }
        snell_rows(&c, pow(10, k));
    }
}

// ---- one ray, or both? -------------------------------------------------------------------------

// A ball of glass under a sky whose light is noise: 2u times its brightness.
typedef struct {
    real n;
    int both;   // boundaries at which both rays are followed; then one is chosen
    bool evens; // chosen by a coin, and weighted; else with probability R
    long rays;  // traced so far
} chooser;

static const sphere ball = {{0, 0, 0}, 1};

static double follow(chooser *w, ray r, int boundary, rng *g) {
    w->rays++;
    const real t = sphere_hit(ball, r, 0, NO_HIT);
    if (t == NO_HIT) return 2 * rng_double(g) * (double)clear_sky(r.d).x;
    if (boundary == 20) return 0;
    const hit h = sphere_surface(ball, r, t);
    const vec3 n = h.front ? h.n : neg(h.n);
    const real eta = h.front ? w->n : 1 / w->n;
    const ray back = {offset_origin(h.p, h.error, n, n), keep_unit(reflect(r.d, n))};
    ray on = {offset_origin(h.p, h.error, neg(n), neg(n)), {0, 0, 0}};
    if (!refract(r.d, n, eta, &on.d)) return follow(w, back, boundary + 1, g);
    const double R = (double)fresnel_dielectric(fmin(-dot(r.d, n), 1), eta);
    if (boundary < w->both) {
        const double reflected = R * follow(w, back, boundary + 1, g);
        return reflected + (1 - R) * follow(w, on, boundary + 1, g);
    }
    const double p = w->evens ? 0.5 : R;
    const bool reflects = rng_double(g) < p;
    const double weight = reflects ? R / p : (1 - R) / (1 - p);
    return weight * follow(w, reflects ? back : on, boundary + 1, g);
}

// The mean variance of one estimate of a ray's light, times its mean number of rays.
static double effort(chooser w) {
    enum { RAYS = 1000, SAMPLES = 30 };
    rng g = rng_seed(11, 5);
    double variance = 0;
    for (int i = 0; i < RAYS; i++) {
        const vec3 O = scale(4, unit_vector(&g)), p = scale((real)0.95, unit_vector(&g));
        const ray r = {O, normalize(sub(p, O))};
        running light = {0};
        for (int k = 0; k < SAMPLES; k++) running_add(&light, follow(&w, r, 0, &g));
        variance += running_variance(&light) / RAYS;
    }
    return variance * (double)w.rays / ((double)RAYS * SAMPLES);
}

static void measure_choice(void) {
    static const struct {
        const char *name;
        int both;
        bool evens;
    } ways[] = {{"one, with probability R", 0, false},
                {"one, by a coin, weighted", 0, true},
                {"both at the first boundary", 1, false},
                {"both at the first two", 2, false},
                {"both at the first eight", 8, false}};
    const double n[] = {1.1, 1.33, 1.5, 2.4};
    for (int v = 0; v < COUNT(ways); v++)
        for (int i = 0; i < COUNT(n); i++)
            csv_row("one ray or both", ways[v].name, "n", n[i], "variance x rays",
                    effort((chooser){(real)n[i], ways[v].both, ways[v].evens, 0}), "ns", NAN);
}

int main(void) {
    measure_rounding();
    measure_snell();
    metal_costs();
    if (!getenv("ERRORS_ONLY")) measure_beside_plain();
    if (sizeof(real) > sizeof(float)) return 0; // the rest is no matter of rounding
    measure_schlick();
    measure_metals();
    measure_choice();
}
