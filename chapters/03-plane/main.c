// 03-plane: a checkered floor to the horizon, and what the picture shows when
// t < 0 is not rejected.
#include "chapters/03-plane/plane.h"

static const plane floor_plane = {.x = {0, -1, 0}, .n = {0, 1, 0}};

static color sky(vec3 d) {
    const real height = fmax(d.y / length(d), 0);
    return lerp((color){1, 1, 1}, (color){(real)0.35, (real)0.6, 1}, height);
}

static color board(real share) {
    return lerp((color){(real)0.9, (real)0.9, (real)0.85},
                (color){(real)0.1, (real)0.3, (real)0.2}, share);
}

// The colour of the floor at t, or of the sky when there is no floor.
static color look(ray r, real t) {
    if (t == NO_HIT) return sky(r.d);
    const vec3 p = ray_at(r, t);
    return board(checks(p.x, p.z));
}

static color floor_or_sky(const void *unused, ray r, rng *g) {
    (void)unused, (void)g;
    return look(r, plane_hit(floor_plane, r, 0, NO_HIT));
}

// The mistake: every solution counts, also the one behind the eye.
static color also_behind(const void *unused, ray r, rng *g) {
    (void)unused, (void)g;
    return look(r, plane_hit(floor_plane, r, -NO_HIT, NO_HIT));
}

// The checks averaged over a square as long as the pixel's image on the floor, which
// is distance / focal wide and, away from the eye, longer by 1 / slope.
static color filtered(const void *scene, ray r, rng *g) {
    (void)g;
    const camera *cam = scene;
    const real t = plane_hit(floor_plane, r, 0, NO_HIT);
    if (t == NO_HIT) return sky(r.d);
    const vec3 p = ray_at(r, t);
    const real distance = t * length(r.d);
    const real width = distance / cam->focal, slope = -r.d.y / length(r.d);
    return board(checks_average(p.x, p.z, width / slope));
}

static radiance chosen(const options *opt) {
    if (shows(opt, "behind")) return also_behind;
    return shows(opt, "filtered") ? filtered : floor_or_sky;
}

static const choice pictures[] = {
    {"floor", "a checkered floor to the horizon"},
    {"behind", "the mistake: solutions with t < 0 are kept"},
    {"filtered", "one ray a pixel, the checks averaged (exercise checks_average)"},
    {0},
};

int main(int argc, char **argv) {
    const program about = {
        .name = "03-plane",
        .summary = "Draws a checkered floor to the horizon.",
        .uses = USES_SIZE | USES_SAMPLES | USES_SEED | USES_THREADS | USES_PREVIEW,
        .defaults =
            {.width = 640, .height = 400, .samples = 64, .seed = 1, .out = "03-plane.png"},
        .shows = pictures,
    };
    options opt = options_parse(argc, argv, &about);
    const vec3 eye = {(real)0.3, 0, 2}, target = {(real)0.3, (real)-0.25, 0}, up = {0, 1, 0};
    const camera cam = camera_look_at(eye, target, up, 60, opt.width, opt.height);
    if (shows(&opt, "filtered")) opt.samples = 1; // that is its point
    image img = render(about.name, &cam, chosen(&opt), &cam, &opt);
    image_write(&img, opt.out);
    image_free(&img);
}
