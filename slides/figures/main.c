// Writes the slides' figures into a folder: build/slides/figures.
#include "slides/figures/figures.h"

#include "common/die.h"

int main(int argc, char **argv) {
    static figure *const figures[] = {
        camera_figure,      backwards_figure, plane_figure, sphere_figure, triangle_figure,
        inside_figure,      bounce_figure,    fuzzy_figure, loop_figure,   cosine_figure,
        solid_angle_figure, path_figure,      lamp_figure,  snell_figure,  slab_figure,
        boxes_figure,       split_figure,     bvh_figure,   flat_figure,   kd_figure,
        octree_figure,      straddle_figure,  order_figure, darts_figure,  importance_figure,
        lift_figure,        fresnel_figure,   leaf_figure};
    if (argc != 2) die(EXIT_USAGE, "usage: figures FOLDER");
    for (unsigned i = 0; i < sizeof figures / sizeof *figures; i++) figures[i](argv[1]);
}
