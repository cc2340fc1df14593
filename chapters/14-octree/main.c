// 14-octree: all searchers on the same rays: what each costs, as pictures and as a table; and
// the octree's cells.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "chapters/14-octree/contest.h"
#include "common/measure.h"

enum { TRIANGLES = 50000, SIDE = 64 };

typedef struct {
    const mesh *m;
    const searcher *by;
    const void *tree;
} job;

// ---- what a ray costs, as a colour ---------------------------------------------------------

enum { MOST = 400 }; // cells and triangles asked: white

// From black over blue, red and yellow to white.
static color heat(real x) {
    static const color scale_of[] = {{0, 0, 0},
                                     {(real)0.02, (real)0.05, (real)0.5},
                                     {(real)0.7, (real)0.02, (real)0.1},
                                     {1, (real)0.7, 0},
                                     {1, 1, 1}};
    const real at = fmin(fmax(x, 0), (real)0.9999) * (COUNT(scale_of) - 1);
    const int i = (int)at;
    return lerp(scale_of[i], scale_of[i + 1], at - (real)i);
}

static color cost_seen(const void *scene, ray r, rng *g) {
    (void)g;
    const job *j = scene;
    int index = 0;
    effort spent = {0, 0};
    j->by->nearest(j->tree, r, 0, NO_HIT, &index, &spent);
    return heat(log1p((real)(spent.steps + spent.tests)) / log1p((real)MOST));
}

static color shape_seen(const void *scene, ray r, rng *g) {
    (void)g;
    const job *j = scene;
    int index = 0;
    const triangle_point q = j->by->nearest(j->tree, r, 0, NO_HIT, &index, NULL);
    if (q.t == NO_HIT) return (color){(real)0.05, (real)0.06, (real)0.08};
    const vec3 n = mesh_surface(j->m, index, r, q).n;
    const vec3 lamp = {(real)0.5, (real)0.7, (real)0.5};
    const real light = (real)0.08 + (real)0.92 * fmax(dot(n, lamp), 0);
    return scale(light, (color){(real)0.9, (real)0.75, (real)0.45});
}

static const shape *shape_named(const char *name) {
    const shape *s = shapes;
    while (s->name && strcmp(s->name, name)) s++;
    return s;
}

static image draw(const options *opt, const shape *s, int part, int parts, job j, radiance f) {
    const vec3 up = {0, 1, 0};
    const camera cam = camera_look_at(s->eye, s->target, up, 40,
                                      image_part_width(opt->width, part, parts), opt->height);
    return render("14-octree", &cam, f, &j, opt);
}

static image show_costs(const options *opt, const shape *s, const mesh *m) {
    static const searcher *const shown[] = {&by_bvh_sah, &by_kd_tree, &by_octree};
    image parts[COUNT(shown)];
    for (int i = 0; i < COUNT(shown); i++) {
        void *tree = shown[i]->build(m);
        parts[i] = draw(opt, s, i, COUNT(shown), (job){m, shown[i], tree}, cost_seen);
        shown[i]->free(tree);
    }
    return image_side_by_side(parts, COUNT(parts));
}

static image show_mesh(const options *opt, const shape *s, const mesh *m) {
    void *tree = by_octree.build(m);
    const image img = draw(opt, s, 0, 1, (job){m, &by_octree, tree}, shape_seen);
    by_octree.free(tree);
    return img;
}

// ---- a slice through the cells ---------------------------------------------------------------

// Is p within `reach` of a side of the cell, along x or y?
static bool at_side(aabb cell, vec3 p, real reach) {
    return p.x - cell.min.x < reach || cell.max.x - p.x < reach || p.y - cell.min.y < reach ||
           cell.max.y - p.y < reach;
}

static color cell_seen(const octree *o, vec3 p, real pixel) {
    aabb cell;
    int depth;
    const octree_node *leaf = octree_at(o, p, &cell, &depth);
    if (depth < 0) return (color){0, 0, 0};
    const color grey = {(real)0.25, (real)0.27, (real)0.3};
    if (at_side(cell, p, pixel / 2)) return leaf ? scale((real)0.3, grey) : grey;
    return leaf ? heat((real)0.3 + (real)leaf->count / 20) : (color){0, 0, (real)0.02};
}

// The plane z = 0 of a mesh with few triangles, so that cells can be seen.
static image show_cells(const options *opt, const shape *s) {
    mesh m = s->make(TRIANGLES / 10);
    octree o = octree_build(&m, octree_defaults);
    image img = image_new(opt->width, opt->height);
    const real pixel = (real)2.1 / (real)(opt->width < opt->height ? opt->width : opt->height);
    for (int y = 0; y < img.height; y++) {
        for (int x = 0; x < img.width; x++) {
            const vec3 p = {pixel * ((real)x + (real)0.5 - (real)img.width / 2),
                            pixel * ((real)img.height / 2 - (real)y - (real)0.5), 0};
            *image_at(&img, x, y) = cell_seen(&o, p, pixel);
        }
    }
    octree_free(&o);
    mesh_free(&m);
    return img;
}

// ---- the table ---------------------------------------------------------------------------------

static void print_rays(const searcher *s, const void *tree, const mesh *m, ray_list list) {
    const int count = bearable(s, m, list.count);
    for (int any = 0; any < 2; any++) {
        const double start = clock_seconds();
        const effort spent = spent_on(s, tree, list, count, any);
        const double ns = 1e9 * (clock_seconds() - start) / count;
        printf(" %8.1f %9.1f %9.0f", (double)spent.steps / count, (double)spent.tests / count,
               ns);
    }
}

static void print_row(const searcher *s, const shape *of, const mesh *m) {
    const double start = clock_seconds();
    void *tree = s->build(m);
    const double seconds = clock_seconds() - start;
    ray_list primary = primary_rays(of, SIDE);
    printf("%-14s %8.3f %6.1f", s->name, seconds, (double)s->bytes(tree) / m->count);
    print_rays(s, tree, m, primary);
    printf("\n");
    fflush(stdout);
    free(primary.rays);
    s->free(tree);
}

static void print_table(const shape *of, const mesh *m) {
    printf("%s, %d triangles, %d rays of the camera\n", of->what, m->count, SIDE * SIDE);
    printf("%-14s %8s %6s %28s %28s\n", "", "build", "bytes", "nearest hit, a ray  ",
           "any hit, a ray  ");
    printf("%-14s %8s %6s %8s %9s %9s %8s %9s %9s\n", "", "seconds", "/tri.", "steps", "tests",
           "ns", "steps", "tests", "ns");
    for (int i = 0; i < CONTESTANTS; i++) print_row(contestants[i], of, m);
}

static image show(const options *opt) {
    const shape *knot = shape_named("knot");
    if (shows(opt, "cells")) return show_cells(opt, knot);
    mesh m = knot->make(TRIANGLES);
    const bool shaded = shows(opt, "mesh");
    if (!shaded) print_table(knot, &m);
    const image img = shaded ? show_mesh(opt, knot, &m) : show_costs(opt, knot, &m);
    mesh_free(&m);
    return img;
}

static const choice pictures[] = {
    {"cost", "cells and triangles asked for each ray: BVH by SAH, k-d tree, octree; a table"},
    {"mesh", "the mesh itself"},
    {"cells", "a slice through the octree's cells"},
    {0},
};

int main(int argc, char **argv) {
    const program about = {
        .name = "14-octree",
        .summary = "Compares brute force, BVH, k-d tree and octree on the same rays.",
        .uses = USES_SIZE | USES_THREADS | USES_PREVIEW,
        .defaults =
            {.width = 900, .height = 300, .samples = 1, .seed = 1, .out = "14-octree.png"},
        .shows = pictures,
    };
    const options opt = options_parse(argc, argv, &about);
    image img = show(&opt);
    image_write(&img, opt.out);
    image_free(&img);
}
