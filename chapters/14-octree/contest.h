// contest.h: all searchers on the same rays.
#ifndef CHAPTER_CONTEST_H
#define CHAPTER_CONTEST_H

#include "chapters/12-bvh/shapes.h"
#include "chapters/14-octree/octree.h"

enum { CONTESTANTS = 6 };
extern const searcher *const contestants[CONTESTANTS]; // brute force is the last

typedef struct {
    ray *rays;
    int count;
} ray_list;

// Rays of a camera that sees the shape, through the centres of side x side pixels: neighbours are alike.
// Free the list with free(rays).
ray_list primary_rays(const shape *s, int side);

// Where they hit the mesh, one diffuse bounce each: rays that have little in common. Those that miss
// give none.
ray_list bounce_rays(const mesh *m, const searcher *s, const void *tree, ray_list primary);

// What the first `count` rays of a list cost; any: only whether there is a hit.
effort spent_on(const searcher *s, const void *tree, ray_list list, int count, bool any);

// As many rays as can be borne: brute force on a large mesh gets fewer.
int bearable(const searcher *s, const mesh *m, int count);

#endif
