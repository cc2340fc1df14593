#include "chapters/12-bvh/leaf.h"

// A node that the ray meets at t, and that is looked into later.
typedef struct {
    int node;
    real t;
} waiting;

static inline bvh_found nearest(triangle_test test, const bvh *b, const slab_ray *s, real t_min,
                                real t_max, effort *spent) {
    bvh_found found = bvh_nothing_found(t_max);
    waiting stack[BVH_DEPTH], *top = stack;
    real t_left, t_right;
    for (const bvh_node *n = b->nodes;;) {
        if (n->count) {
            leaf_nearest_by(test, b, n, (ray){s->O, s->d}, t_min, &found, spent);
        } else {
            const bvh_node *left = &b->nodes[n->first], *right = left + 1;
            if (spent) spent->steps += 2;
            const bool in_left = aabb_hit(&left->box, s, t_min, found.limit, &t_left);
            const bool in_right = aabb_hit(&right->box, s, t_min, found.limit, &t_right);
            if (in_left) {
                if (in_right) {
                    if (t_left <= t_right) {
                        *top++ = (waiting){n->first + 1, t_right};
                        n = left;
                    } else {
                        *top++ = (waiting){n->first, t_left};
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
        do {
            if (top == stack) return found;
            top--;
        } while (top->t > found.limit);
        n = &b->nodes[top->node];
    }
}

triangle_point bvh_nearest(const bvh *b, ray r, real t_min, real t_max, int *index,
                           effort *spent) {
    const slab_ray s = slab_ray_of(r);
    if (!b->count) return (triangle_point){NO_HIT, 0, 0};
    const bvh_found found = b->test == TEST_PLAIN
                                ? nearest(TEST_PLAIN, b, &s, t_min, t_max, spent)
                                : nearest(TEST_WATERTIGHT, b, &s, t_min, t_max, spent);
    if (found.index >= 0) *index = found.index;
    return found.best;
}
