// leaf.h: what a walk through the tree does when it comes to a leaf.
#ifndef CHAPTER_LEAF_H
#define CHAPTER_LEAF_H

#include "chapters/12-bvh/bvh.h"

// What a walk knows so far.
typedef struct {
    triangle_point best; // t = NO_HIT: nothing yet
    int index;           // of the nearest triangle, in the mesh; -1: none
    real limit; // what begins beyond cannot be nearer; just above best.t, since of two equally
                // near triangles the one with the smaller index is wanted
} bvh_found;

static inline bvh_found bvh_nothing_found(real t_max) {
    return (bvh_found){{NO_HIT, 0, 0}, -1, t_max};
}

// Möller and Trumbore 1997 in real arithmetic, divided last. Leaks between triangles.
static inline triangle_point plain_hit(const triangle *T, ray r, real t_min, real t_max) {
    const triangle_point miss = {NO_HIT, 0, 0};
    const vec3 a = sub(T->p2, T->p1), b = sub(T->p3, T->p1), s = sub(r.O, T->p1);
    const vec3 P = cross(r.d, b), Q = cross(s, a);
    const real det = dot(a, P), sign = copysign(1, det), D = fabs(det);
    const real u = sign * dot(s, P), v = sign * dot(r.d, Q);
    if (!((u >= 0) & (v >= 0) & (u + v <= D))) return miss; // & asks once, && three times
    const real inverse = 1 / D, t = sign * dot(b, Q) * inverse;
    if (!(t > t_min && t < t_max)) return miss;
    return (triangle_point){t, u * inverse, v * inverse};
}

static inline triangle_point leaf_test(const triangle *T, triangle_test test, ray r, real t_min,
                                       real t_max) {
    if (test == TEST_PLAIN) return plain_hit(T, r, t_min, t_max);
    return triangle_hit(*T, r, t_min, t_max);
}

// A little more than t: what is as near as t lies before it. In float a step or two would do; in
// double the t of two triangles at one edge differ by some roundings of their own.
static inline real just_above(real t) {
    return t * (1 + rounding_bound(16)) + REAL_MIN * REAL_EPSILON;
}

// All triangles of a leaf: what is nearer than found->best takes its place. With the test named
// where it is called, a walk can be compiled for just that test.
static inline void leaf_nearest_by(triangle_test test, const bvh *b, const bvh_node *leaf,
                                   ray r, real t_min, bvh_found *found, effort *spent) {
    if (spent) spent->tests += leaf->count;
    for (int i = leaf->first; i < leaf->first + leaf->count; i++) {
        const triangle_point q = leaf_test(&b->triangles[i], test, r, t_min, found->limit);
        if (q.t < found->best.t || (q.t == found->best.t && b->order[i] < found->index))
            *found = (bvh_found){q, b->order[i], just_above(q.t)};
    }
}

static inline void leaf_nearest(const bvh *b, const bvh_node *leaf, ray r, real t_min,
                                bvh_found *found, effort *spent) {
    leaf_nearest_by(b->test, b, leaf, r, t_min, found, spent);
}

// Is any triangle of a leaf hit?
static inline bool leaf_any_by(triangle_test test, const bvh *b, const bvh_node *leaf, ray r,
                               real t_min, real t_max, effort *spent) {
    if (spent) spent->tests += leaf->count;
    for (int i = leaf->first; i < leaf->first + leaf->count; i++)
        if (leaf_test(&b->triangles[i], test, r, t_min, t_max).t != NO_HIT) return true;
    return false;
}

static inline bool leaf_any(const bvh *b, const bvh_node *leaf, ray r, real t_min, real t_max,
                            effort *spent) {
    return leaf_any_by(b->test, b, leaf, r, t_min, t_max, spent);
}

#endif
