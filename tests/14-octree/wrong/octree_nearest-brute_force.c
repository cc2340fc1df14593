// Wrong: brute force: no cell is asked.
// Expect: no cell was, and no triangle of a leaf
// Expect: Is it mesh_hit
#include "chapters/14-octree/cell.h"

triangle_point octree_nearest(const octree *o, ray r, real t_min, real t_max, int *index,
                              effort *spent) {
    (void)spent;
    return mesh_hit(o->m, r, t_min, t_max, index);
}
