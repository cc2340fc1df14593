// 13-kd-tree: steps per ray in a BVH and in a k-d tree, side by side, and the cells of a tree
// where a plane cuts them.
#include <stdio.h>

#include "chapters/12-bvh/shapes.h"
#include "chapters/12-bvh/stage.h"
#include "chapters/13-kd-tree/kd_tree.h"
#include "common/measure.h"
#include "common/todo.h"

typedef struct {
    mesh m;
    bvh b;
    kd_tree k;
    const shape *what;
} model;

static const shape *shape_named(mesh (*make)(long)) {
    const shape *s = shapes;
    while (s->make != make) s++;
    return s;
}

static void print_builds(const model *x, double bvh_seconds, double kd_seconds) {
    const kd_figures f = kd_measure(&x->k);
    printf("%s: %d triangles\n", x->what->name, x->m.count);
    printf("BVH       built in %.2f s, %zu bytes\n", bvh_seconds, bvh_measure(&x->b).bytes);
    printf("k-d tree  built in %.2f s, %zu bytes; depth %d; %ld leaves, %ld of them empty; "
           "%.2f references a triangle\n",
           kd_seconds, f.bytes, f.depth, f.leaves, f.empty,
           (double)x->k.list_count / x->k.count);
}

// In place: the trees point at the mesh.
static void load(model *x, mesh (*make)(long), long triangles, kd_options how) {
    x->what = shape_named(make);
    x->m = make(triangles);
    const double start = clock_seconds();
    x->b = bvh_build(&x->m, bvh_defaults);
    const double middle = clock_seconds();
    x->k = kd_build(&x->m, how);
    print_builds(x, middle - start, clock_seconds() - middle);
}

static void unload(model *x) {
    bvh_free(&x->b);
    kd_free(&x->k);
    mesh_free(&x->m);
}

static camera camera_of(const model *x, int width, int height) {
    return camera_look_at(x->what->eye, x->what->target, (vec3){0, 1, 0}, 40, width, height);
}

// ---- steps -----------------------------------------------------------------------------

// A lamp in the eye.
static color look(const void *data, ray r, rng *g) {
    (void)g;
    const model *x = data;
    int index = 0;
    const triangle_point q = kd_nearest(&x->k, r, 0, NO_HIT, &index, NULL);
    if (q.t == NO_HIT) return (color){(real)0.02, (real)0.03, (real)0.05};
    const hit h = mesh_surface(&x->m, index, r, q);
    const real c = fabs(dot(normalize(r.d), h.n));
    return (color){(real)0.7 * c, (real)0.6 * c, (real)0.5 * c};
}

// Each pair of boxes is fetched as one, each plane too: these are compared.
static color look_bvh(const void *data, ray r, rng *g) {
    (void)g;
    const model *x = data;
    int index = 0;
    effort spent = {0, 0};
    bvh_nearest(&x->b, r, 0, NO_HIT, &index, &spent);
    return heat(spent.steps / 2, 4);
}

static color look_kd(const void *data, ray r, rng *g) {
    (void)g;
    const model *x = data;
    int index = 0;
    effort spent = {0, 0};
    kd_nearest(&x->k, r, 0, NO_HIT, &index, &spent);
    return heat(spent.steps, 4);
}

static void print_effort(const model *x, const camera *cam) {
    effort in_bvh = {0, 0}, in_kd = {0, 0};
    int index = 0;
    for (int y = 0; y < cam->height; y++)
        for (int i = 0; i < cam->width; i++) {
            const ray r = camera_ray(cam, (real)i + (real)0.5, (real)y + (real)0.5);
            bvh_nearest(&x->b, r, 0, NO_HIT, &index, &in_bvh);
            kd_nearest(&x->k, r, 0, NO_HIT, &index, &in_kd);
        }
    const double rays = (double)cam->width * cam->height;
    printf("a ray: BVH %.1f boxes, %.1f tests; k-d tree %.1f planes, %.1f tests\n",
           (double)in_bvh.steps / rays, (double)in_bvh.tests / rays, (double)in_kd.steps / rays,
           (double)in_kd.tests / rays);
}

// With a stub in an answer's place the tree may be one leaf, or the walk go everywhere: then
// few triangles, or the picture would take hours.
static void load_for_steps(model *x, mesh (*make)(long), long triangles) {
    enum { FEW = 200 };
    load(x, make, triangles, kd_defaults);
    look(x, (ray){x->what->eye, sub(x->what->target, x->what->eye)}, NULL);
    if (!todo_first()) return;
    printf("An exercise is not written yet: the picture has about %d triangles.\n", FEW);
    unload(x);
    load(x, make, FEW, kd_defaults);
}

// The mesh, the pairs of boxes of the BVH that each ray asked, and the planes of the k-d tree.
static image show_steps(const options *opt, mesh (*make)(long), long triangles) {
    static const radiance looks[] = {look, look_bvh, look_kd};
    model x;
    image parts[COUNT(looks)];
    load_for_steps(&x, make, triangles);
    for (int i = 0; i < COUNT(looks); i++) {
        const camera cam =
            camera_of(&x, image_part_width(opt->width, i, COUNT(looks)), opt->height);
        parts[i] = render("13-kd-tree", &cam, looks[i], &x, opt);
        if (i == 0) print_effort(&x, &cam);
    }
    unload(&x);
    return image_side_by_side(parts, COUNT(parts));
}

// ---- cells -----------------------------------------------------------------------------

// The leaf in which p lies.
static uint32_t leaf_at(const kd_tree *k, vec3 p) {
    uint32_t node = 0;
    while (kd_kind(k->nodes[node]) != KD_LEAF) {
        const kd_node n = k->nodes[node];
        node = along(p, (int)kd_kind(n)) < n.split ? node + 1 : kd_number(n);
    }
    return node;
}

// Where the plane z = 0.05 cuts the cells: lines between them, blue where a cell is empty,
// lighter the more triangles it lists.
static image slice(const kd_tree *k, int width, int height) {
    image img = image_new(width, height);
    const vec3 e = sub(k->box.max, k->box.min);
    const real pixel = (real)1.02 * fmax(e.x / (real)width, e.y / (real)height);
    const vec3 c = aabb_centre(k->box);
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++) {
            const vec3 p = {c.x + pixel * ((real)x - (real)0.5 * (real)width),
                            c.y - pixel * ((real)y - (real)0.5 * (real)height), (real)0.05};
            const uint32_t leaf = leaf_at(k, p);
            const bool border = leaf != leaf_at(k, add(p, (vec3){pixel, 0, 0})) ||
                                leaf != leaf_at(k, sub(p, (vec3){0, pixel, 0}));
            const real count = (real)kd_number(k->nodes[leaf]);
            const color empty = {(real)0.03, (real)0.06, (real)0.15},
                        full = {fmin(1, (real)0.2 + count / 8), (real)0.3, (real)0.05};
            *image_at(&img, x, y) = border      ? (color){(real)0.6, (real)0.6, (real)0.6}
                                    : count > 0 ? full
                                                : empty;
        }
    return img;
}

static image show_cells(const options *opt, const kd_options *hows, int count) {
    image parts[4];
    for (int i = 0; i < count; i++) {
        model x;
        load(&x, shape_knot, 1500, hows[i]);
        parts[i] = slice(&x.k, image_part_width(opt->width, i, count), opt->height);
        unload(&x);
    }
    return image_side_by_side(parts, count);
}

// The empty-space bonus: none, a little, much.
static image show_bonus(const options *opt) {
    kd_options hows[] = {kd_defaults, kd_defaults, kd_defaults};
    hows[0].bonus = 0;
    hows[2].bonus = (real)0.7;
    return show_cells(opt, hows, COUNT(hows));
}

// Left the boxes of straddling triangles only cut at the plane, right the bounds of what is in
// the cell.
static image show_clip(const options *opt) {
    kd_options hows[] = {kd_defaults, kd_defaults};
    hows[0].clip = false;
    return show_cells(opt, hows, COUNT(hows));
}

// ---- the program ------------------------------------------------------------------------

static image show(const options *opt) {
    if (shows(opt, "stadium")) return show_steps(opt, shape_stadium, 30000);
    if (shows(opt, "cloud")) return show_steps(opt, shape_cloud, 30000);
    if (shows(opt, "bonus")) return show_bonus(opt);
    if (shows(opt, "clip")) return show_clip(opt);
    return show_steps(opt, shape_sphereflake, 60000);
}

static const choice pictures[] = {
    {"steps", "balls on balls; pairs of boxes per ray in a BVH; planes per ray in a k-d tree"},
    {"stadium", "the same of a tiny knot in a large hall"},
    {"cloud", "the same of a cloud of triangles"},
    {"bonus", "the cells in a slice, with no, some and much bonus for empty space"},
    {"clip", "the cells in a slice, without and with clipped bounds"},
    {0},
};

int main(int argc, char **argv) {
    const program about = {
        .name = "13-kd-tree",
        .summary = "Compares a k-d tree with a BVH and draws its cells.",
        .uses = USES_SIZE | USES_SAMPLES | USES_SEED | USES_THREADS | USES_PREVIEW,
        .defaults =
            {.width = 720, .height = 240, .samples = 1, .seed = 1, .out = "13-kd-tree.png"},
        .shows = pictures,
    };
    const options opt = options_parse(argc, argv, &about);
    image img = show(&opt);
    image_write(&img, opt.out);
    image_free(&img);
}
