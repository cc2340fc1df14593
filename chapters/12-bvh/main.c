// 12-bvh: large meshes, generated or from an OBJ file, and what their trees are like: the steps of
// each ray as colours, in trees of three builds; the boxes as wires.
#include <stdio.h>

#include "chapters/12-bvh/obj.h"
#include "chapters/12-bvh/shapes.h"
#include "chapters/12-bvh/stage.h"
#include "chapters/12-bvh/wires.h"
#include "common/die.h"
#include "common/measure.h"

// What is drawn, with the time that its tree took.
typedef struct {
    mesh m;
    setting how;
    bvh tree;
    double seconds;
} model;

// ---- the mesh ------------------------------------------------------------------------

static void say(const char *what, long count) {
    if (count) fprintf(stderr, "; %s: %ld", what, count);
}

static mesh read_file(const char *path) {
    mesh m;
    obj_report report;
    char error[OBJ_ERROR];
    if (!obj_read(path, &m, &report, error)) die(EXIT_RUN, "%s", error);
    fprintf(stderr, "%s: triangles: %d", path, m.count);
    say("faces cut into triangles", report.polygons);
    say("without area, left out", report.degenerate);
    say("corners without normal, so that all is flat", report.bare);
    say("lines not about shape, skipped", report.skipped);
    fputc('\n', stderr);
    return m;
}

static bvh build(const mesh *m, split_rule rule, double *seconds) {
    bvh_options how = bvh_defaults;
    how.rule = rule;
    const double start = clock_seconds();
    const bvh tree = bvh_build(m, how);
    *seconds = clock_seconds() - start;
    return tree;
}

// A name of shapes.h's, or else a file. In place: the tree points at the mesh.
static void load(model *x, const options *opt) {
    const exhibit *e = exhibit_named(opt->file ? opt->file : "sphereflake");
    x->m = e ? e->make(e->triangles) : read_file(opt->file);
    x->how = e ? e->how : setting_around(mesh_box(&x->m), opt->width, opt->height);
    x->tree = build(&x->m, SPLIT_SAH, &x->seconds);
}

static camera camera_of(const model *x, int width, int height) {
    const vec3 up = {0, 1, 0};
    return camera_look_at(x->how.eye, x->how.target, up, x->how.fov, width, height);
}

// ---- the picture ---------------------------------------------------------------------

typedef struct {
    stage on;
    int s; // bounces at most
} job;

static color look(const void *data, ray r, rng *g) {
    const job *j = data;
    return light_trace(&j->on.room, r, j->s, g);
}

static image show_light(const options *opt, const model *x) {
    job j = {.s = opt->depth};
    stage_set(&j.on, &x->m, &x->tree, x->how);
    const camera cam = camera_of(x, opt->width, opt->height);
    const image img = render("12-bvh", &cam, look, &j, opt);
    stage_free(&j.on);
    return img;
}

// ---- steps ---------------------------------------------------------------------------

static color look_steps(const void *data, ray r, rng *g) {
    (void)g;
    int index = 0;
    effort spent = {0};
    bvh_nearest(data, r, 0, NO_HIT, &index, &spent);
    return heat(spent.steps, 8);
}

static image steps_of(const options *opt, const model *x, const bvh *tree, int width) {
    const camera cam = camera_of(x, width, opt->height);
    return render("12-bvh", &cam, look_steps, tree, opt);
}

// Steps and tests through the middle of each pixel.
static void print_effort(const char *name, const bvh *tree, const camera *cam) {
    effort sum = {0};
    int index = 0;
    for (int y = 0; y < cam->height; y++)
        for (int x = 0; x < cam->width; x++) {
            const ray r = camera_ray(cam, (real)x + (real)0.5, (real)y + (real)0.5);
            bvh_nearest(tree, r, 0, NO_HIT, &index, &sum);
        }
    const double rays = (double)cam->width * cam->height;
    printf("%-8s %.1f steps and %.1f tests a ray\n", name, (double)sum.steps / rays,
           (double)sum.tests / rays);
}

static image show_builds(const options *opt, const model *x) {
    static const struct {
        const char *name;
        split_rule rule;
    } rules[] = {{"median", SPLIT_MEDIAN}, {"midpoint", SPLIT_MIDPOINT}, {"SAH", SPLIT_SAH}};
    image parts[COUNT(rules)];
    for (int i = 0; i < COUNT(rules); i++) {
        double seconds;
        const int width = image_part_width(opt->width, i, COUNT(rules));
        const camera cam = camera_of(x, width, opt->height);
        bvh tree = build(&x->m, rules[i].rule, &seconds);
        parts[i] = steps_of(opt, x, &tree, width);
        print_effort(rules[i].name, &tree, &cam);
        bvh_free(&tree);
    }
    return image_side_by_side(parts, COUNT(parts));
}

// ---- boxes ---------------------------------------------------------------------------

// Clay under a lamp in the eye.
static color look_clay(const void *data, ray r, rng *g) {
    (void)g;
    const bvh *tree = data;
    int index = 0;
    const triangle_point q = bvh_nearest(tree, r, 0, NO_HIT, &index, NULL);
    if (q.t == NO_HIT) return (color){0, 0, 0};
    const hit h = mesh_surface(tree->m, index, r, q);
    const real light = fabs(dot(h.n, normalize(r.d)));
    return scale((real)0.35 * light, (color){1, 0.85f, 0.75f});
}

static image show_boxes(const options *opt, const model *x) {
    static const int depths[] = {2, 5, 8};
    image parts[COUNT(depths)];
    for (int i = 0; i < COUNT(depths); i++) {
        const int width = image_part_width(opt->width, i, COUNT(depths));
        const camera cam = camera_of(x, width, opt->height);
        parts[i] = render("12-bvh", &cam, look_clay, &x->tree, opt);
        wires_draw(&parts[i], &cam, &x->tree, depths[i], (color){0.1f, 0.75f, 1});
    }
    return image_side_by_side(parts, COUNT(parts));
}

// ---- the program ---------------------------------------------------------------------

static const choice pictures[] = {
    {"light", "the mesh under a lamp and the sky"},
    {"steps", "how many boxes each ray was asked for: the colours are in the text"},
    {"builds", "the same in three trees: by median, by midpoint, by SAH; prints the steps"},
    {"boxes", "the boxes 2, 5 and 8 levels below the root"},
    {0},
};

static image show(const options *opt, const model *x) {
    if (shows(opt, "steps")) return steps_of(opt, x, &x->tree, opt->width);
    if (shows(opt, "builds")) return show_builds(opt, x);
    if (shows(opt, "boxes")) return show_boxes(opt, x);
    return show_light(opt, x);
}

static void print_tree(const model *x, double all) {
    const bvh_figures f = bvh_measure(&x->tree);
    fprintf(
        stderr,
        "12-bvh: triangles: %d; nodes: %d; depth: %d; %.4g MB; built in %.2g %% of %.3g s\n",
        x->tree.count, f.leaves ? 2 * f.leaves - 1 : 0, f.depth, (double)f.bytes / 1e6,
        100 * x->seconds / all, all);
}

int main(int argc, char **argv) {
    const program about = {
        .name = "12-bvh",
        .summary = "Draws a large mesh with the help of a tree, and the work of the tree.",
        .uses = USES_SIZE | USES_SAMPLES | USES_DEPTH | USES_SEED | USES_THREADS |
                USES_PREVIEW | USES_FILE,
        .defaults = {.width = 480,
                     .height = 360,
                     .samples = 16,
                     .depth = 8,
                     .seed = 1,
                     .out = "12-bvh.png"},
        .shows = pictures,
        .file =
            "a mesh: an OBJ file, or sphereflake, knot, hills, sponge, cloud, cave, stadium",
    };
    const double start = clock_seconds();
    const options opt = options_parse(argc, argv, &about);
    model x;
    load(&x, &opt);
    image img = show(&opt, &x);
    image_write(&img, opt.out);
    print_tree(&x, clock_seconds() - start);
    image_free(&img);
    bvh_free(&x.tree);
    mesh_free(&x.m);
}
