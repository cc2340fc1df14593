// figures.h: all figures of the slides that no chapter's program draws. What is marked in them is
// computed, where a chapter has a function for it by that.
#ifndef SLIDES_FIGURES_H
#define SLIDES_FIGURES_H

#include "slides/figures/svg.h"

typedef void figure(const char *folder);

// geometry.c
figure camera_figure, backwards_figure, plane_figure, sphere_figure, triangle_figure,
    inside_figure, bounce_figure, fuzzy_figure, loop_figure;
// light.c
figure cosine_figure, solid_angle_figure, path_figure, lamp_figure, snell_figure;
// trees.c
figure slab_figure, boxes_figure, split_figure, bvh_figure, flat_figure;
// cells.c
figure kd_figure, straddle_figure, octree_figure, order_figure;
// chance.c
figure darts_figure, importance_figure, lift_figure;
// the later ones of light.c and trees.c
figure fresnel_figure, leaf_figure;

#endif
