// trials.h: what measure.c needs of meshes, rays and walks.
#ifndef CHAPTER_TRIALS_H
#define CHAPTER_TRIALS_H

#include "chapters/10-importance-sampling/importance.h"
#include "chapters/12-bvh/leaf.h"
#include "chapters/12-bvh/shapes.h"
#include "common/measure.h"

enum { ROUNDS = 9 };

// ---- meshes and rays -------------------------------------------------------------------

// Rays of a camera, and matte bounces from where they hit.
enum { ACROSS = 64, DOWN = 48, RAYS = ACROSS * DOWN };
typedef struct {
    mesh m;
    ray primary[RAYS], bounce[RAYS];
    int bounces;
    bvh tree; // by bvh_defaults
} trial;

static const struct {
    const char *name;
    mesh (*make)(long triangles);
    vec3 eye, target;
    real fov;
} sites[] = {
    {"knot", shape_knot, {(real)0.5, 1, (real)3.1}, {0, 0, 0}, 40},
    {"cave", shape_cave, {0, 0, 0}, {0, 0, -1}, 69},
    {"cloud", shape_cloud, {(real)0.5, 1, 3}, {0, 0, 0}, 40},
    {"stadium", shape_stadium, {(real)0.002, (real)0.001, (real)0.006}, {0, 0, 0}, 40}};
enum { KNOT, CAVE, SITES = 4 };

static void add_bounce(trial *x, ray r, rng *g) {
    int index = 0;
    const triangle_point q = bvh_nearest(&x->tree, r, 0, NO_HIT, &index, NULL);
    if (q.t == NO_HIT) return;
    const hit h = triangle_surface(mesh_triangle(&x->m, index), r, q);
    const vec3 n = h.front ? h.n : neg(h.n);
    x->bounce[x->bounces++] = (ray){offset_origin(h.p, h.error, n, n), cosine_direction(n, g)};
}

// In its place: the tree points at the mesh.
static void trial_make(trial *x, int site, long triangles) {
    const vec3 up = {0, 1, 0};
    const camera cam =
        camera_look_at(sites[site].eye, sites[site].target, up, sites[site].fov, ACROSS, DOWN);
    rng g = rng_seed(12, 7);
    x->m = sites[site].make(triangles);
    x->bounces = 0;
    x->tree = bvh_build(&x->m, bvh_defaults);
    for (int i = 0; i < RAYS; i++) {
        const real dx = rng_real(&g), dy = rng_real(&g);
        x->primary[i] = camera_ray(&cam, (real)(i % ACROSS) + dx, (real)(i / ACROSS) + dy);
        add_bounce(x, x->primary[i], &g);
    }
}

static void trial_free(trial *x) {
    bvh_free(&x->tree);
    mesh_free(&x->m);
}

// ---- walks -----------------------------------------------------------------------------

typedef bool walk(const bvh *b, ray r, effort *spent);

static bool nearest_first(const bvh *b, ray r, effort *spent) {
    int index = 0;
    return bvh_nearest(b, r, 0, NO_HIT, &index, spent).t != NO_HIT;
}
static bool any(const bvh *b, ray r, effort *spent) {
    return bvh_any(b, r, 0, NO_HIT, spent);
}

// The nearest hit without a look at which child is nearer.
static bool left_first(const bvh *b, ray r, effort *spent) {
    const slab_ray s = slab_ray_of(r);
    bvh_found found = bvh_nothing_found(NO_HIT);
    int stack[BVH_DEPTH + 1] = {0};
    for (int top = b->count ? 1 : 0; top > 0;) {
        const bvh_node *n = &b->nodes[stack[--top]];
        real enter;
        if (spent) spent->steps++;
        if (!aabb_hit(&n->box, &s, 0, found.limit, &enter)) continue;
        if (n->count) {
            leaf_nearest(b, n, r, 0, &found, spent);
        } else {
            stack[top++] = n->first + 1;
            stack[top++] = n->first;
        }
    }
    return found.best.t != NO_HIT;
}

typedef struct {
    const bvh *tree;
    const ray *rays;
    int count;
    walk *how;
} walked;

static void run_walk(void *data) {
    const walked *w = data;
    int hits = 0;
    for (int i = 0; i < w->count; i++) hits += w->how(w->tree, w->rays[i], NULL);
    keep(hits);
}

typedef struct {
    double steps, tests, ns; // per ray
} outcome;

static outcome try_walk(const bvh *tree, const ray *rays, int count, walk *how) {
    walked w = {tree, rays, count, how};
    const timed run = {"", run_walk};
    effort spent = {0};
    outcome o = {.ns = INFINITY};
    for (int i = 0; i < count; i++) how(tree, rays[i], &spent);
    for (int round = 0; round < ROUNDS; round++) { // the best: others share the machine
        double once;
        measure_ns(&run, 1, &w, count, 1, &once);
        o.ns = fmin(o.ns, once);
    }
    o.steps = (double)spent.steps / count;
    o.tests = (double)spent.tests / count;
    return o;
}

static void outcome_rows(const char *steps, const char *tests, const char *variant,
                         const char *x_name, double x, outcome o) {
    csv_row(steps, variant, x_name, x, "steps per ray", o.steps, "ns", o.ns);
    csv_row(tests, variant, x_name, x, "tests per ray", o.tests, "ns", NAN);
}

#endif
