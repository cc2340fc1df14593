// draft.h: a mesh while it is being made. Its room is known beforehand; points are computed in
// double and rounded once, here.
#ifndef CHAPTER_DRAFT_H
#define CHAPTER_DRAFT_H

#include "chapters/05-triangle/triangle.h"
#include "common/wide3.h"

typedef struct {
    vec3 *points, *normals; // normals: NULL when the mesh is flat
    int (*corners)[3];
    int made, count; // points and triangles so far
} draft;

// Room for so many; dies when there is no memory or an int cannot count them.
draft draft_new(long points, long triangles, bool smooth);

// The index of the new point. A flat mesh does not look at the normal n.
static inline int draft_point(draft *d, wide3 p, wide3 n) {
    d->points[d->made] = narrow(p);
    if (d->normals) d->normals[d->made] = narrow(n);
    return d->made++;
}

static inline void draft_triangle(draft *d, int a, int b, int c) {
    int *k = d->corners[d->count++];
    k[0] = a, k[1] = b, k[2] = c;
}

// The square a, b, c, e, cut from a to c.
static inline void draft_square(draft *d, int a, int b, int c, int e) {
    draft_triangle(d, a, b, c);
    draft_triangle(d, a, c, e);
}

// k >= 1 whose square is nearest to n.
int draft_side(double n);

// A sphere of 20 k² triangles and 10 k² + 2 points, each face of the icosahedron cut in k².
// Its points u, of length 1, are moved to place(u, to); u is their normal.
typedef wide3 (*placing)(wide3 u, const void *to);
void draft_globe(draft *d, int k, placing place, const void *to);

// The same with the centre c and the radius r.
void draft_ball(draft *d, wide3 c, double r, int k);

// The tube of shape_knot, `size` times as large: a grid of around x across points and as many
// squares.
typedef struct {
    int around, across;
} knot_grid;
knot_grid knot_grid_of(long triangles);
void draft_knot(draft *d, knot_grid g, double size);

// The mesh, with the sphere around the origin that holds it.
mesh draft_done(draft d);

#endif
