#include "chapters/12-bvh/leaf.h"

// Nothing gets shorter here: the first hit is the answer. It is found sooner in the nearer box.
static inline bool any(triangle_test test, const bvh *b, const slab_ray *s, real t_min,
                       real t_max, effort *spent) {
    int stack[BVH_DEPTH], *top = stack;
    real t_left, t_right;
    for (const bvh_node *n = b->nodes;;) {
        if (n->count) {
            if (leaf_any_by(test, b, n, (ray){s->O, s->d}, t_min, t_max, spent)) return true;
        } else {
            const bvh_node *left = &b->nodes[n->first], *right = left + 1;
            if (spent) spent->steps += 2;
            const bool in_left = aabb_hit(&left->box, s, t_min, t_max, &t_left);
            const bool in_right = aabb_hit(&right->box, s, t_min, t_max, &t_right);
            if (in_left) {
                if (in_right) {
                    if (t_left <= t_right) {
                        *top++ = n->first + 1;
                        n = left;
                    } else {
                        *top++ = n->first;
                        n = right;
                    }
                } else {
                    n = left;
                }
                continue;
            }
            if (in_right) {
                n = right;
                continue;
            }
        }
        if (top == stack) return false;
        n = &b->nodes[*--top];
    }
}

bool bvh_any(const bvh *b, ray r, real t_min, real t_max, effort *spent) {
    const slab_ray s = slab_ray_of(r);
    if (!b->count) return false;
    if (b->test == TEST_PLAIN) return any(TEST_PLAIN, b, &s, t_min, t_max, spent);
    return any(TEST_WATERTIGHT, b, &s, t_min, t_max, spent);
}
