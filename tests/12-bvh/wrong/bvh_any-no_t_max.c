// Wrong: t_max is forgotten.
// Expect: t_max ends the ray
#include "chapters/12-bvh/leaf.h"

bool bvh_any(const bvh *b, ray r, real t_min, real t_max, effort *spent) {
    const slab_ray s = slab_ray_of(r);
    int stack[BVH_DEPTH], top = 0;
    real t;
    const bvh_node *n = b->nodes;
    if (!b->count) return false;
    if (spent) spent->steps++;
    if (!aabb_hit(&n->box, &s, t_min, t_max, &t)) return false;
    for (;;) {
        if (n->count) {
            if (leaf_any(b, n, r, t_min, NO_HIT, spent)) return true;
        } else {
            const bvh_node *left = &b->nodes[n->first], *right = left + 1;
            if (spent) spent->steps += 2;
            const bool in_left = aabb_hit(&left->box, &s, t_min, t_max, &t);
            const bool in_right = aabb_hit(&right->box, &s, t_min, t_max, &t);
            if (in_left || in_right) {
                if (in_left && in_right) stack[top++] = n->first + 1;
                n = in_left ? left : right;
                continue;
            }
        }
        if (top == 0) return false;
        n = &b->nodes[stack[--top]];
    }
}
