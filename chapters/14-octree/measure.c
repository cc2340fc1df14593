// measure.c: all searchers on the same rays, over meshes of 10 to a million triangles: steps,
// tests, memory, time. And what dense children and other leaf sizes would do to the octree.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "chapters/14-octree/contest.h"
#include "common/measure.h"

// Without timing the meshes end at 10,000 triangles.
enum { SIDE = 24, ROUNDS = 5 };
static const long sizes[] = {10, 100, 1000, 10000, 100000, 1000000};

static bool timed_run(void) {
    return getenv("ERRORS_ONLY") == NULL;
}
static int sizes_run(void) {
    return timed_run() ? COUNT(sizes) : 4;
}

// The fastest of some rounds, in ns a ray; 0 when nothing is timed.
static double ns_for(const searcher *s, const void *tree, ray_list list, int count, bool any) {
    double best = INFINITY;
    for (int k = 0; timed_run() && k < ROUNDS; k++) {
        const double start = clock_seconds();
        const effort spent = spent_on(s, tree, list, count, any);
        keep((double)spent.tests);
        best = fmin(best, 1e9 * (clock_seconds() - start) / count);
    }
    return timed_run() ? best : 0;
}

static void row(const char *of, const char *kind, const char *what, const searcher *s, long n,
                double value, double ns) {
    char table[100], unit[40];
    snprintf(table, sizeof table, "%s, %s: %s", of, kind, what);
    snprintf(unit, sizeof unit, "%s per ray", what);
    csv_row(table, s->name, "triangles", (double)n, unit, value, "ns a ray", ns);
}

static void measure_rays(const shape *of, const char *kind, const searcher *s, const void *tree,
                         const mesh *m, ray_list list, long n) {
    const int count = bearable(s, m, list.count);
    if (count == 0) return;
    const effort first = spent_on(s, tree, list, count, false),
                 any = spent_on(s, tree, list, count, true);
    row(of->name, kind, "steps", s, n, (double)first.steps / count,
        ns_for(s, tree, list, count, false));
    row(of->name, kind, "tests", s, n, (double)first.tests / count, NAN);
    char with_any[40];
    snprintf(with_any, sizeof with_any, "%s, any hit", kind);
    row(of->name, with_any, "steps", s, n, (double)any.steps / count,
        ns_for(s, tree, list, count, true));
    row(of->name, with_any, "tests", s, n, (double)any.tests / count, NAN);
}

// ---- all searchers -------------------------------------------------------------------------

static void measure_mesh(const shape *of, long n) {
    mesh m = of->make(n);
    void *first = by_bvh_sah.build(&m);
    ray_list primary = primary_rays(of, SIDE);
    ray_list bounced = bounce_rays(&m, &by_bvh_sah, first, primary);
    by_bvh_sah.free(first);
    for (int k = 0; k < CONTESTANTS; k++) {
        const searcher *s = contestants[k];
        const double start = clock_seconds();
        void *tree = s->build(&m);
        const double ns = timed_run() ? 1e9 * (clock_seconds() - start) / m.count : 0;
        char table[100];
        snprintf(table, sizeof table, "%s: memory", of->name);
        csv_row(table, s->name, "triangles", (double)n, "bytes per triangle",
                (double)s->bytes(tree) / m.count, "ns to build, a triangle", ns);
        measure_rays(of, "primary", s, tree, &m, primary, n);
        measure_rays(of, "diffuse", s, tree, &m, bounced, n);
        s->free(tree);
    }
    free(primary.rays);
    free(bounced.rays);
    mesh_free(&m);
}

// ---- the octree's own choices ----------------------------------------------------------------

static void measure_choice(const shape *of, const char *table, const char *name, const char *x,
                           double value, octree_options how) {
    mesh m = of->make(10000);
    octree o = octree_build(&m, how);
    ray_list list = primary_rays(of, SIDE);
    effort spent = {0, 0};
    for (int i = 0; i < list.count; i++) {
        int index = 0;
        octree_nearest(&o, list.rays[i], 0, NO_HIT, &index, &spent);
    }
    const double bytes = (double)octree_measure(&o).bytes / m.count;
    const struct {
        const char *what;
        double value;
    } rows[] = {{"steps per ray", (double)spent.steps / list.count},
                {"tests per ray", (double)spent.tests / list.count},
                {"bytes per triangle", bytes}};
    for (int k = 0; k < COUNT(rows); k++) {
        char title[100];
        snprintf(title, sizeof title, "%s: %s", table, rows[k].what);
        csv_row(title, name, x, value, rows[k].what, rows[k].value, "ns", NAN);
    }
    free(list.rays);
    octree_free(&o);
    mesh_free(&m);
}

static void measure_choices(const shape *of) {
    for (int size = 1; size <= 64; size *= 4) {
        octree_options how = octree_defaults;
        how.leaf_size = size;
        measure_choice(of, "leaf size", of->name, "leaf size", size, how);
        how.dense = true;
        char name[40];
        snprintf(name, sizeof name, "%s, dense", of->name);
        measure_choice(of, "leaf size", name, "leaf size", size, how);
    }
}

int main(void) {
    static const char *const kinds[] = {"cloud", "knot", "stadium"};
    for (const shape *s = shapes; s->name; s++) {
        for (int k = 0; k < COUNT(kinds); k++) {
            if (strcmp(s->name, kinds[k])) continue;
            for (int i = 0; i < sizes_run(); i++) measure_mesh(s, sizes[i]);
            measure_choices(s);
        }
    }
}
