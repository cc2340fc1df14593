// 02-camera: the directions of a camera's rays as colours; the same scene through
// a pinhole, a lens and no perspective at all; and light traced from the lamp to
// the camera beside light traced from the camera to the lamp.
#include "chapters/02-camera/experiment.h"

// ---- directions as colours -----------------------------------------------------

// Red, green, blue are how far d points to +x, +y, +z: 0 is away, 1 is towards.
static color direction(const void *unused, ray r, rng *g) {
    (void)unused, (void)g;
    return scale((real)0.5, add((vec3){1, 1, 1}, normalize(r.d)));
}

// ---- cards on a checkered floor --------------------------------------------------

typedef struct {
    real x, z; // the middle of its lower edge; it faces z
    color paint;
} card;

enum { CARDS = 5 };
#define CARD_HALF_WIDTH ((real)0.4)
#define CARD_HEIGHT ((real)1.2)

static const card cards[CARDS] = {
    // the nearest first: they stand along -z
    {(real)-1.4, 0, {(real)0.8, (real)0.1, (real)0.1}},
    {(real)-0.8, -2, {(real)0.9, (real)0.5, (real)0.05}},
    {(real)0.0, -4, {(real)0.8, (real)0.75, (real)0.1}},
    {(real)1.2, -7, {(real)0.1, (real)0.5, (real)0.2}},
    {(real)3.2, -12, {(real)0.1, (real)0.25, (real)0.8}},
};

static bool meets_card(card c, ray r) {
    const real t = (c.z - r.O.z) / r.d.z;
    const vec3 p = ray_at(r, t);
    return t > 0 && fabs(p.x - c.x) < CARD_HALF_WIDTH && p.y > 0 && p.y < CARD_HEIGHT;
}

static color floor_or_sky(ray r) {
    const real t = -r.O.y / r.d.y; // where y = 0
    if (!(t > 0)) return (color){(real)0.55, (real)0.7, (real)0.9};
    const vec3 p = ray_at(r, t);
    const bool dark = fmod(floor(p.x) + floor(p.z), 2) != 0;
    return dark ? (color){(real)0.25, (real)0.25, (real)0.3}
                : (color){(real)0.9, (real)0.9, (real)0.85};
}

static color cards_on_floor(const void *unused, ray r, rng *g) {
    (void)unused, (void)g;
    for (int i = 0; i < CARDS; i++)
        if (meets_card(cards[i], r)) return cards[i].paint;
    return floor_or_sky(r);
}

static camera cards_camera(const options *opt) {
    const bool high = shows(opt, "orthographic"); // no ray may start below the floor
    const vec3 eye = {(real)0.4, high ? 4 : (real)1.5, 5}, target = {(real)0.3, (real)0.7, -4};
    camera cam = camera_look_at(eye, target, (vec3){0, 1, 0}, 32, opt->width, opt->height);
    if (high) cam.kind = ORTHOGRAPHIC;
    if (shows(opt, "lens")) cam.kind = THIN_LENS;
    cam.span = 7;
    cam.focus = dot(sub((vec3){0, 0, -4}, eye), cam.forward); // the yellow card
    cam.lens_radius = (real)0.25;
    return cam;
}

// ---- forwards or backwards? ------------------------------------------------------

static image lamp_picture(const options *opt) {
    experiment f, b;
    lamp_experiment(opt, &f, &b);
    experiment_report(&f, &b);
    const bool forward = shows(opt, "forwards");
    image_free(forward ? &b.mean : &f.mean);
    return forward ? f.mean : b.mean;
}

// ---- the program -----------------------------------------------------------------

static image directions(const options *opt) {
    const vec3 eye = {0, 0, 0}, target = {0, 0, -1}, up = {0, 1, 0};
    const camera cam = camera_look_at(eye, target, up, 90, opt->width, opt->height);
    return render("02-camera", &cam, direction, NULL, opt);
}

static image standing_cards(const options *opt) {
    const camera cam = cards_camera(opt);
    return render("02-camera", &cam, cards_on_floor, NULL, opt);
}

static const choice pictures[] = {
    {"directions", "the directions of a pinhole camera's rays as colours"},
    {"pinhole", "cards on a checkered floor through a pinhole"},
    {"orthographic", "the same, all rays parallel"},
    {"lens", "the same through a lens, focused on the yellow card"},
    {"forwards", "a lamp over a floor, light followed from the lamp to the camera"},
    {"backwards", "the same, from the camera to the lamp, with as many rays"},
    {0},
};

int main(int argc, char **argv) {
    const program about = {
        .name = "02-camera",
        .summary = "Draws what a camera's rays see, and light traced forwards and backwards.",
        .uses = USES_SIZE | USES_SAMPLES | USES_SEED | USES_THREADS | USES_PREVIEW,
        .defaults =
            {.width = 480, .height = 300, .samples = 64, .seed = 1, .out = "02-camera.png"},
        .shows = pictures,
    };
    const options opt = options_parse(argc, argv, &about);
    const bool lamp_lit = shows(&opt, "forwards") || shows(&opt, "backwards");
    image img = shows(&opt, "directions") ? directions(&opt)
                : lamp_lit                ? lamp_picture(&opt)
                                          : standing_cards(&opt);
    image_write(&img, opt.out);
    image_free(&img);
}
