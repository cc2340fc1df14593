// Wrong: the left child comes first, whatever the ray: right hits, more work.
// Expect: the left child comes first, whatever the ray
#include "chapters/12-bvh/leaf.h"

triangle_point bvh_nearest(const bvh *b, ray r, real t_min, real t_max, int *index,
                           effort *spent) {
    const slab_ray s = slab_ray_of(r);
    bvh_found found = bvh_nothing_found(t_max);
    int stack[BVH_DEPTH + 1], top = 0;
    if (b->count) stack[top++] = 0;
    while (top > 0) {
        const bvh_node *n = &b->nodes[stack[--top]];
        real t;
        if (spent) spent->steps++;
        if (!aabb_hit(&n->box, &s, t_min, found.limit, &t)) continue;
        if (n->count) {
            leaf_nearest(b, n, r, t_min, &found, spent);
            continue;
        }
        stack[top++] = n->first + 1;
        stack[top++] = n->first;
    }
    if (found.best.t != NO_HIT) *index = found.index;
    return found.best;
}
