// measure.c: slab tests and what they miss; trees by their builds, leaves and bins; how the work
// grows with the number of triangles; ways to walk; what a watertight test costs.
#include <stdlib.h>

#include "chapters/12-bvh/slabs.h"
#include "chapters/12-bvh/trials.h"

// ---- walks -----------------------------------------------------------------------------

static void measure_walks(const trial *x, int site) {
    static const struct {
        const char *name;
        walk *how;
    } walks[] = {{"nearest, near child first", nearest_first},
                 {"nearest, left child first", left_first},
                 {"any", any}};
    for (int i = 0; i < COUNT(walks); i++)
        for (int k = 0; k < 2; k++)
            outcome_rows("walks: steps", "walks: tests", walks[i].name, "rays",
                         2 * site + k + 1,
                         try_walk(&x->tree, k ? x->bounce : x->primary, k ? x->bounces : RAYS,
                                  walks[i].how));
}

// ---- builds, leaves, bins --------------------------------------------------------------

static bvh timed_build(const mesh *m, bvh_options how, double *ns) {
    const bool clocked = !getenv("ERRORS_ONLY");
    bvh tree = bvh_build(m, how);
    *ns = clocked ? INFINITY : 0;
    for (int round = 0; clocked && round < 3; round++) {
        bvh_free(&tree);
        const double start = clock_seconds();
        tree = bvh_build(m, how);
        *ns = fmin(*ns, 1e9 * (clock_seconds() - start) / m->count);
    }
    return tree;
}

static const char *const rule_names[] = {"median", "midpoint", "SAH, 16 bins", "SAH, sweep"};

static void measure_builds(const trial *x, int site) {
    for (int rule = SPLIT_MEDIAN; rule <= SPLIT_SWEEP; rule++) {
        bvh_options how = bvh_defaults;
        double ns;
        how.rule = (split_rule)rule;
        bvh tree = timed_build(&x->m, how, &ns);
        const bvh_figures f = bvh_measure(&tree);
        const char *name = rule_names[rule];
        outcome_rows("builds: steps", "builds: tests", name, "mesh", site + 1,
                     try_walk(&tree, x->bounce, x->bounces, nearest_first));
        csv_row("builds: expected cost", name, "mesh", site + 1, "steps and tests per line",
                f.cost, "ns", ns);
        csv_row("builds: memory", name, "mesh", site + 1, "bytes per triangle",
                (double)f.bytes / x->m.count, "", NAN);
        bvh_free(&tree);
    }
}

// Trees 1 to 4: knot by SAH, by median; cave by SAH, by median.
static void measure_leaves(const trial *x, split_rule rule, int tree_number) {
    for (int size = 1; size <= 16; size *= 2) {
        bvh_options how = bvh_defaults;
        char name[32];
        how.rule = rule;
        how.leaf_size = size;
        snprintf(name, sizeof name, "at most %d", size);
        bvh tree = bvh_build(&x->m, how);
        outcome_rows("leaf size: steps", "leaf size: tests", name, "tree", tree_number,
                     try_walk(&tree, x->bounce, x->bounces, nearest_first));
        csv_row("leaf size: memory", name, "tree", tree_number, "bytes per triangle",
                (double)bvh_measure(&tree).bytes / x->m.count, "", NAN);
        bvh_free(&tree);
    }
}

static void measure_bins(const trial *x, int site) {
    for (int bins = 2; bins <= BVH_BINS; bins *= 2) {
        bvh_options how = bvh_defaults;
        char name[32];
        double ns;
        how.bins = bins;
        snprintf(name, sizeof name, "%d bins", bins);
        bvh tree = timed_build(&x->m, how, &ns);
        const outcome o = try_walk(&tree, x->bounce, x->bounces, nearest_first);
        csv_row("bins: rays", name, "mesh", site + 1, "steps and tests per ray",
                o.steps + o.tests, "ns", o.ns);
        csv_row("bins: build", name, "mesh", site + 1, "", NAN, "ns", ns);
        bvh_free(&tree);
    }
}

// ---- growth ----------------------------------------------------------------------------

enum { BRUTE_MOST = 10000, BRUTE_RAYS = 32 };

static bool brute(const bvh *b, ray r, effort *spent) {
    int index = 0;
    if (spent) spent->tests += b->m->count;
    return mesh_hit(b->m, r, 0, NO_HIT, &index).t != NO_HIT;
}

static void measure_growth(int site) {
    static trial x;
    for (long n = 10; n <= 1000000; n *= 10) {
        trial_make(&x, site, n);
        const outcome o = try_walk(&x.tree, x.bounce, x.bounces, nearest_first);
        csv_row("growth", sites[site].name, "triangles", (double)n, "steps and tests per ray",
                o.steps + o.tests, "ns", o.ns);
        if (site == KNOT && n <= BRUTE_MOST) {
            x.m.around.r = 0; // every triangle is asked
            const outcome all = try_walk(&x.tree, x.bounce, BRUTE_RAYS, brute);
            csv_row("growth", "brute force, knot", "triangles", (double)n,
                    "steps and tests per ray", all.tests, "ns", all.ns);
        }
        trial_free(&x);
    }
}

// ---- leaks -----------------------------------------------------------------------------

enum { LEAK_RAYS = 200000 };

// From the origin, inside a closed mesh, to points of edges or to corners: what is lost.
static void measure_leaks(const trial *x) {
    for (int test = TEST_WATERTIGHT; test <= TEST_PLAIN; test++) {
        const char *name = test == TEST_PLAIN ? "plain" : "watertight";
        bvh_options how = bvh_defaults;
        how.test = (triangle_test)test;
        bvh tree = bvh_build(&x->m, how);
        for (int corners = 0; corners < 2; corners++) {
            rng g = rng_seed(12, 11);
            int lost = 0;
            for (int i = 0; i < LEAK_RAYS; i++) {
                const triangle T = mesh_triangle(&x->m, (int)(rng_double(&g) * x->m.count));
                const real share = corners ? 0 : rng_real(&g);
                lost += !any(&tree, (ray){{0, 0, 0}, lerp(T.p1, T.p2, share)}, NULL);
            }
            csv_row("leaks", name, "aimed at", 1 + corners, "share of rays lost",
                    (double)lost / LEAK_RAYS, "ns",
                    corners ? try_walk(&tree, x->bounce, x->bounces, nearest_first).ns
                            : try_walk(&tree, x->primary, RAYS, nearest_first).ns);
        }
        bvh_free(&tree);
    }
}

enum { TRIANGLES = 30000 };

int main(void) {
    static trial x[SITES];
    measure_slabs();
    trial_make(&x[CAVE], CAVE, TRIANGLES);
    measure_leaks(&x[CAVE]);
    if (sizeof(real) > sizeof(float)) return 0; // the rest is counting, the same in double
    for (int site = 0; site < SITES; site++) {
        if (site != CAVE) trial_make(&x[site], site, TRIANGLES);
        measure_builds(&x[site], site);
        if (site <= CAVE) measure_walks(&x[site], site);
    }
    measure_leaves(&x[KNOT], SPLIT_SAH, 1);
    measure_leaves(&x[KNOT], SPLIT_MEDIAN, 2);
    measure_leaves(&x[CAVE], SPLIT_SAH, 3);
    measure_leaves(&x[CAVE], SPLIT_MEDIAN, 4);
    measure_bins(&x[KNOT], KNOT);
    measure_bins(&x[CAVE], CAVE);
    measure_growth(KNOT);
    measure_growth(CAVE);
}
