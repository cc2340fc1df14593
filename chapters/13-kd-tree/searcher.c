// searcher.c: brute force, the BVH in three builds and the k-d tree as searchers.
#include "chapters/13-kd-tree/searcher.h"

#include <stdlib.h>

#include "chapters/13-kd-tree/kd_tree.h"

// ---- one triangle after the other ----------------------------------------------------------

// A mesh of its own, which asks no finder and no sphere around it.
static void *brute_build(const mesh *m) {
    mesh *own = mesh_room(1, sizeof *own);
    *own = *m;
    own->finder = NULL;
    own->around.r = 0;
    return own;
}

static triangle_point brute_nearest(const void *tree, ray r, real t_min, real t_max, int *index,
                                    effort *spent) {
    const mesh *m = tree;
    if (spent) spent->tests += m->count;
    return mesh_hit(m, r, t_min, t_max, index);
}

// Counts the tests up to the first hit.
static bool brute_any(const void *tree, ray r, real t_min, real t_max, effort *spent) {
    const mesh *m = tree;
    for (int i = 0; i < m->count; i++) {
        if (spent) spent->tests++;
        if (triangle_hit(mesh_triangle(m, i), r, t_min, t_max).t != NO_HIT) return true;
    }
    return false;
}

static size_t brute_bytes(const void *tree) {
    (void)tree;
    return 0;
}

static const char *brute_flaw(const void *tree) {
    (void)tree;
    return NULL;
}

const searcher by_brute_force = {"brute force", brute_build, free,      brute_nearest,
                                 brute_any,     brute_bytes, brute_flaw};

// ---- the BVH ---------------------------------------------------------------------------------

static void *bvh_of(const mesh *m, split_rule rule) {
    bvh *b = mesh_room(1, sizeof *b);
    bvh_options how = bvh_defaults;
    how.rule = rule;
    *b = bvh_build(m, how);
    return b;
}

static void *bvh_by_median(const mesh *m) {
    return bvh_of(m, SPLIT_MEDIAN);
}
static void *bvh_by_midpoint(const mesh *m) {
    return bvh_of(m, SPLIT_MIDPOINT);
}
static void *bvh_by_sah(const mesh *m) {
    return bvh_of(m, SPLIT_SAH);
}

static void bvh_away(void *tree) {
    bvh_free(tree);
    free(tree);
}

static triangle_point nearest_in_bvh(const void *tree, ray r, real t_min, real t_max,
                                     int *index, effort *spent) {
    return bvh_nearest(tree, r, t_min, t_max, index, spent);
}

static bool any_in_bvh(const void *tree, ray r, real t_min, real t_max, effort *spent) {
    return bvh_any(tree, r, t_min, t_max, spent);
}

static size_t bytes_of_bvh(const void *tree) {
    return bvh_measure(tree).bytes;
}

static const char *flaw_of_bvh(const void *tree) {
    return bvh_flaw(tree);
}

#define BY_BVH(name, build) \
    { name, build, bvh_away, nearest_in_bvh, any_in_bvh, bytes_of_bvh, flaw_of_bvh }
const searcher by_bvh_median = BY_BVH("BVH, median", bvh_by_median),
               by_bvh_midpoint = BY_BVH("BVH, midpoint", bvh_by_midpoint),
               by_bvh_sah = BY_BVH("BVH, SAH", bvh_by_sah);

// ---- the k-d tree ------------------------------------------------------------------------------

static void *kd_of(const mesh *m) {
    kd_tree *k = mesh_room(1, sizeof *k);
    *k = kd_build(m, kd_defaults);
    return k;
}

static void kd_away(void *tree) {
    kd_free(tree);
    free(tree);
}

static triangle_point nearest_in_kd(const void *tree, ray r, real t_min, real t_max, int *index,
                                    effort *spent) {
    return kd_nearest(tree, r, t_min, t_max, index, spent);
}

static bool any_in_kd(const void *tree, ray r, real t_min, real t_max, effort *spent) {
    return kd_any(tree, r, t_min, t_max, spent);
}

static size_t bytes_of_kd(const void *tree) {
    return kd_measure(tree).bytes;
}

static const char *flaw_of_kd(const void *tree) {
    return kd_flaw(tree);
}

const searcher by_kd_tree = {"k-d tree", kd_of,       kd_away,   nearest_in_kd,
                             any_in_kd,  bytes_of_kd, flaw_of_kd};
