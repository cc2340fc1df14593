// Wrong: boxes only grow: they begin with the old ones.
// Expect: a box is not the smallest
#include "chapters/12-bvh/bvh.h"

void bvh_refit(bvh *b) {
    for (int i = 0; i < b->count; i++) b->triangles[i] = mesh_triangle(b->m, b->order[i]);
    for (int i = b->node_count - 1; i >= 0; i--) {
        if (i == 1) continue;
        bvh_node *n = &b->nodes[i];
        aabb box = n->box;
        for (int k = n->first; k < n->first + n->count; k++)
            box = aabb_join(box, aabb_of(b->triangles[k]));
        if (!n->count) box = aabb_join(b->nodes[n->first].box, b->nodes[n->first + 1].box);
        n->box = box;
    }
}
