// octree.h: a cube divided into eight, and each of these again, where a mesh has triangles.
#ifndef CHAPTER_OCTREE_H
#define CHAPTER_OCTREE_H

#include "chapters/13-kd-tree/searcher.h"

// A cell's children are numbered by the half that they lie in: bit 0 says the upper half along x,
// bit 1 along y, bit 2 along z. Those with nothing in them are not stored. No box is stored
// either: the cube's and the way down give it.
typedef struct {
    int first; // its first child, and the others behind it in rising order; of a leaf: its
               // first triangle in `lists`
    int count; // triangles of a leaf; of a divided cell -mask, where bit i of the
               // mask says that child i is stored
} octree_node;

enum { OCTREE_DEPTH = 20 }; // no leaf is deeper; the root's depth is 0

// How a tree is built.
typedef struct {
    int leaf_size; // cells of so many triangles or fewer are not divided, 0 or more
    int depth;     // nor are cells at this depth, 0 to OCTREE_DEPTH
    int memory;    // nor any once there are this many nodes, or entries of lists, per triangle
    bool dense;    // all eight children are stored, also the empty ones
} octree_options;
extern const octree_options octree_defaults; // 4, OCTREE_DEPTH, 16, sparse

typedef struct {
    const mesh *m;
    octree_options how;
    aabb cube;          // the root's cell
    octree_node *nodes; // nodes[0] is the root
    int *lists;         // the leaves' triangles, one leaf after the other, each in rising order
    int node_count, entry_count; // node_count = 0: no triangles
} octree;

// Builds the tree level by level; the same mesh gives the same tree, bit for bit. m must outlive
// it. Triangles without area or with corners that are not finite are never hit and left out. Every
// other one is in the list of each leaf whose cell it meets. Free it with octree_free.
octree octree_build(const mesh *m, octree_options how);
void octree_free(octree *o);

// octree_nearest and octree_any as the finder of a mesh; o must outlive it.
finder octree_finder(const octree *o);

// The leaf in which p lies, or NULL where nothing is stored; *cell is the smallest cell
// around p and *depth its depth, also where that is empty. Outside of the cube NULL and -1.
const octree_node *octree_at(const octree *o, vec3 p, aabb *cell, int *depth);

// Is there any hit with t_min < t < t_max?
bool octree_any(const octree *o, ray r, real t_min, real t_max, effort *spent);

// What a tree is like.
typedef struct {
    int leaves, inner, depth, largest_leaf;
    int entries;  // of all lists: a triangle in three leaves counts as three
    size_t bytes; // nodes and lists
} octree_figures;
octree_figures octree_measure(const octree *o);

// Is everything true that a tree promises? NULL, or what is not, in words: children behind
// their parent and within the array, no empty leaf in a sparse tree, lists in rising order, no
// leaf too deep, and each triangle in every leaf whose cell holds one of its corners.
const char *octree_flaw(const octree *o);

extern const searcher by_octree;

// Exercises: exercises/14-octree/ ----------------------------------------------------

// In which child, 0 to 7, does p lie, when the cell is divided at `middle`? A point on the
// dividing plane is in the upper half.
int child_of(vec3 p, vec3 middle);

// Of the children that the mask names: how many stand before child i? The mask names i.
int child_index(unsigned mask, int i);

// Writes the eight children into `order` so that no ray in the direction d enters an earlier one
// after it has left a later one. Any such order will do. Components of d may be 0 or -0.
void order_children(vec3 d, int order[8]);

// Do the triangle and the cell, both closed, have a point in common? Never false when they do,
// also when they only touch. True when they do not only where the gap is less than a thousandth
// of their size. Finite corners.
bool cell_overlaps(triangle T, aabb cell);

// Should a cell at `depth` with `count` triangles be divided, when inside[i] of them meet child
// i? Not with how.leaf_size or fewer, not at how.depth or deeper, and only where it costs less than
// testing all: a ray through the cell asks all children with something in them, C_STEP each, and
// passes through each with probability 1/4, to be tested against what is inside, C_HIT each.
bool worth_dividing(octree_options how, int depth, int count, const int inside[8]);

// The nearest hit, as mesh_hit gives it: t_min < t < t_max, 0 <= t_min, of two equally near
// triangles the one with the smaller index; *index is untouched on a miss. Adds to *spent, if that is
// not NULL: one step for each cell asked. Looks into no cell that begins beyond the nearest
// hit so far. No larger stack than OCTREE_STACK.
enum { OCTREE_STACK = 7 * OCTREE_DEPTH + 1 };
triangle_point octree_nearest(const octree *o, ray r, real t_min, real t_max, int *index,
                              effort *spent);

#endif
