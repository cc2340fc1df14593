// 09-path-tracer: a room lit by a lamp, by random paths; the slide's slip, the end of
// a path, and what an average is made of.
#include "chapters/09-path-tracer/box.h"

typedef color transform(color L);

typedef struct {
    room sc;
    path_tracer trace;
    int s;           // bounces at most
    transform *then; // what is averaged; NULL: the light itself
} job;

static color look(const void *data, ray r, rng *g) {
    const job *j = data;
    const color L = j->trace(&j->sc, r, j->s, g);
    return j->then ? j->then(L) : L;
}

static image draw(const options *opt, const camera *cam, job j) {
    const bool slip = j.trace == trace_ray_slide; // the reader shall know whose samples are bad
    return render(slip ? "09-path-tracer, by the slide" : "09-path-tracer", cam, look, &j, opt);
}

// ---- the box -----------------------------------------------------------------------

static job box_job(path_tracer f, int s) {
    return (job){{box_bodies, box_surfaces}, f, s, NULL};
}

static image show_box(const options *opt) {
    const camera cam = box_camera(opt->width, opt->height);
    return draw(opt, &cam, box_job(path_trace, opt->depth));
}

enum { PANELS = 4 };

static image box_panel(const options *opt, int i, int count, job j) {
    const camera cam = box_camera(image_part_width(opt->width, i, count), opt->height);
    return draw(opt, &cam, j);
}

// Four times the samples, half the noise.
static image show_samples(const options *opt) {
    image parts[PANELS];
    options part = *opt;
    for (int i = 0; i < PANELS; i++) {
        part.samples = opt->samples >> 2 * (PANELS - 1 - i);
        if (part.samples < 1) part.samples = 1;
        parts[i] = box_panel(&part, i, PANELS, box_job(path_trace, opt->depth));
    }
    return image_side_by_side(parts, PANELS);
}

// Cut after 1, 2 and 3 bounces; and ended by roulette.
static image show_roulette(const options *opt) {
    image parts[PANELS];
    for (int i = 0; i < PANELS; i++) {
        const bool cut = i < PANELS - 1;
        parts[i] = box_panel(opt, i, PANELS,
                             cut ? box_job(trace_ray, i + 1) : box_job(path_trace, opt->depth));
    }
    return image_side_by_side(parts, PANELS);
}

// ---- what is averaged ----------------------------------------------------------------

static color clamped(color L) {
    return (color){fmin(L.x, 1), fmin(L.y, 1), fmin(L.z, 1)};
}

static color encoded(color L) {
    return scale((real)1 / 255, (color){srgb_byte(L.x), srgb_byte(L.y), srgb_byte(L.z)});
}

// Back to light: the file's writer encodes again.
static void decode(image *img) {
    color *p = img->pixels;
    for (long i = 0; i < (long)img->width * img->height; i++)
        p[i] = (color){srgb_light(p[i].x), srgb_light(p[i].y), srgb_light(p[i].z)};
}

// The means of the light, of the clamped light and of the encoded numbers.
static image show_average(const options *opt) {
    transform *const thens[] = {NULL, clamped, encoded};
    image parts[COUNT(thens)];
    for (int i = 0; i < COUNT(thens); i++) {
        job j = box_job(path_trace, opt->depth);
        j.then = thens[i];
        parts[i] = box_panel(opt, i, COUNT(thens), j);
        if (thens[i] == encoded) decode(&parts[i]);
    }
    return image_side_by_side(parts, COUNT(thens));
}

// ---- the furnace ---------------------------------------------------------------------

static color half_sky(vec3 d) {
    (void)d;
    return (color){(real)0.5, (real)0.5, (real)0.5};
}

// A ball alone in an even sky. One that reflects everything cannot be seen.
static image ball_panel(const options *opt, int i, path_tracer f, real albedo) {
    const sphere ball = {{(real)0.2, (real)0.1, (real)-0.3}, 1};
    const matte skin = {.albedo = {albedo, albedo, albedo}};
    const room furnace = {{.spheres = &ball, .sphere_count = 1, .sky = half_sky}, &skin};
    const vec3 eye = {1, 2, 5}, up = {0, 1, 0};
    const camera cam = camera_look_at(eye, ball.c, up, 30,
                                      image_part_width(opt->width, i, PANELS), opt->height);
    return draw(opt, &cam, (job){furnace, f, opt->depth, NULL});
}

static image show_furnace(const options *opt) {
    image parts[PANELS] = {
        ball_panel(opt, 0, trace_ray_slide, 1), ball_panel(opt, 1, trace_ray, (real)0.5),
        ball_panel(opt, 2, trace_ray, (real)0.9), ball_panel(opt, 3, trace_ray, 1)};
    return image_side_by_side(parts, PANELS);
}

static image show(const options *opt) {
    if (shows(opt, "samples")) return show_samples(opt);
    if (shows(opt, "furnace")) return show_furnace(opt);
    if (shows(opt, "roulette")) return show_roulette(opt);
    if (shows(opt, "average")) return show_average(opt);
    return show_box(opt);
}

static const choice pictures[] = {
    {"box", "two balls in a closed room, under a square lamp"},
    {"samples", "the box with 1/64, 1/16, 1/4 and all of the samples"},
    {"furnace", "a ball in an even sky: by the slide; mended, albedo 0.5, 0.9, 1"},
    {"roulette", "the box cut after 1, 2 and 3 bounces; and ended by roulette"},
    {"average", "the mean of the light, of the clamped light, of the sRGB numbers"},
    {0},
};

int main(int argc, char **argv) {
    const program about = {
        .name = "09-path-tracer",
        .summary = "Draws a room by random paths from the eye to the lamp.",
        .uses = USES_SIZE | USES_SAMPLES | USES_DEPTH | USES_SEED | USES_THREADS | USES_PREVIEW,
        .defaults = {.width = 256,
                     .height = 256,
                     .samples = 128,
                     .depth = 100,
                     .seed = 1,
                     .out = "09-path-tracer.png"},
        .shows = pictures,
    };
    const options opt = options_parse(argc, argv, &about);
    image img = show(&opt);
    image_write(&img, opt.out);
    image_free(&img);
}
