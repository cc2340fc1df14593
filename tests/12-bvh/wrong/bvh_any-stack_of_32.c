// Wrong: only 32 nodes may wait, what comes then is dropped; the right child first.
// Expect: How many nodes may wait?
#include "chapters/12-bvh/leaf.h"

bool bvh_any(const bvh *b, ray r, real t_min, real t_max, effort *spent) {
    const slab_ray s = slab_ray_of(r);
    int stack[32], top = 0;
    real t;
    const bvh_node *n = b->nodes;
    if (!b->count) return false;
    if (spent) spent->steps++;
    if (!aabb_hit(&n->box, &s, t_min, t_max, &t)) return false;
    for (;;) {
        if (n->count) {
            if (leaf_any(b, n, r, t_min, t_max, spent)) return true;
        } else {
            const bvh_node *left = &b->nodes[n->first], *right = left + 1;
            if (spent) spent->steps += 2;
            const bool in_left = aabb_hit(&left->box, &s, t_min, t_max, &t);
            const bool in_right = aabb_hit(&right->box, &s, t_min, t_max, &t);
            if (in_left || in_right) {
                if (in_left && in_right && top < 32) stack[top++] = n->first;
                n = in_right ? right : left;
                continue;
            }
        }
        if (top == 0) return false;
        n = &b->nodes[stack[--top]];
    }
}
