// 06-bounce: mirrors and matte bodies under a sky, the slide's loop beside the
// mended one, and what goes wrong where the next ray starts.
#include "chapters/06-bounce/bounce.h"

#define PAINT(r, g, b) \
    { (real)(r), (real)(g), (real)(b) }

typedef color loop(const scene *sc, ray r, int s, rng *g);

typedef struct {
    scene sc;
    int s; // bounces at most
    loop *trace;
} job;

static color look(const void *data, ray r, rng *g) {
    const job *j = data;
    return j->trace(&j->sc, r, j->s, g);
}

// ---- the scenes ------------------------------------------------------------------

static const material board = {MATTE, PAINT(0.75, 0.75, 0.7), PAINT(0.1, 0.25, 0.18),
                               .checkered = true};
static const plane floor_plane = {.x = {0, 0, 0}, .n = {0, 1, 0}};

// Mirrors, matte spheres and an octahedron.
static const sphere spheres[] = {
    {{0, 1, 0}, 1},
    {{(real)-2.2, (real)0.8, (real)0.4}, (real)0.8},
    {{(real)0.9, (real)0.35, (real)1.5}, (real)0.35},
    {{(real)-0.9, (real)0.3, (real)1.4}, (real)0.3},
    {{(real)2.5, (real)0.6, (real)-1.4}, (real)0.6},
};
static const material paints[] = {
    {.finish = MIRROR, .albedo = PAINT(0.9, 0.9, 0.9)},
    {.finish = MATTE, .albedo = PAINT(0.75, 0.2, 0.15)},
    {.finish = MATTE, .albedo = PAINT(0.9, 0.7, 0.2)},
    {.finish = MIRROR, .albedo = PAINT(0.9, 0.75, 0.5)},
    {.finish = MATTE, .albedo = PAINT(0.25, 0.4, 0.8)},
};
static const vec3 points[] = {
    {(real)2.1, (real)1.5, (real)0.5},  {(real)2.1, 0, (real)0.5},
    {(real)2.7, (real)0.75, (real)0.8}, {(real)1.5, (real)0.75, (real)0.2},
    {(real)1.8, (real)0.75, (real)1.1}, {(real)2.4, (real)0.75, (real)-0.1}};
static const int corners[][3] = {{0, 4, 2}, {0, 2, 5}, {0, 5, 3}, {0, 3, 4},
                                 {1, 2, 4}, {1, 5, 2}, {1, 3, 5}, {1, 4, 3}};
static const mesh octahedron = {.points = points, .corners = corners, .count = COUNT(corners)};
static const material copper = {
    .finish = FUZZY, .albedo = PAINT(0.9, 0.55, 0.4), .fuzz = (real)0.15};

static const scene studio = {.spheres = spheres,
                             .sphere_materials = paints,
                             .sphere_count = COUNT(spheres),
                             .planes = &floor_plane,
                             .plane_materials = &board,
                             .plane_count = 1,
                             .meshes = &octahedron,
                             .mesh_materials = &copper,
                             .mesh_count = 1,
                             .sky = clear_sky};

// The lecture's matte with more and more fuzz, and Lambert's at the right end.
enum { ROW = 6 };
#define FUZZ(f) \
    { .finish = FUZZY, .albedo = PAINT(0.8, 0.8, 0.8), .fuzz = (real)(f) }
#define PLACE(i) \
    { {(real)(2.2 * (i)-5.5), 1, 0}, 1 }
static const sphere row[ROW] = {PLACE(0), PLACE(1), PLACE(2), PLACE(3), PLACE(4), PLACE(5)};
static const material row_paints[ROW] = {
    FUZZ(0),    FUZZ(0.25), FUZZ(0.5),
    FUZZ(0.75), FUZZ(1),    {.finish = MATTE, .albedo = PAINT(0.8, 0.8, 0.8)}};

static const scene fuzzy_row = {.spheres = row,
                                .sphere_materials = row_paints,
                                .sphere_count = ROW,
                                .planes = &floor_plane,
                                .plane_materials = &board,
                                .plane_count = 1,
                                .sky = clear_sky};

// ---- the pictures ----------------------------------------------------------------

static image draw(const options *opt, const camera *cam, job j) {
    return render("06-bounce", cam, look, &j, opt);
}

static camera studio_camera(int width, int height) {
    const vec3 eye = {(real)0.6, (real)1.7, 6}, target = {(real)0.2, (real)0.75, 0},
               up = {0, 1, 0};
    return camera_look_at(eye, target, up, 36, width, height);
}

static image show_spheres(const options *opt) {
    const camera cam = studio_camera(opt->width, opt->height);
    return draw(opt, &cam, (job){studio, opt->depth, trace});
}

// As on the slide, with few bounces: black where s runs out; and mended.
static image show_slide(const options *opt) {
    const camera cam = studio_camera(image_part_width(opt->width, 0, 2), opt->height);
    image halves[] = {draw(opt, &cam, (job){studio, opt->depth, trace_slide}),
                      draw(opt, &cam, (job){studio, opt->depth, trace})};
    return image_side_by_side(halves, COUNT(halves));
}

static image show_fuzzy(const options *opt) {
    const vec3 eye = {0, 3, 16}, target = {0, (real)0.8, 0};
    const camera cam = camera_across(eye, target, 7, opt->width, opt->height);
    return draw(opt, &cam, (job){fuzzy_row, opt->depth, trace});
}

// Three marbles on a great ball, everything `size` times as large: what is right at
// one size is right at all. The ball's radius is 1000 marbles.
static image show_size(const options *opt, start_rule start, real size) {
    sphere bodies[] = {{{0, -1000, 0}, 1000},
                       {{(real)-1.1, 1, 0}, 1},
                       {{(real)1.1, 1, (real)-0.2}, 1},
                       {{(real)0.1, (real)0.5, (real)1.3}, (real)0.5}};
    const material coats[] = {
        {.finish = MATTE, .albedo = PAINT(0.7, 0.7, 0.65)}, paints[1], paints[0], paints[2]};
    for (int i = 0; i < COUNT(bodies); i++)
        bodies[i] = (sphere){scale(size, bodies[i].c), size * bodies[i].r};
    const vec3 eye = scale(size, (vec3){0, 3, 9}),
               target = scale(size, (vec3){0, (real)0.8, 0});
    const camera cam = camera_across(eye, target, (real)2.5 * size,
                                     image_part_width(opt->width, 0, 3), opt->height);
    const scene sc = {.spheres = bodies,
                      .sphere_materials = coats,
                      .sphere_count = COUNT(bodies),
                      .sky = clear_sky,
                      .start = start};
    return draw(opt, &cam, (job){sc, opt->depth, trace});
}

static image show_acne(const options *opt, start_rule start) {
    image thirds[] = {show_size(opt, start, (real)1e-4), show_size(opt, start, 1),
                      show_size(opt, start, (real)1e4)};
    return image_side_by_side(thirds, COUNT(thirds));
}

static image show(const options *opt) {
    if (shows(opt, "slide")) return show_slide(opt);
    if (shows(opt, "fuzzy")) return show_fuzzy(opt);
    if (shows(opt, "acne-nothing")) return show_acne(opt, START_NOTHING);
    if (shows(opt, "acne-epsilon")) return show_acne(opt, START_EPSILON);
    if (shows(opt, "acne-bound")) return show_acne(opt, START_BOUND);
    return show_spheres(opt);
}

static const choice pictures[] = {
    {"spheres", "mirrors and matte bodies on a checkered floor"},
    {"slide", "the loop as on the slide, and mended: try --depth 1, 2, 3"},
    {"fuzzy", "the lecture's matte with fuzz 0 to 1, and Lambert's on the right"},
    {"acne-nothing", "next rays start at the hit; sizes 0.0001, 1, 10000"},
    {"acne-epsilon", "the same with the fixed t_min 0.0001"},
    {"acne-bound", "the same, started past the error bound"},
    {0},
};

int main(int argc, char **argv) {
    const program about = {
        .name = "06-bounce",
        .summary = "Draws mirrors and matte bodies by following rays as they bounce.",
        .uses = USES_SIZE | USES_SAMPLES | USES_DEPTH | USES_SEED | USES_THREADS | USES_PREVIEW,
        .defaults = {.width = 640,
                     .height = 400,
                     .samples = 32,
                     .depth = 8,
                     .seed = 1,
                     .out = "06-bounce.png"},
        .shows = pictures,
    };
    const options opt = options_parse(argc, argv, &about);
    image img = show(&opt);
    image_write(&img, opt.out);
    image_free(&img);
}
