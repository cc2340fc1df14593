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

static bool same_point(vec3 a, vec3 b) {
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

static bool finite_triangle(triangle T) {
    return is_finite(T.p1) && is_finite(T.p2) && is_finite(T.p3);
}

typedef struct {
    const bvh *b;
    bool *seen; // by triangle of the mesh: is it in a leaf?
    int found;  // triangles in leaves
    int next;   // where the next pair of children must stand
    const char *flaw;
} inspection;

// Place i of the leaves: whose box is it, and is it what it says?
static aabb inspect_triangle(inspection *x, int i) {
    const int k = x->b->order[i];
    if (k < 0 || k >= x->b->m->count) {
        x->flaw = "a leaf names a triangle that the mesh does not have";
        return aabb_empty;
    }
    const triangle T = mesh_triangle(x->b->m, k), copy = x->b->triangles[i];
    if (x->seen[k])
        x->flaw = "a triangle is in two leaves, or twice in one";
    else if (!finite_triangle(T))
        x->flaw = "a triangle in a leaf is not finite";
    else if (!same_point(T.p1, copy.p1) || !same_point(T.p2, copy.p2) ||
             !same_point(T.p3, copy.p3))
        x->flaw = "a triangle in a leaf is not the mesh's";
    x->seen[k] = true;
    x->found++;
    return aabb_of(T);
}

static aabb inspect_leaf(inspection *x, const bvh_node *n) {
    aabb box = aabb_empty;
    if (n->first < 0 || n->count < 0 || n->first > x->b->count - n->count) {
        x->flaw = "a leaf's triangles lie outside the array";
        return box;
    }
    for (int i = n->first; i < n->first + n->count && !x->flaw; i++)
        box = aabb_join(box, inspect_triangle(x, i));
    return box;
}

static aabb inspect(inspection *x, int node, int depth);

static aabb inspect_children(inspection *x, int first, int depth) {
    if (first != x->next || first + 1 >= x->b->node_count) {
        x->flaw = "an inner node's children are not the next pair, depth first";
        return aabb_empty;
    }
    x->next += 2;
    const aabb left = inspect(x, first, depth);
    return aabb_join(left, inspect(x, first + 1, depth));
}

static aabb inspect(inspection *x, int node, int depth) {
    const bvh_node *n = &x->b->nodes[node];
    if (!x->flaw && depth > BVH_DEPTH) x->flaw = "a leaf is deeper than BVH_DEPTH";
    if (x->flaw) return n->box;
    const aabb box = n->count ? inspect_leaf(x, n) : inspect_children(x, n->first, depth + 1);
    if (!x->flaw && !(same_point(box.min, n->box.min) && same_point(box.max, n->box.max)))
        x->flaw = "a box is not the smallest that holds all below it";
    return n->box;
}

static void inspect_whole(inspection *x) {
    const bvh *b = x->b;
    if (b->count > 0) inspect(x, 0, 0);
    for (int k = 0; k < b->m->count && !x->flaw; k++)
        if (!x->seen[k] && finite_triangle(mesh_triangle(b->m, k)))
            x->flaw = "a triangle is in no leaf";
    if (!x->flaw && (x->found != b->count || b->node_count != (b->count ? x->next : 0)))
        x->flaw = "there are places or nodes that belong to no leaf";
}

const char *bvh_flaw(const bvh *b) {
    inspection x = {.b = b, .next = 2, .seen = calloc((size_t)b->m->count + 1, sizeof *x.seen)};
    if (!x.seen) return "no memory to inspect the tree";
    inspect_whole(&x);
    free(x.seen);
    return x.flaw;
}
