// octree.c: any hit, the leaf around a point, the tree's figures, and whether it keeps its promises.
#include <stdlib.h>

#include "chapters/14-octree/cell.h"
#include "common/die.h"

// A cell to be looked into.
typedef struct {
    int node;
    aabb cell;
} waiting;

static bool leaf_any(const octree *o, const octree_node *leaf, ray r, real t_min, real t_max,
                     effort *spent) {
    for (int k = leaf->first; k < leaf->first + leaf->count; k++) {
        if (spent) spent->tests++;
        if (triangle_hit(mesh_triangle(o->m, o->lists[k]), r, t_min, t_max).t != NO_HIT)
            return true;
    }
    return false;
}

// In any order: the first hit is the answer. The larger part of the way is the same for the
// nearest hit.
bool octree_any(const octree *o, ray r, real t_min, real t_max, effort *spent) {
    const slab_ray s = slab_ray_of(r);
    waiting stack[OCTREE_STACK];
    int top = 1;
    real t;
    if (!o->node_count) return false;
    stack[0] = (waiting){0, o->cube};
    if (spent) spent->steps++;
    if (!aabb_hit(&o->cube, &s, t_min, t_max, &t)) return false;
    while (top > 0) {
        const waiting w = stack[--top];
        const octree_node *n = &o->nodes[w.node];
        if (is_leaf(n)) {
            if (leaf_any(o, n, r, t_min, t_max, spent)) return true;
            continue;
        }
        int child = n->first;
        for (int i = 0; i < 8; i++) {
            if (!is_stored(stored_children(n), i)) continue;
            const waiting next = {child++, cell_child(w.cell, i)};
            if (spent) spent->steps++;
            if (aabb_hit(&next.cell, &s, t_min, t_max, &t)) stack[top++] = next;
        }
    }
    return false;
}

static triangle_point nearest(const void *tree, ray r, real t_min, real t_max, int *index) {
    return octree_nearest(tree, r, t_min, t_max, index, NULL);
}
static bool any(const void *tree, ray r, real t_min, real t_max) {
    return octree_any(tree, r, t_min, t_max, NULL);
}
finder octree_finder(const octree *o) {
    return (finder){o, nearest, any};
}

// ---- the leaf around a point -----------------------------------------------------------

static bool holds(aabb cell, vec3 p) {
    return cell.min.x <= p.x && p.x <= cell.max.x && cell.min.y <= p.y && p.y <= cell.max.y &&
           cell.min.z <= p.z && p.z <= cell.max.z;
}

const octree_node *octree_at(const octree *o, vec3 p, aabb *cell, int *depth) {
    *cell = o->cube;
    *depth = -1;
    if (!o->node_count || !holds(o->cube, p)) return NULL;
    const octree_node *n = o->nodes;
    for (*depth = 0; !is_leaf(n); ++*depth) {
        const int i = child_of(p, cell_middle(*cell));
        *cell = cell_child(*cell, i);
        if (!is_stored(stored_children(n), i)) return ++*depth, NULL;
        n = &o->nodes[n->first + child_index(stored_children(n), i)];
    }
    return n;
}

// ---- figures -----------------------------------------------------------------------------

static void measure_from(const octree *o, const octree_node *n, int depth, octree_figures *f) {
    if (depth > f->depth) f->depth = depth;
    if (is_leaf(n)) {
        f->leaves++;
        if (n->count > f->largest_leaf) f->largest_leaf = n->count;
        return;
    }
    f->inner++;
    const octree_node *child = &o->nodes[n->first];
    for (int i = 0; i < 8; i++)
        if (is_stored(stored_children(n), i)) measure_from(o, child++, depth + 1, f);
}

octree_figures octree_measure(const octree *o) {
    octree_figures f = {.entries = o->entry_count};
    f.bytes =
        (size_t)o->node_count * sizeof *o->nodes + (size_t)o->entry_count * sizeof *o->lists;
    if (o->node_count) measure_from(o, o->nodes, 0, &f);
    return f;
}

// ---- behind the interface of chapter 13 ------------------------------------------------

static void *searcher_build(const mesh *m) {
    octree *o = malloc(sizeof *o);
    if (!o) die(EXIT_RUN, "no memory for an octree");
    *o = octree_build(m, octree_defaults);
    return o;
}
static void searcher_free(void *tree) {
    octree_free(tree);
    free(tree);
}
static triangle_point searcher_nearest(const void *tree, ray r, real t_min, real t_max,
                                       int *index, effort *spent) {
    return octree_nearest(tree, r, t_min, t_max, index, spent);
}
static bool searcher_any(const void *tree, ray r, real t_min, real t_max, effort *spent) {
    return octree_any(tree, r, t_min, t_max, spent);
}
static size_t searcher_bytes(const void *tree) {
    return octree_measure(tree).bytes;
}
static const char *searcher_flaw(const void *tree) {
    return octree_flaw(tree);
}

const searcher by_octree = {"octree",     searcher_build, searcher_free, searcher_nearest,
                            searcher_any, searcher_bytes, searcher_flaw};
