// Right: calls itself in place of a stack.
#include "chapters/12-bvh/leaf.h"

static bool visit(const bvh *b, int node, const slab_ray *s, ray r, real t_min, real t_max,
                  effort *spent) {
    const bvh_node *n = &b->nodes[node];
    real t;
    if (spent) spent->steps++;
    if (!aabb_hit(&n->box, s, t_min, t_max, &t)) return false;
    if (n->count) return leaf_any(b, n, r, t_min, t_max, spent);
    return visit(b, n->first, s, r, t_min, t_max, spent) ||
           visit(b, n->first + 1, s, r, t_min, t_max, spent);
}

bool bvh_any(const bvh *b, ray r, real t_min, real t_max, effort *spent) {
    const slab_ray s = slab_ray_of(r);
    return b->count && visit(b, 0, &s, r, t_min, t_max, spent);
}
