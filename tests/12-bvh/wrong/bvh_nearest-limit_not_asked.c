// Wrong: the boxes are asked with t_max, not with the limit, which gets shorter.
// Expect: the limit is not asked: aabb_hit with t_max in place of found.limit
#include "chapters/12-bvh/leaf.h"

typedef struct {
    int node;
    real t;
} waiting;

triangle_point bvh_nearest(const bvh *b, ray r, real t_min, real t_max, int *index,
                           effort *spent) {
    const slab_ray s = slab_ray_of(r);
    bvh_found found = bvh_nothing_found(t_max);
    waiting stack[BVH_DEPTH];
    int top = 0;
    real t;
    const bvh_node *n = b->nodes;
    if (!b->count) return found.best;
    if (spent) spent->steps++;
    if (!aabb_hit(&n->box, &s, t_min, t_max, &t)) return found.best;
    for (;;) {
        if (n->count) {
            leaf_nearest(b, n, r, t_min, &found, spent);
        } else {
            const bvh_node *left = &b->nodes[n->first], *right = left + 1;
            real t_left, t_right;
            if (spent) spent->steps += 2;
            const bool in_left = aabb_hit(&left->box, &s, t_min, t_max, &t_left);
            const bool in_right = aabb_hit(&right->box, &s, t_min, t_max, &t_right);
            if (in_left && in_right) {
                if (t_left <= t_right) {
                    stack[top++] = (waiting){n->first + 1, t_right};
                    n = left;
                } else {
                    stack[top++] = (waiting){n->first, t_left};
                    n = right;
                }
                continue;
            }
            if (in_left || in_right) {
                n = in_left ? left : right;
                continue;
            }
        }
        do {
            if (top == 0) {
                if (found.best.t != NO_HIT) *index = found.index;
                return found.best;
            }
            top--;
        } while (stack[top].t > found.limit);
        n = &b->nodes[stack[top].node];
    }
}
