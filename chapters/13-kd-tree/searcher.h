// searcher.h: ways to find what a ray meets first, behind one interface, so that they can be
// compared on the same rays.
#ifndef CHAPTER_SEARCHER_H
#define CHAPTER_SEARCHER_H

#include "chapters/12-bvh/bvh.h"

// nearest and any keep the contracts of bvh_nearest and bvh_any: t_min < t < t_max, ties by the
// smaller index, one step in *spent for each box, plane or cell asked and one test for each
// triangle, spent may be NULL.
typedef struct {
    const char *name;
    void *(*build)(const mesh *m); // m must outlive it; never NULL: it dies without memory
    void (*free)(void *tree);
    triangle_point (*nearest)(const void *tree, ray r, real t_min, real t_max, int *index,
                              effort *spent);
    bool (*any)(const void *tree, ray r, real t_min, real t_max, effort *spent);
    size_t (*bytes)(const void *tree);     // besides the mesh
    const char *(*flaw)(const void *tree); // NULL, or which promise is not kept
} searcher;

// One triangle after the other; the BVH in its builds; this chapter's tree.
extern const searcher by_brute_force, by_bvh_median, by_bvh_midpoint, by_bvh_sah, by_kd_tree;

#endif
