// kd_leaf.h: what a walk does in a leaf.
#ifndef CHAPTER_KD_LEAF_H
#define CHAPTER_KD_LEAF_H

#include "chapters/12-bvh/leaf.h"
#include "chapters/13-kd-tree/kd_tree.h"

// All triangles of a leaf: what is nearer than found->best takes its place.
static inline void kd_leaf_nearest(const kd_tree *k, kd_node leaf, ray r, real t_min,
                                   bvh_found *found, effort *spent) {
    const uint32_t *list = k->lists + leaf.first;
    const int count = (int)kd_number(leaf);
    if (spent) spent->tests += count;
    for (int i = 0; i < count; i++) {
        const int j = (int)list[i];
        const triangle_point q = triangle_hit(mesh_triangle(k->m, j), r, t_min, found->limit);
        if (q.t < found->best.t || (q.t == found->best.t && j < found->index))
            *found = (bvh_found){q, j, just_above(q.t)};
    }
}

// Is any triangle of a leaf hit?
static inline bool kd_leaf_any(const kd_tree *k, kd_node leaf, ray r, real t_min, real t_max,
                               effort *spent) {
    const uint32_t *list = k->lists + leaf.first;
    const int count = (int)kd_number(leaf);
    if (spent) spent->tests += count;
    for (int i = 0; i < count; i++)
        if (triangle_hit(mesh_triangle(k->m, (int)list[i]), r, t_min, t_max).t != NO_HIT)
            return true;
    return false;
}

#endif
