// Wrong: asks no box, but every leaf.
// Expect: a box that is missed is not looked into
#include "chapters/12-bvh/leaf.h"

triangle_point bvh_nearest(const bvh *b, ray r, real t_min, real t_max, int *index,
                           effort *spent) {
    bvh_found found = bvh_nothing_found(t_max);
    for (int i = 0; i < b->node_count; i++) {
        if (spent && i != 1) spent->steps++;
        if (i != 1 && b->nodes[i].count) leaf_nearest(b, &b->nodes[i], r, t_min, &found, spent);
    }
    if (found.best.t != NO_HIT) *index = found.index;
    return found.best;
}
