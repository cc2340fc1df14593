// 02-camera: the directions of a camera's rays as colours; the same scene through
// a pinhole, a lens and no perspective at all; and light traced from the lamp to
// the camera beside light traced from the camera to the lamp.
#include <stdio.h>

#include "chapters/02-camera/lamp.h"
#include "common/measure.h"

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

static const card cards[CARDS] = { // the nearest first: they stand along -z
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
    return dark ? (color){(real)0.25, (real)0.25, (real)0.3} : (color){(real)0.9, (real)0.9, (real)0.85};
}

static color cards_on_floor(const void *unused, ray r, rng *g) {
    (void)unused, (void)g;
    for (int i = 0; i < CARDS; i++)
        if (meets_card(cards[i], r)) return cards[i].paint;
    return floor_or_sky(r);
}

static camera cards_camera(const options *opt) {
    const vec3 eye = {(real)0.4, (real)1.5, 5}, target = {(real)0.3, (real)0.7, -4};
    camera cam = camera_look_at(eye, target, (vec3){0, 1, 0}, 32, opt->width, opt->height);
    if (shows(opt, "orthographic")) cam.kind = ORTHOGRAPHIC;
    if (shows(opt, "lens")) cam.kind = THIN_LENS;
    cam.span = 5;
    cam.focus = dot(sub((vec3){0, 0, -4}, eye), cam.forward); // the yellow card
    cam.lens_radius = (real)0.25;
    return cam;
}

// ---- forwards or backwards? ------------------------------------------------------

#define LENS_RADIUS ((real)0.05) // the camera's, if a unit is a metre: 5 cm
#define SMALL_LENS 0.001         // 1 mm

// Each half of the rays makes a picture of its own, with its own seed. Their mean
// is the result; their difference shows how large its noise is.
typedef struct {
    image mean;
    double variance; // of a pixel's value in `mean`; the mean over pixels and colours
    double rays_per_second;
    long rays, reached;
} experiment;

static double half_of_difference_squared(color a, color b) {
    const vec3 d = scale((real)0.5, sub(a, b));
    return (double)dot(d, d) / 3;
}

static experiment combine(image a, image b, long rays, long reached, double seconds) {
    experiment e = {.rays = rays, .reached = reached, .rays_per_second = (double)rays / seconds};
    const long pixels = (long)a.width * a.height;
    for (long i = 0; i < pixels; i++) {
        e.variance += half_of_difference_squared(a.pixels[i], b.pixels[i]) / (double)pixels;
        a.pixels[i] = lerp(a.pixels[i], b.pixels[i], (real)0.5);
    }
    image_free(&b);
    e.mean = a;
    return e;
}

static experiment forwards(const camera *cam, const options *opt) {
    const long half = (long)cam->width * cam->height * opt->samples / 2;
    long first, second;
    const double start = clock_seconds();
    const image a = lamp_forwards("forwards", cam, &demo_lamp, half, opt->seed, &first);
    const image b = lamp_forwards("forwards", cam, &demo_lamp, half, opt->seed + 1, &second);
    return combine(a, b, 2 * half, first + second, clock_seconds() - start);
}

static experiment backwards(const camera *cam, const options *opt) {
    options half = *opt, other;
    half.samples = opt->samples / 2;
    other = half;
    other.seed = opt->seed + 1;
    const long rays = 2L * cam->width * cam->height * half.samples;
    const double start = clock_seconds();
    const image a = render("backwards", cam, lamp_backwards, &demo_lamp, &half);
    const image b = render("backwards", cam, lamp_backwards, &demo_lamp, &other);
    return combine(a, b, rays, rays, clock_seconds() - start);
}

static void print_time(double seconds) {
    static const struct {
        const char *name;
        double seconds;
    } units[] = {{"years", 365.25 * 86400}, {"days", 86400}, {"hours", 3600}, {"minutes", 60}};
    for (int i = 0; i < COUNT(units); i++)
        if (seconds >= 2 * units[i].seconds) {
            printf("%.3g %s", seconds / units[i].seconds, units[i].name);
            return;
        }
    printf("%.3g seconds", seconds);
}

static void report(const experiment *f, const experiment *b) {
    printf("forwards:  of %ld rays, %ld reached the camera", f->rays, f->reached);
    if (f->reached > 0) printf(" (1 in %ld)", f->rays / f->reached);
    printf("\nbackwards: of %ld rays, all began there\n", b->rays);
    if (!(f->variance > 0 && b->variance > 0)) return;
    const double ratio = f->variance / b->variance;
    const double seconds = ratio * (double)f->rays / f->rays_per_second;
    const double by_area = LENS_RADIUS / SMALL_LENS * LENS_RADIUS / SMALL_LENS;
    printf("noise of a pixel (standard error): forwards %.3g, backwards %.3g\n",
           sqrt(f->variance), sqrt(b->variance));
    printf("as little noise forwards: %.2g times as many rays, here about ", ratio);
    print_time(seconds);
    printf("\nthrough a hole of 1 mm radius: about ");
    print_time(by_area * seconds);
    printf("; through a true pinhole, without area: never\n");
}

static image lamp_experiment(const options *opt) {
    const camera cam = lamp_camera(opt->width, opt->height, LENS_RADIUS);
    options even = *opt; // two halves
    even.samples += even.samples % 2;
    experiment f = forwards(&cam, &even), b = backwards(&cam, &even);
    report(&f, &b);
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
                : lamp_lit                ? lamp_experiment(&opt)
                                          : standing_cards(&opt);
    image_write(&img, opt.out);
    image_free(&img);
}
