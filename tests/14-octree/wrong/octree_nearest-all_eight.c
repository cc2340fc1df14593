// Wrong: children that are not stored are asked, too.
// Expect: looks like also children that are not stored are asked
#include "chapters/14-octree/cell.h"

// A cell that the ray enters at t, and that is looked into later.
typedef struct {
    int node;
    real t;
    aabb cell;
} waiting;

// The last one pushed is looked into first: so the furthest child goes first.
triangle_point octree_nearest(const octree *o, ray r, real t_min, real t_max, int *index,
                              effort *spent) {
    const slab_ray s = slab_ray_of(r);
    find f = {{NO_HIT, 0, 0}, 0, t_max};
    waiting stack[OCTREE_STACK];
    int order[8], top = 1;
    if (!o->node_count) return f.best;
    order_children(r.d, order);
    stack[0] = (waiting){0, t_min, o->cube};
    if (spent) spent->steps++;
    if (!aabb_hit(&o->cube, &s, t_min, t_max, &stack[0].t)) return f.best;
    while (top > 0) {
        const waiting w = stack[--top];
        const octree_node *n = &o->nodes[w.node];
        if (w.t > find_limit(&f)) continue;
        if (is_leaf(n)) {
            leaf_triangles(o, n, r, t_min, &f, spent);
            continue;
        }
        const unsigned mask = stored_children(n);
        for (int k = 7; k >= 0; k--) {
            waiting next = {n->first + child_index(mask, order[k]), 0,
                            cell_child(w.cell, order[k])};
            if (spent) spent->steps++;
            if (aabb_hit(&next.cell, &s, t_min, find_limit(&f), &next.t)) stack[top++] = next;
        }
    }
    if (f.best.t != NO_HIT) *index = f.index;
    return f.best;
}
