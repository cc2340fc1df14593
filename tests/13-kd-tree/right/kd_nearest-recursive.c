// Right: recursion; the machine's stack holds what waits.
#include "chapters/13-kd-tree/kd_leaf.h"

typedef struct {
    const kd_tree *k;
    ray r;
    kd_ray q;
    real t_min;
    bvh_found found;
    effort *spent;
} walk;

static void visit(walk *w, uint32_t node, span in) {
    const kd_node n = w->k->nodes[node];
    const uint32_t axis = kd_kind(n);
    if (in.t0 > in.t1 || in.t0 > w->found.limit) return;
    if (axis == KD_LEAF) {
        kd_leaf_nearest(w->k, n, w->r, w->t_min, &w->found, w->spent);
        return;
    }
    if (w->spent) w->spent->steps++;
    const kd_order o = kd_children(n.split, w->q.O[axis], w->q.inverse[axis], in);
    visit(w, o.first ? kd_number(n) : node + 1, o.near);
    visit(w, o.first ? node + 1 : kd_number(n), o.far);
}

triangle_point kd_nearest(const kd_tree *k, ray r, real t_min, real t_max, int *index,
                          effort *spent) {
    walk w = {k, r, kd_ray_of(r), t_min, bvh_nothing_found(t_max), spent};
    span in;
    if (spent) spent->steps++;
    if (!kd_enter(k, &w.q, t_min, t_max, &in)) return w.found.best;
    visit(&w, 0, in);
    if (w.found.best.t != NO_HIT) *index = w.found.index;
    return w.found.best;
}
