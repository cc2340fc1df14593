// bvh.h: a tree of boxes over the triangles of a mesh.
#ifndef CHAPTER_BVH_H
#define CHAPTER_BVH_H

#include "chapters/12-bvh/aabb.h"

// What a search has spent.
typedef struct {
    long steps; // boxes, planes or cells asked
    long tests; // triangles asked
} effort;

// A node is 32 bytes in float. The two children of an inner node stand side by side, in one line
// of the cache; the left one holds the smaller centroids. Depth first: a left child's
// children come next.
typedef struct {
    aabb box;
    int first; // of an inner node: its left child; of a leaf: its first triangle
    int count; // of triangles; 0: an inner node
} bvh_node;

// How the triangles of a leaf are tested.
typedef enum {
    TEST_WATERTIGHT, // triangle_hit: double inside, no ray slips through
    TEST_PLAIN,      // Möller and Trumbore in real arithmetic: faster, and it leaks
} triangle_test;

enum { BVH_DEPTH = 60 }; // no leaf is deeper; the root's depth is 0

typedef struct {
    const mesh *m;
    bvh_node *nodes; // nodes[0] is the root; nodes[1] is unused, so that siblings are aligned
    int node_count;  // nodes[1] included; 0: no triangles
    triangle *triangles; // in the order of the leaves
    int *order;          // triangles[i] is the mesh's triangle order[i]
    int count;
    triangle_test test;
} bvh;

// Where a node is divided.
typedef enum {
    SPLIT_MEDIAN,   // "sort by centroid": half of the triangles on each side
    SPLIT_MIDPOINT, // "halve the volume": the middle of the centroids' box
    SPLIT_SAH,   // the cheapest of some planes along each axis, by the surface area heuristic
    SPLIT_SWEEP, // the cheapest of all planes between two triangles: slower to build
} split_rule;

// How a tree is built.
typedef struct {
    split_rule rule;
    int leaf_size; // triangles in a leaf at most, 1 or more; by the SAH's rules fewer where that
                   // is cheaper
    int bins;      // SPLIT_SAH: of these at most, 2 to BVH_BINS
    triangle_test test;
} bvh_options;
enum { BVH_BINS = 32 };
extern const bvh_options bvh_defaults; // SAH, leaves of at most 4, 16 bins, watertight

// Builds the tree; the same mesh gives the same tree, bit for bit. m must outlive it. Triangles
// with corners that are not finite are never hit and left out. Reports progress on meshes of
// more than a million triangles. Free it with bvh_free.
bvh bvh_build(const mesh *m, bvh_options how);
void bvh_free(bvh *b);

// bvh_nearest and bvh_any as the finder of a mesh; b must outlive it.
finder bvh_finder(const bvh *b);

// What a tree is like.
typedef struct {
    int leaves, depth, largest_leaf;
    size_t bytes; // nodes, triangles and order
    double cost;  // expected steps and tests of a random line that meets the root box:
                  // the sum over nodes of area / root's area, times count in a leaf
} bvh_figures;
bvh_figures bvh_measure(const bvh *b);

// Is everything true that a tree promises? NULL, or what is not, in words: every finite triangle
// of the mesh in exactly one leaf, copied as it is; boxes that hold their contents and are tight;
// two children to every inner node, in pairs, depth first, none unused; no leaf deeper than
// BVH_DEPTH. Of any contents of the arrays; only the counts must be those of the arrays.
const char *bvh_flaw(const bvh *b);

// ---- building ----------------------------------------------------------------------

// A triangle while the tree is built.
typedef struct {
    aabb box;
    int triangle;
} bvh_item;

// Exercises: exercises/12-bvh/ -----------------------------------------------------

// Orders items[0 … count - 1] so that no centre of the first count / 2 lies above one of the rest
// along the axis. Sorting is one way; it must not be quadratic. count >= 2.
void split_median(bvh_item *items, int count, int axis);

// Orders the items so that those whose centre lies below `middle` along the axis come first,
// and returns how many they are, 0 to count.
int split_at(bvh_item *items, int count, int axis, real middle);

// The expected cost of a node with the box `box` whose n_l and n_r triangles go into the boxes
// l and r: C_step + C_hit (n_l A_l + n_r A_r) / A. The slide's c, in units in which
// it can be compared with n C_hit, a leaf's. A > 0; without area any number, or NaN.
enum { C_STEP = 1, C_HIT = 1 }; // a pair of boxes asked; a triangle asked
real sah_cost(aabb box, int n_l, aabb l, int n_r, aabb r);

// The nearest hit, as mesh_hit gives it: t_min < t < t_max, 0 <= t_min, of two equally near
// triangles the one with the smaller index; *index is untouched on a miss. Adds to *spent, if that is
// not NULL: one step for each box asked. No deeper stack than BVH_DEPTH.
triangle_point bvh_nearest(const bvh *b, ray r, real t_min, real t_max, int *index,
                           effort *spent);

// Is there any hit with t_min < t < t_max?
bool bvh_any(const bvh *b, ray r, real t_min, real t_max, effort *spent);

// New boxes for the same tree after the mesh's points have moved. The mesh has the same
// triangles, and those in the tree are still finite; b's copies of them are renewed too.
void bvh_refit(bvh *b);

#endif
