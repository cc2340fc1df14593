// Right: the nearer child first.
#include "chapters/12-bvh/leaf.h"

bool bvh_any(const bvh *b, ray r, real t_min, real t_max, effort *spent) {
    const slab_ray s = slab_ray_of(r);
    int stack[BVH_DEPTH], top = 0;
    real t, u;
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
            const bool in_right = aabb_hit(&right->box, &s, t_min, t_max, &u);
            if (in_left || in_right) {
                const bool left_first = in_left && (!in_right || t <= u);
                if (in_left && in_right) stack[top++] = n->first + left_first;
                n = left_first ? left : right;
                continue;
            }
        }
        if (top == 0) return false;
        n = &b->nodes[stack[--top]];
    }
}
