// Wrong: the right child is only visited when the left one is missed.
// Expect: which one first, and when is the other still needed?
#include "chapters/12-bvh/leaf.h"

triangle_point bvh_nearest(const bvh *b, ray r, real t_min, real t_max, int *index,
                           effort *spent) {
    const slab_ray s = slab_ray_of(r);
    bvh_found found = bvh_nothing_found(t_max);
    const bvh_node *n = b->nodes;
    real t;
    if (!b->count) return found.best;
    while (!n->count) {
        if (spent) spent->steps++;
        n = &b->nodes[n->first];
        if (!aabb_hit(&n->box, &s, t_min, found.limit, &t)) n++;
    }
    leaf_nearest(b, n, r, t_min, &found, spent);
    if (found.best.t != NO_HIT) *index = found.index;
    return found.best;
}
