// build.c: from a heap of triangles to a tree.
#include <limits.h>
#include <stdlib.h>

#include "chapters/12-bvh/split.h"
#include "common/die.h"
#include "common/progress.h"

const bvh_options bvh_defaults = {SPLIT_SAH, 4, 16, TEST_WATERTIGHT};

typedef struct {
    bvh *tree;
    bvh_item *items;
    bvh_options how;
    split_function *split;
    progress *shown; // or NULL
} builder;

static split_function *function_of(split_rule rule) {
    switch (rule) {
    case SPLIT_MEDIAN:
        return split_by_median;
    case SPLIT_MIDPOINT:
        return split_by_midpoint;
    case SPLIT_SWEEP:
        return split_by_sweep;
    default:
        return split_by_bins;
    }
}

static int halvings(int count) { // until one is left
    int k = 0;
    while (count > 1) count = (count + 1) / 2, k++;
    return k;
}

// How many of the items go to the left, 0: none, a leaf. When the rule finds no division of
// too many, or has used up its depth, the median takes over: it always halves.
static int divide(const builder *b, bvh_item *items, int count, extent in, int depth) {
    if (count < 2) return 0;
    const int left =
        depth + halvings(count) < BVH_DEPTH ? b->split(items, count, in, b->how) : 0;
    if (left > 0 || count <= b->how.leaf_size) return left;
    split_median(items, count, longest_axis(in.centres));
    return count / 2;
}

static void make_leaf(const builder *b, bvh_node *n, int from, int to) {
    n->first = from;
    n->count = to - from;
    if (b->shown) progress_add(b->shown, n->count);
}

static void make_node(const builder *b, int node, int from, int to, extent in, int depth) {
    bvh_item *items = b->items + from;
    const int left = divide(b, items, to - from, in, depth);
    bvh_node *n = &b->tree->nodes[node];
    n->box = in.box;
    if (!left) {
        make_leaf(b, n, from, to);
        return;
    }
    n->first = b->tree->node_count;
    n->count = 0;
    b->tree->node_count += 2;
    const extent l = items_extent(items, left),
                 r = items_extent(items + left, to - from - left);
    make_node(b, n->first, from, from + left, l, depth + 1);
    make_node(b, n->first + 1, from + left, to, r, depth + 1);
}

// ---- before and after --------------------------------------------------------------

static void *room_for(int count, size_t size) {
    void *room = aligned_alloc(64, ((size_t)count * size + 63) / 64 * 64);
    if (!room) die(EXIT_RUN, "no memory for a tree over %d triangles", count);
    return room;
}

static int finite_items(const mesh *m, bvh_item *items) {
    int count = 0;
    for (int i = 0; i < m->count; i++) {
        const triangle T = mesh_triangle(m, i);
        if (!is_finite(T.p1) || !is_finite(T.p2) || !is_finite(T.p3)) continue;
        items[count++] = (bvh_item){aabb_of(T), i};
    }
    return count;
}

static void keep_order(bvh *tree, const bvh_item *items) {
    tree->triangles = room_for(tree->count, sizeof *tree->triangles);
    tree->order = room_for(tree->count, sizeof *tree->order);
    for (int i = 0; i < tree->count; i++) {
        tree->order[i] = items[i].triangle;
        tree->triangles[i] = mesh_triangle(tree->m, items[i].triangle);
    }
}

bvh bvh_build(const mesh *m, bvh_options how) {
    bvh tree = {.m = m, .test = how.test};
    if (m->count >= INT_MAX / 2)
        die(EXIT_RUN, "%d triangles are too many for a tree", m->count);
    bvh_item *items = room_for(m->count + 1, sizeof *items);
    tree.count = finite_items(m, items);
    if (tree.count > 0) {
        progress shown;
        const bool large = tree.count > 1000000;
        if (large) {
            shown = progress_start("building the tree", tree.count, NULL);
            shown.unit = "triangles";
        }
        tree.nodes = room_for(2 * tree.count, sizeof *tree.nodes);
        tree.nodes[1] = (bvh_node){aabb_empty, 0, 0};
        tree.node_count = 2;
        const builder b = {&tree, items, how, function_of(how.rule), large ? &shown : NULL};
        make_node(&b, 0, 0, tree.count, items_extent(items, tree.count), 0);
        if (large) progress_end(&shown);
        keep_order(&tree, items);
    }
    free(items);
    return tree;
}

void bvh_free(bvh *b) {
    free(b->nodes);
    free(b->triangles);
    free(b->order);
    *b = (bvh){0};
}
