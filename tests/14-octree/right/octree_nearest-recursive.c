// Right: recursion in place of a stack.
#include "chapters/14-octree/cell.h"

typedef struct {
    const octree *o;
    slab_ray s;
    ray r;
    real t_min;
    effort *spent;
    int order[8];
    find f;
} walk;

static void visit(walk *w, const octree_node *n, aabb cell) {
    real t;
    if (w->spent) w->spent->steps++;
    if (!aabb_hit(&cell, &w->s, w->t_min, find_limit(&w->f), &t)) return;
    if (is_leaf(n)) {
        leaf_triangles(w->o, n, w->r, w->t_min, &w->f, w->spent);
        return;
    }
    const unsigned mask = stored_children(n);
    for (int k = 0; k < 8; k++)
        if (is_stored(mask, w->order[k]))
            visit(w, &w->o->nodes[n->first + child_index(mask, w->order[k])],
                  cell_child(cell, w->order[k]));
}

triangle_point octree_nearest(const octree *o, ray r, real t_min, real t_max, int *index,
                              effort *spent) {
    walk w = {o, slab_ray_of(r), r, t_min, spent, {0}, {{NO_HIT, 0, 0}, 0, t_max}};
    order_children(r.d, w.order);
    if (o->node_count) visit(&w, o->nodes, o->cube);
    if (w.f.best.t != NO_HIT) *index = w.f.index;
    return w.f.best;
}
