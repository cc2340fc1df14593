// Right: from the root down, boxes on the way back.
#include "chapters/12-bvh/bvh.h"

static aabb fitted(bvh *b, int node) {
    bvh_node *n = &b->nodes[node];
    aabb box = aabb_empty;
    for (int i = n->first; i < n->first + n->count; i++) {
        b->triangles[i] = mesh_triangle(b->m, b->order[i]);
        box = aabb_join(box, aabb_of(b->triangles[i]));
    }
    if (n->count == 0) box = aabb_join(fitted(b, n->first), fitted(b, n->first + 1));
    n->box = box;
    return box;
}

void bvh_refit(bvh *b) {
    if (b->count > 0) fitted(b, 0);
}
