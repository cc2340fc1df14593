// kd_build.c: from a heap of triangles to cells.
#include <stdlib.h>

#include "chapters/13-kd-tree/kd_split.h"
#include "common/die.h"
#include "common/progress.h"

const kd_options kd_defaults = {
    .step = (real)0.5, .bonus = (real)0.2, .budget = 16, .clip = true};

int kd_depth_limit(int count) {
    int log2 = 0;
    while (count > 1) count /= 2, log2++;
    return 8 + 13 * log2 / 10;
}

typedef struct {
    kd_tree *tree;
    long node_room, list_room;
    int depth_limit;
    progress *shown; // or NULL
} builder;

// A list of none, too: realloc may give NULL for no bytes.
static void *grown(void *room, long count, size_t size) {
    room = realloc(room, (size_t)(count ? count : 1) * size);
    if (!room) die(EXIT_RUN, "no memory for a tree of %ld nodes or references", count);
    return room;
}

static uint32_t new_node(builder *b) {
    kd_tree *k = b->tree;
    if (k->node_count == b->node_room)
        k->nodes = grown(k->nodes, b->node_room *= 2, sizeof *k->nodes);
    if (k->node_count >> 30) die(EXIT_RUN, "a tree of more than 2^30 nodes");
    return (uint32_t)k->node_count++;
}

// A cell to be filled. Of `budget` divisions and references below it, `count` are spoken for.
typedef struct {
    bvh_item *items; // freed when the node is made
    int count, depth;
    int64_t budget;
    aabb cell;
} heap;

static void make_leaf(builder *b, uint32_t node, const heap *h) {
    kd_tree *k = b->tree;
    while (k->list_count + h->count > b->list_room)
        k->lists = grown(k->lists, b->list_room *= 2, sizeof *k->lists);
    k->nodes[node] = (kd_node){.first = (uint32_t)k->list_count,
                               .packed = KD_LEAF | (uint32_t)h->count << 2};
    for (int i = 0; i < h->count; i++)
        k->lists[k->list_count++] = (uint32_t)h->items[i].triangle;
    if (b->shown) progress_add(b->shown, (long)h->budget);
}

// ---- dividing --------------------------------------------------------------------------

// What of the item is in the child's cell. `side` says which of the two it is.
static aabb part_of(const kd_tree *k, bvh_item item, aabb cell, int axis, int side) {
    if (k->how.clip) return kd_clip(mesh_triangle(k->m, item.triangle), cell);
    aabb box = item.box;
    real *cut = side == KD_BELOW ? &box.max.x : &box.min.x;
    cut[axis] = along(side == KD_BELOW ? cell.max : cell.min, axis);
    return box;
}

static bool is_empty(aabb a) {
    return !(a.min.x <= a.max.x && a.min.y <= a.max.y && a.min.z <= a.max.z);
}

// The items of one child, in their order.
static heap child_of(const kd_tree *k, const heap *h, kd_plane p, aabb cell, int side) {
    heap c = {
        .items = grown(NULL, h->count, sizeof *c.items), .depth = h->depth + 1, .cell = cell};
    for (int i = 0; i < h->count; i++) {
        bvh_item item = h->items[i];
        const int sides = kd_sides(item.box, p.axis, p.split);
        if (!(sides & side)) continue;
        if (sides == (KD_BELOW | KD_ABOVE)) item.box = part_of(k, item, cell, p.axis, side);
        if (!is_empty(item.box)) c.items[c.count++] = item;
    }
    return c;
}

// The division costs 1, the rest of the budget is shared by count; no child gets less than its
// count, as long as the rest is enough for both.
static void share_budget(const heap *h, heap *below, heap *above) {
    const int64_t rest = h->budget - 1, both = (int64_t)below->count + above->count;
    below->budget = both ? rest * below->count / both : 0;
    above->budget = rest - below->budget;
}

// Two children that both hold everything are worse than one leaf. kd_cost knows that, so this
// happens only while one of the exercises is not written or wrong.
static bool is_gain(const heap *h, const heap *below, const heap *above) {
    return below->count < h->count || above->count < h->count;
}

static bool fits_budget(const heap *h) {
    return h->budget >= h->count;
}

// Divides the heap, which is freed; false: it stays, a leaf.
static bool divide(const builder *b, const heap *h, kd_plane *p, heap *below, heap *above) {
    if (h->depth >= b->depth_limit) return false;
    *p = kd_best_plane(h->items, h->count, h->cell, b->tree->how);
    if (p->axis < 0) return false;
    aabb cell_below = h->cell, cell_above = h->cell;
    (&cell_below.max.x)[p->axis] = (&cell_above.min.x)[p->axis] = p->split;
    *below = child_of(b->tree, h, *p, cell_below, KD_BELOW);
    *above = child_of(b->tree, h, *p, cell_above, KD_ABOVE);
    share_budget(h, below, above);
    if (is_gain(h, below, above) && fits_budget(below) && fits_budget(above)) return true;
    free(below->items);
    free(above->items);
    return false;
}

static void make_node(builder *b, heap h) {
    const uint32_t node = new_node(b);
    kd_plane p;
    heap below, above;
    const bool divided = divide(b, &h, &p, &below, &above);
    if (!divided) make_leaf(b, node, &h);
    free(h.items);
    if (!divided) return;
    make_node(b, below);
    b->tree->nodes[node] = (kd_node){
        .split = p.split, .packed = (uint32_t)p.axis | (uint32_t)b->tree->node_count << 2};
    make_node(b, above);
}

// ---- before and after --------------------------------------------------------------------

static heap all_of(kd_tree *k) {
    heap h = {.items = grown(NULL, k->m->count + 1, sizeof *h.items), .cell = aabb_empty};
    for (int i = 0; i < k->m->count; i++) {
        const triangle T = mesh_triangle(k->m, i);
        if (!is_finite(T.p1) || !is_finite(T.p2) || !is_finite(T.p3)) continue;
        const aabb box = aabb_of(T);
        h.items[h.count++] = (bvh_item){box, i};
        h.cell = aabb_join(h.cell, box);
    }
    h.budget = (int64_t)k->how.budget * h.count;
    return h;
}

kd_tree kd_build(const mesh *m, kd_options how) {
    kd_tree tree = {.m = m, .how = how};
    heap all = all_of(&tree);
    tree.count = all.count;
    tree.box = all.cell;
    if (!all.count) {
        free(all.items);
        return tree;
    }
    progress shown;
    const bool large = all.count > 300000;
    if (large) {
        shown = progress_start("building the tree", (long)all.budget, NULL);
        shown.unit = "shares of the budget";
    }
    builder b = {&tree, 64, 64, kd_depth_limit(all.count), large ? &shown : NULL};
    tree.nodes = grown(NULL, b.node_room, sizeof *tree.nodes);
    tree.lists = grown(NULL, b.list_room, sizeof *tree.lists);
    make_node(&b, all);
    tree.nodes = grown(tree.nodes, tree.node_count, sizeof *tree.nodes);
    tree.lists = grown(tree.lists, tree.list_count, sizeof *tree.lists);
    if (large) progress_end(&shown);
    return tree;
}

void kd_free(kd_tree *k) {
    free(k->nodes);
    free(k->lists);
    *k = (kd_tree){0};
}
