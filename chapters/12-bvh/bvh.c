// bvh.c: the tree as a mesh's finder, its figures, and whether it keeps its promises.
#include "chapters/12-bvh/bvh.h"

#include <stdlib.h>

static triangle_point nearest(const void *tree, ray r, real t_min, real t_max, int *index) {
    return bvh_nearest(tree, r, t_min, t_max, index, NULL);
}
static bool any(const void *tree, ray r, real t_min, real t_max) {
    return bvh_any(tree, r, t_min, t_max, NULL);
}
finder bvh_finder(const bvh *b) {
    return (finder){b, nearest, any};
}

// ---- figures -----------------------------------------------------------------------

static void measure_from(const bvh *b, int node, int depth, bvh_figures *f) {
    const bvh_node *n = &b->nodes[node];
    const real whole = aabb_area(b->nodes[0].box);
    const double share = whole > 0 ? (double)aabb_area(n->box) / (double)whole : 1;
    if (depth > f->depth) f->depth = depth;
    f->cost += share * (n->count ? C_HIT * n->count : C_STEP);
    if (n->count) {
        f->leaves++;
        if (n->count > f->largest_leaf) f->largest_leaf = n->count;
        return;
    }
    measure_from(b, n->first, depth + 1, f);
    measure_from(b, n->first + 1, depth + 1, f);
}

bvh_figures bvh_measure(const bvh *b) {
    bvh_figures f = {0};
    f.bytes = (size_t)b->node_count * sizeof *b->nodes +
              (size_t)b->count * (sizeof *b->triangles + sizeof *b->order);
    if (b->count) measure_from(b, 0, 0, &f);
    return f;
}

// ---- promises ----------------------------------------------------------------------

static bool same_box(aabb a, aabb b) {
    return a.min.x == b.min.x && a.min.y == b.min.y && a.min.z == b.min.z &&
           a.max.x == b.max.x && a.max.y == b.max.y && a.max.z == b.max.z;
}

typedef struct {
    const bvh *b;
    char *seen; // how often each position of `order` is in a leaf, at most 2
    const char *flaw;
} inspection;

static aabb inspect_leaf(inspection *x, const bvh_node *n) {
    aabb box = aabb_empty;
    if (n->first < 0 || n->count < 0 || n->first > x->b->count - n->count) {
        x->flaw = "a leaf's triangles lie outside the array";
        return box;
    }
    for (int i = n->first; i < n->first + n->count; i++) {
        if (x->seen[i]++) x->flaw = "a triangle is in two leaves";
        box = aabb_join(box, aabb_of(mesh_triangle(x->b->m, x->b->order[i])));
    }
    return box;
}

static aabb inspect(inspection *x, int node, int depth) {
    const bvh_node *n = &x->b->nodes[node];
    if (depth > BVH_DEPTH) x->flaw = "a leaf is deeper than BVH_DEPTH";
    if (x->flaw) return n->box;
    aabb box;
    if (n->count) {
        box = inspect_leaf(x, n);
    } else if (n->first <= node || n->first + 1 >= x->b->node_count || n->first % 2) {
        x->flaw = "an inner node's children are not a pair of later nodes";
        return n->box;
    } else {
        const aabb left = inspect(x, n->first, depth + 1);
        box = aabb_join(left, inspect(x, n->first + 1, depth + 1));
    }
    if (!x->flaw && !same_box(box, n->box))
        x->flaw = "a box is not the smallest that holds all below it";
    return n->box;
}

const char *bvh_flaw(const bvh *b) {
    if (!b->count) return NULL;
    inspection x = {.b = b, .seen = calloc((size_t)b->count, 1)};
    if (!x.seen) return "no memory to inspect the tree";
    inspect(&x, 0, 0);
    for (int i = 0; i < b->count && !x.flaw; i++)
        if (!x.seen[i]) x.flaw = "a triangle is in no leaf";
    free(x.seen);
    return x.flaw;
}
