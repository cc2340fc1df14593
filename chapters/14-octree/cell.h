// cell.h: what building and walking know about cells.
#ifndef CHAPTER_CELL_H
#define CHAPTER_CELL_H

#include "chapters/14-octree/octree.h"

// The same expression for building and walking: both see the same planes, rounded alike.
// Halved first, so that nothing overflows.
static inline real halfway(real low, real high) {
    return low / 2 + high / 2;
}

static inline vec3 cell_middle(aabb cell) {
    return (vec3){halfway(cell.min.x, cell.max.x), halfway(cell.min.y, cell.max.y),
                  halfway(cell.min.z, cell.max.z)};
}

// The cell of child i.
static inline aabb cell_child(aabb cell, int i) {
    const vec3 m = cell_middle(cell);
    return (aabb){
        {i & 1 ? m.x : cell.min.x, i & 2 ? m.y : cell.min.y, i & 4 ? m.z : cell.min.z},
        {i & 1 ? cell.max.x : m.x, i & 2 ? cell.max.y : m.y, i & 4 ? cell.max.z : m.z}};
}

static inline bool is_leaf(const octree_node *n) {
    return n->count >= 0;
}
// Of a divided cell: which children are stored.
static inline unsigned stored_children(const octree_node *n) {
    return (unsigned)-n->count;
}
static inline bool is_stored(unsigned mask, int i) {
    return mask >> i & 1;
}

// What a walk has found so far; t = NO_HIT: nothing.
typedef struct {
    triangle_point best;
    int index; // of the nearest triangle
    real t_max;
} find;

// A cell entered beyond this holds nothing as near: three roundings stand behind where aabb_hit says
// that a cell begins, one behind t in float and in double about ten. Equally near counts.
static inline real find_limit(const find *f) {
    return f->t_max * (1 + rounding_bound(16));
}

// All triangles of a leaf: what is nearer, or as near with a smaller index, takes the place of
// what was found before. One that stands in several leaves may be tested again: it changes nothing.
static inline void leaf_triangles(const octree *o, const octree_node *leaf, ray r, real t_min,
                                  find *f, effort *spent) {
    if (spent) spent->tests += leaf->count;
    for (int k = leaf->first; k < leaf->first + leaf->count; k++) {
        const int i = o->lists[k];
        const triangle_point q = triangle_hit(mesh_triangle(o->m, i), r, t_min, find_limit(f));
        if (q.t == NO_HIT || q.t > f->t_max) continue;
        if (q.t == f->t_max && (f->best.t == NO_HIT || i >= f->index)) continue;
        *f = (find){q, i, q.t};
    }
}

#endif
