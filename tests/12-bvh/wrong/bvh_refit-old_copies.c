// Wrong: the copies of the triangles stay where they were.
// Expect: Copies of the triangles first
#include "chapters/12-bvh/bvh.h"

void bvh_refit(bvh *b) {
    for (int i = b->node_count - 1; i >= 0; i--) {
        if (i == 1) continue;
        bvh_node *n = &b->nodes[i];
        aabb box = aabb_empty;
        for (int k = n->first; k < n->first + n->count; k++)
            box = aabb_join(box, aabb_of(mesh_triangle(b->m, b->order[k])));
        if (!n->count) box = aabb_join(b->nodes[n->first].box, b->nodes[n->first + 1].box);
        n->box = box;
    }
}
