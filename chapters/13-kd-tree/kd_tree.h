// kd_tree.h: space divided by planes across the axes, and the triangles of a mesh in its cells.
#ifndef CHAPTER_KD_TREE_H
#define CHAPTER_KD_TREE_H

#include "chapters/12-bvh/bvh.h"

// The t from t0 to t1, both included; empty when t0 > t1.
typedef struct {
    real t0, t1;
} span;

// 8 bytes in float. No node stores its cell: it follows from the planes above. Depth first:
// the child below a plane, where the coordinate is smaller, is the next node.
typedef struct {
    union {
        real split;     // of an inner node: where it divides its cell
        uint32_t first; // of a leaf: its first triangle in kd_tree.lists
    };
    // Two bits: the plane's axis, or KD_LEAF. Above them: the number of the child above the
    // plane, or how many triangles there are.
    uint32_t packed;
} kd_node;
enum { KD_LEAF = 3 };

static inline uint32_t kd_kind(kd_node n) {
    return n.packed & 3;
}
static inline uint32_t kd_number(kd_node n) {
    return n.packed >> 2;
}

// The cells of an inner node's children, from its own.
static inline aabb kd_below(aabb cell, kd_node n) {
    (&cell.max.x)[kd_kind(n)] = n.split;
    return cell;
}
static inline aabb kd_above(aabb cell, kd_node n) {
    (&cell.min.x)[kd_kind(n)] = n.split;
    return cell;
}

enum { KD_DEPTH = 48 }; // no leaf is deeper, whatever the mesh; the root's depth is 0

// How a tree is built.
typedef struct {
    real step;  // the cost of one plane, in triangle tests
    real bonus; // 0 to 1: how much cheaper a division seems that cuts off empty space
    int budget; // divisions and references (triangles listed in leaves) together, for each triangle
    bool clip; // bounds of what is inside the cell; else the box cut at the plane
} kd_options;
extern const kd_options kd_defaults;

typedef struct {
    const mesh *m;
    aabb box; // the root's cell: holds all triangles
    kd_node *nodes;
    uint32_t *lists;             // numbers of the mesh's triangles, of one leaf after the other
    long node_count, list_count; // node_count 0: no triangles
    int count;                   // triangles in the tree
    kd_options how;
} kd_tree;

// Builds the tree; the same mesh gives the same tree, bit for bit. m must outlive it. Triangles
// with corners that are not finite are never hit and left out. No leaf is deeper than
// kd_depth_limit, divisions and references together are at most how.budget for each triangle.
// Reports progress on meshes of more than 300,000 triangles. Free it with kd_free.
kd_tree kd_build(const mesh *m, kd_options how);
void kd_free(kd_tree *k);

// 8 + 1.3 log2 count, at most KD_DEPTH. Source: Wald and Havran 2006; PBRT 3rd ed., section
// 4.4.
int kd_depth_limit(int count);

// Is there any hit with t_min < t < t_max, 0 <= t_min? Adds to *spent, if that is not NULL: one
// step for the root's box and for each plane asked, one test for each triangle.
bool kd_any(const kd_tree *k, ray r, real t_min, real t_max, effort *spent);

// kd_nearest and kd_any as the finder of a mesh; k must outlive it.
finder kd_finder(const kd_tree *k);

// What a tree is like.
typedef struct {
    long leaves, empty; // leaves, and those without triangles
    int depth, largest_leaf;
    size_t bytes; // nodes and lists
    double cost;  // expected planes and tests of a random line through the root's box
} kd_figures;
kd_figures kd_measure(const kd_tree *k);

// Is everything true that a tree promises? NULL, or what is not, in words: each node is
// reached once, planes cut their cells, lists are in the array, ascend and name triangles that
// come near the leaf's cell, each triangle is listed wherever points of it lie, depth and
// budget are kept.
const char *kd_flaw(const kd_tree *k);

// ---- for the walk --------------------------------------------------------------------

// A ray by its axes.
typedef struct {
    real O[3];
    real inverse[3]; // 1 / d; infinite where d is 0, with its sign
} kd_ray;
kd_ray kd_ray_of(ray r);

// Each t of a plane carries three roundings: of 1 / d, the difference, the product. A span
// reaches further by twice that (as Ize 2013 does for boxes).
#define KD_LATER (1 + 2 * rounding_bound(3))
#define KD_EARLIER (1 - 2 * rounding_bound(3))

// The part of the ray in the root's cell, t_min to t_max, in *in; false when there is none.
bool kd_enter(const kd_tree *k, const kd_ray *r, real t_min, real t_max, span *in);

// Exercises: exercises/13-kd-tree/ ------------------------------------------------------

// Which children hold a primitive with this box: 1 below, 2 above, 3 both. What only touches
// the plane from one side is on that side; what is flat and lies in the plane is below.
enum { KD_BELOW = 1, KD_ABOVE = 2 };
int kd_sides(aabb box, int axis, real split);

// The two children of a node, in the order in which the ray comes to them.
typedef struct {
    int first;      // 0: the one below the plane comes first, 1: the one above
    span near, far; // the part of the ray in the first and in the other; empty: not visited
} kd_order;

// A ray that is in a cell for the t of `in`, 0 <= in.t0 <= in.t1, and the cell's children,
// which are closed: x <= split and x >= split. O and d are the components along the axis;
// inverse = 1 / d, ±infinity for d = ±0. A ray along the plane and in it is in both children;
// one that begins in the plane is in both at t = 0. near begins at in.t0, far ends at in.t1;
// their other ends are never cut short, may reach further by a few roundings (KD_EARLIER,
// KD_LATER), and by no more beyond `in`. Either order for a ray that is in only one of them, or
// in both at the same t.
kd_order kd_children(real split, real O, real inverse, span in);

// The expected cost of dividing a cell at the plane, with so many primitives below and above:
// how.step + C_HIT (n_b A_b + n_a A_a) / A, in which the hits' part is multiplied by 1 -
// how.bonus when a child is empty. A, A_b, A_a: areas of the cell and its children. A > 0. C_HIT
// is chapter 12's (bvh.h); C_STEP, there, is a pair of boxes and not how.step.
real kd_cost(aabb cell, int axis, real split, int n_below, int n_above, kd_options how);

// The bounds of the part of T in the cell, which they never leave: at least as large as exact
// ones, larger by a few roundings of T's coordinates at most. Empty when no part is.
// Sutherland and Hodgman 1974, double inside, rounded outwards.
aabb kd_clip(triangle T, aabb cell);

// The nearest hit, as mesh_hit gives it: t_min < t < t_max, 0 <= t_min, of two equally near
// triangles the one with the smaller index; *index is untouched on a miss. Effort as kd_any.
triangle_point kd_nearest(const kd_tree *k, ray r, real t_min, real t_max, int *index,
                          effort *spent);

#endif
