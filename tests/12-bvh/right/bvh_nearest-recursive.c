// Right: calls itself in place of a stack; the side of d says which child comes first.
#include "chapters/12-bvh/leaf.h"

typedef struct {
    const bvh *b;
    ray r;
    slab_ray s;
    real t_min;
    effort *spent;
} walk;

static int nearer(const walk *w, const bvh_node *left) {
    const vec3 a = aabb_centre(left->box), c = aabb_centre(left[1].box), e = sub(c, a);
    const vec3 size = absolute(e);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    return (along(e, axis) < 0) != (along(w->r.d, axis) < 0);
}

static void visit(const walk *w, int node, bvh_found *found) {
    const bvh_node *n = &w->b->nodes[node];
    real t;
    if (w->spent) w->spent->steps++;
    if (!aabb_hit(&n->box, &w->s, w->t_min, found->limit, &t)) return;
    if (n->count) {
        leaf_nearest(w->b, n, w->r, w->t_min, found, w->spent);
        return;
    }
    const int first = nearer(w, &w->b->nodes[n->first]);
    visit(w, n->first + first, found);
    visit(w, n->first + 1 - first, found);
}

triangle_point bvh_nearest(const bvh *b, ray r, real t_min, real t_max, int *index,
                           effort *spent) {
    const walk w = {b, r, slab_ray_of(r), t_min, spent};
    bvh_found found = bvh_nothing_found(t_max);
    if (b->count) visit(&w, 0, &found);
    if (found.best.t != NO_HIT) *index = found.index;
    return found.best;
}
