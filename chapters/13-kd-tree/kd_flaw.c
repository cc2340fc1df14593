// kd_flaw.c: does a tree keep its promises?
#include <stdlib.h>

#include "chapters/13-kd-tree/kd_tree.h"
#include "common/wide3.h"

typedef struct {
    const kd_tree *k;
    long nodes, references;
    const char *flaw; // the first that was found
} inspection;

static void complain(inspection *x, bool is_so, const char *flaw) {
    if (is_so && !x->flaw) x->flaw = flaw;
}

static bool overlap(aabb a, aabb b) {
    return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y &&
           b.min.y <= a.max.y && a.min.z <= b.max.z && b.min.z <= a.max.z;
}

static void inspect_leaf(inspection *x, kd_node n, aabb cell) {
    const kd_tree *k = x->k;
    const long first = n.first, count = kd_number(n);
    complain(x, first + count > k->list_count, "a leaf's list lies outside the array");
    for (long i = first; i < first + count && !x->flaw; i++) {
        const long j = k->lists[i];
        complain(x, j >= k->m->count, "a list names a triangle that does not exist");
        complain(x, i > first && k->lists[i - 1] >= j, "a list does not ascend");
        if (!x->flaw)
            complain(x, !overlap(aabb_of(mesh_triangle(k->m, (int)j)), cell),
                     "a leaf lists a triangle that is not near its cell");
    }
    x->references += count;
}

static void inspect(inspection *x, uint32_t node, aabb cell, int depth) {
    const kd_tree *k = x->k;
    const kd_node n = k->nodes[node];
    x->nodes++;
    complain(x, depth > kd_depth_limit(k->count) || depth > KD_DEPTH, "a leaf is too deep");
    if (kd_kind(n) == KD_LEAF) {
        inspect_leaf(x, n, cell);
        return;
    }
    const int axis = (int)kd_kind(n);
    complain(x, !(n.split > along(cell.min, axis) && n.split < along(cell.max, axis)),
             "a plane does not cut its cell");
    complain(x, kd_number(n) <= node + 1 || kd_number(n) >= k->node_count,
             "an inner node's children are not later nodes");
    if (x->flaw) return;
    inspect(x, node + 1, kd_below(cell, n), depth + 1);
    inspect(x, kd_number(n), kd_above(cell, n), depth + 1);
}

// ---- is every triangle wherever it lies? -------------------------------------------------

static bool lists(const kd_tree *k, kd_node leaf, uint32_t j) {
    for (uint32_t i = 0; i < kd_number(leaf); i++)
        if (k->lists[leaf.first + i] == j) return true;
    return false;
}

// Is the triangle in the leaf in which its point p lies? On a plane, or by `slack` beside it,
// one of the two sides is enough.
static bool found_at(const kd_tree *k, uint32_t node, const double p[3], double slack,
                     uint32_t j) {
    const kd_node n = k->nodes[node];
    if (kd_kind(n) == KD_LEAF) return lists(k, n, j);
    const double above = p[kd_kind(n)] - (double)n.split;
    return (above <= slack && found_at(k, node + 1, p, slack, j)) ||
           (above >= -slack && found_at(k, kd_number(n), p, slack, j));
}

// Corners, the middles of edges, and points inside.
static void look_for(inspection *x, int j) {
    static const double weights[][3] = {{1, 0, 0},       {0, 1, 0},       {0, 0, 1},
                                        {0, 0.5, 0.5},   {0.5, 0, 0.5},   {0.5, 0.5, 0},
                                        {0.3, 0.3, 0.4}, {0.7, 0.2, 0.1}, {0.1, 0.6, 0.3}};
    const struct triangle_in_double {
        wide3 a, b, c;
    } T = {widen(mesh_triangle(x->k->m, j).p1), widen(mesh_triangle(x->k->m, j).p2),
           widen(mesh_triangle(x->k->m, j).p3)};
    const double size = fabs(T.a.x) + fabs(T.a.y) + fabs(T.a.z) + fabs(T.b.x) + fabs(T.b.y) +
                        fabs(T.b.z) + fabs(T.c.x) + fabs(T.c.y) + fabs(T.c.z);
    for (int i = 0; i < COUNT(weights) && !x->flaw; i++) {
        const double *w = weights[i];
        const double p[3] = {w[0] * T.a.x + w[1] * T.b.x + w[2] * T.c.x,
                             w[0] * T.a.y + w[1] * T.b.y + w[2] * T.c.y,
                             w[0] * T.a.z + w[1] * T.b.z + w[2] * T.c.z};
        complain(x, !found_at(x->k, 0, p, 4 * DBL_EPSILON * size, (uint32_t)j),
                 "a triangle is missing in the leaf where a point of it lies");
    }
}

const char *kd_flaw(const kd_tree *k) {
    if (!k->node_count) return k->count ? "there are triangles and no nodes" : NULL;
    inspection x = {.k = k};
    inspect(&x, 0, k->box, 0);
    complain(&x, x.nodes != k->node_count, "a node is not reached, or twice");
    complain(&x, x.references != k->list_count, "a reference belongs to no leaf, or to two");
    complain(&x, x.references + x.nodes / 2 > (long)k->how.budget * k->count,
             "there are more divisions and references than the budget allows");
    for (int i = 0; i < k->m->count && !x.flaw; i++) {
        const triangle T = mesh_triangle(k->m, i);
        if (is_finite(T.p1) && is_finite(T.p2) && is_finite(T.p3)) look_for(&x, i);
    }
    return x.flaw;
}
