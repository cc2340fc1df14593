// kd_tree.c: the way into the tree, any hit, and what the tree is like.
#include "chapters/13-kd-tree/kd_leaf.h"

kd_ray kd_ray_of(ray r) {
    return (kd_ray){{r.O.x, r.O.y, r.O.z}, {1 / r.d.x, 1 / r.d.y, 1 / r.d.z}};
}

// The slab test of chapter 12, which asks besides where the ray leaves.
bool kd_enter(const kd_tree *k, const kd_ray *r, real t_min, real t_max, span *in) {
    *in = (span){t_min, t_max};
    if (!k->node_count) return false;
    for (int axis = 0; axis < 3; axis++) {
        const real low = along(k->box.min, axis) - r->O[axis],
                   high = along(k->box.max, axis) - r->O[axis];
        const bool down = signbit(r->inverse[axis]);
        in->t0 = greater((down ? high : low) * r->inverse[axis] * KD_EARLIER, in->t0);
        in->t1 = lesser((down ? low : high) * r->inverse[axis] * KD_LATER, in->t1);
    }
    return in->t0 <= in->t1;
}

typedef struct {
    uint32_t node;
    span in;
} waiting;

// Any hit will do, wherever it lies: nothing is compared, and the first one ends the walk.
bool kd_any(const kd_tree *k, ray r, real t_min, real t_max, effort *spent) {
    const kd_ray q = kd_ray_of(r);
    waiting stack[KD_DEPTH], now = {0, {0, 0}};
    int top = 0;
    if (spent) spent->steps++;
    if (!kd_enter(k, &q, t_min, t_max, &now.in)) return false;
    for (;;) {
        const kd_node n = k->nodes[now.node];
        const uint32_t axis = kd_kind(n);
        if (axis == KD_LEAF) {
            if (kd_leaf_any(k, n, r, t_min, t_max, spent)) return true;
            if (top == 0) return false;
            now = stack[--top];
            continue;
        }
        if (spent) spent->steps++;
        const kd_order o = kd_children(n.split, q.O[axis], q.inverse[axis], now.in);
        const uint32_t below = now.node + 1, above = kd_number(n);
        const waiting near = {o.first ? above : below, o.near},
                      far = {o.first ? below : above, o.far};
        const bool in_near = near.in.t0 <= near.in.t1, in_far = far.in.t0 <= far.in.t1;
        if (in_near && in_far) stack[top++] = far;
        now = in_near ? near : far;
    }
}

static triangle_point nearest(const void *tree, ray r, real t_min, real t_max, int *index) {
    return kd_nearest(tree, r, t_min, t_max, index, NULL);
}
static bool any(const void *tree, ray r, real t_min, real t_max) {
    return kd_any(tree, r, t_min, t_max, NULL);
}
finder kd_finder(const kd_tree *k) {
    return (finder){k, nearest, any};
}

// ---- figures ---------------------------------------------------------------------------

static void measure_from(const kd_tree *k, uint32_t node, aabb cell, int depth, kd_figures *f) {
    const kd_node n = k->nodes[node];
    const real whole = aabb_area(k->box);
    const double share = whole > 0 ? (double)aabb_area(cell) / (double)whole : 1;
    if (depth > f->depth) f->depth = depth;
    if (kd_kind(n) == KD_LEAF) {
        const int count = (int)kd_number(n);
        f->leaves++;
        f->empty += count == 0;
        if (count > f->largest_leaf) f->largest_leaf = count;
        f->cost += share * C_HIT * count;
        return;
    }
    f->cost += share * (double)k->how.step;
    measure_from(k, node + 1, kd_below(cell, n), depth + 1, f);
    measure_from(k, kd_number(n), kd_above(cell, n), depth + 1, f);
}

kd_figures kd_measure(const kd_tree *k) {
    kd_figures f = {0};
    f.bytes =
        (size_t)k->node_count * sizeof *k->nodes + (size_t)k->list_count * sizeof *k->lists;
    if (k->node_count) measure_from(k, 0, k->box, 0, &f);
    return f;
}
