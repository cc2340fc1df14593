// Wrong: near's span goes to the far child, and far's to the near one.
// Expect: near and far went to each other's child
// Expect: o.near belongs to the child that comes first
#include "chapters/13-kd-tree/kd_leaf.h"

// A child for later, and the part of the ray in it.
typedef struct {
    uint32_t node;
    span in;
} waiting;

// A hit may lie behind the cell in whose leaf it is found: a nearer one may wait in the cells
// between. So the nearest so far is kept, and the walk ends when what waits begins behind it.
triangle_point kd_nearest(const kd_tree *k, ray r, real t_min, real t_max, int *index,
                          effort *spent) {
    const kd_ray q = kd_ray_of(r);
    bvh_found found = bvh_nothing_found(t_max);
    waiting stack[KD_DEPTH], now = {0, {0, 0}};
    int top = 0;
    if (spent) spent->steps++;
    if (!kd_enter(k, &q, t_min, t_max, &now.in)) return found.best;
    for (;;) {
        const kd_node n = k->nodes[now.node];
        const uint32_t axis = kd_kind(n);
        if (axis == KD_LEAF) {
            kd_leaf_nearest(k, n, r, t_min, &found, spent);
            do {
                if (top == 0) {
                    if (found.best.t != NO_HIT) *index = found.index;
                    return found.best;
                }
                now = stack[--top];
            } while (now.in.t0 > found.limit);
            continue;
        }
        if (spent) spent->steps++;
        const kd_order o = kd_children(n.split, q.O[axis], q.inverse[axis], now.in);
        const uint32_t below = now.node + 1, above = kd_number(n);
        const waiting near = {o.first ? below : above, o.near},
                      far = {o.first ? above : below, o.far};
        const bool in_near = near.in.t0 <= near.in.t1, in_far = far.in.t0 <= far.in.t1;
        if (in_near && in_far) stack[top++] = far;
        now = in_near ? near : far;
    }
}
