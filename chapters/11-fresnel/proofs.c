// proofs.c: the caustic and the window, drawn by the path tracer and measured.
#include "chapters/11-fresnel/proofs.h"

#include <stdio.h>

#include "chapters/11-fresnel/claims.h"

// Five standard errors are a false alarm once in two million. Returns 1 when it fails.
static int claim(const char *what, estimate measured, estimate expected) {
    const double z = errors_apart(measured, expected);
    const bool holds = fabs(z) <= 5;
    printf("%-34s %9.5f ± %.5f   expected %9.5f ± %.5f   %s\n", what, measured.value,
           measured.standard_error, expected.value, expected.standard_error,
           holds ? "holds" : "FAILS");
    return !holds;
}

// ---- caustic: three floors under a ball of glass -----------------------------------------

static const double glass_index = 1.5, sun_sine = 0.08, half_width = 0.6;

static color sun_sky(vec3 d) {
    const bool inside = d.y > 0 && hypot(d.x, d.z) < (real)sun_sine;
    return inside ? (color){1, 1, 1} : (color){0, 0, 0};
}

typedef struct {
    glass_room room;
    ball_lens lens;
} floor_job;

static color look_floor(const void *data, ray r, rng *g) {
    const floor_job *j = data;
    const real E = (real)caustic_backwards(&j->room, &j->lens, (double)r.O.x, (double)r.O.z, g);
    return (color){E, E, E};
}

// The floor seen straight from above, from below the ball.
static image draw_floor(const options *opt, const ball_lens *lens) {
    const sphere ball = {{0, 0, 0}, 1};
    const surface none = {.alpha = 0};
    const substance of = {.kind = GLASS, .n = (real)lens->n};
    const scene bodies = {.spheres = &ball, .sphere_count = 1, .sky = sun_sky};
    floor_job j = {{lit(bodies, &none, BY_BRDF), &of, {0}}, *lens};
    const camera cam = {.eye = {0, (real)-lens->depth, 0},
                        .right = {1, 0, 0},
                        .up = {0, 0, -1},
                        .forward = {0, -1, 0},
                        .width = opt->width,
                        .height = opt->height,
                        .kind = ORTHOGRAPHIC,
                        .span = (real)(2 * half_width)};
    const image img = render("11-fresnel", &cam, look_floor, &j, opt);
    lit_free(&j.room.room);
    return img;
}

// Ring by ring against light traced forwards.
static int claim_floor(const image *backwards, const ball_lens *lens, uint64_t seed) {
    enum { PHOTONS = 1000000, RINGS = 5 };
    rng g = rng_seed(seed, 11);
    image forwards = caustic_forwards(lens, half_width, backwards->width, PHOTONS, &g);
    const double step = backwards->width / 2.0 / RINGS;
    int failed = 0;
    for (int i = 0; i < RINGS; i++) {
        char what[80];
        snprintf(what, sizeof what, "floor at %.2f, ring %.2f to %.2f", lens->depth,
                 i * half_width / RINGS, (i + 1) * half_width / RINGS);
        failed += claim(what, ring_mean(backwards, i * step, (i + 1) * step),
                        ring_mean(&forwards, i * step, (i + 1) * step));
    }
    image_free(&forwards);
    return failed;
}

// Beyond the focus f the light near the axis has spread by (depth/f - 1)², and has lost R0
// twice: from what is left of it, f.
static estimate focus_of(const image *floor, const ball_lens *lens) {
    const double R0 = (double)fresnel_dielectric(1, (real)lens->n), T = (1 - R0) * (1 - R0);
    const estimate E = ring_mean(floor, 0, 0.05 / (2 * half_width) * floor->width);
    const double spread = sqrt(T / E.value), f = lens->depth / (1 + spread);
    const double slope = f / (1 + spread) * spread / (2 * E.value); // df/dE
    return (estimate){f, slope * E.standard_error, E.n};
}

int prove_caustic(const options *opt, image floors[FLOORS]) {
    const double f = ball_focus(glass_index), depths[FLOORS] = {0.8 * f, f, 2 * f};
    options part = *opt;
    part.width = part.height = opt->width / FLOORS;
    ball_lens lens = {.n = glass_index, .sun = asin(sun_sine)};
    int failed = 0;
    for (int i = 0; i < FLOORS; i++) {
        lens.depth = depths[i];
        floors[i] = draw_floor(&part, &lens);
        failed += claim_floor(&floors[i], &lens, opt->seed);
    }
    const estimate expected = {f, 0.01 * f, 0}; // the law is for rays near the axis: 1 %
    failed += claim("the focus, from the ball's centre", focus_of(&floors[FLOORS - 1], &lens),
                    expected);
    return failed;
}

// ---- critical: Snell's window --------------------------------------------------------------

static const double water_index = 1.33, eye_depth = 1.7,
                    seen = 2; // half the height at the surface

// Green is 1 everywhere, so that it can be measured; red at the horizon, blue above.
static color evening_sky(vec3 d) {
    if (d.y <= 0) return (color){0, 0, 0};
    const real height = d.y / length(d);
    return (color){(real)1.6 - (real)1.3 * height, 1, (real)0.5 + (real)1.1 * height};
}

typedef struct {
    glass_room room;
    int s;
} water_job;

static color look_up(const void *data, ray r, rng *g) {
    const water_job *j = data;
    return glass_trace(&j->room, r, j->s, g);
}

// From eye_depth below the surface y = 0, straight up. The water is all that lies behind the
// plane, and black below.
static image draw_window(const options *opt) {
    const plane top = {{0, 0, 0}, {0, 1, 0}};
    const surface none = {.alpha = 0};
    const substance of = {.kind = GLASS, .n = (real)water_index};
    const scene bodies = {.planes = &top, .plane_count = 1, .sky = evening_sky};
    water_job j = {{lit(bodies, &none, BY_BRDF), &of, {1, {0}}}, opt->depth};
    const vec3 eye = {0, (real)-eye_depth, 0}, above = {0, 0, 0}, up = {0, 0, 1};
    const real fov = (real)(atan(seen / eye_depth) * 360 / PI);
    const camera cam = camera_look_at(eye, above, up, fov, opt->width, opt->height);
    const image img = render("11-fresnel", &cam, look_up, &j, opt);
    lit_free(&j.room.room);
    return img;
}

// The same without a ray, each pixel's mean over 16 x 16 points.
static image expected_window(int width, int height) {
    enum { POINTS = 16 };
    image img = image_new(width, height);
    const double pixel = 2 * seen / height;
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++) {
            double sum = 0;
            for (int k = 0; k < POINTS * POINTS; k++) {
                const double u = (x - width / 2.0 + (k % POINTS + 0.5) / POINTS) * pixel,
                             v = (y - height / 2.0 + ((double)(k / POINTS) + 0.5) / POINTS) *
                                 pixel;
                const double away = sqrt(u * u + v * v + eye_depth * eye_depth);
                sum += window_light(water_index, eye_depth / away);
            }
            const real L = (real)(sum / (POINTS * POINTS));
            *image_at(&img, x, y) = (color){L, L, L};
        }
    return img;
}

// The largest distance of a lit pixel's centre from the middle, on the surface.
static double outermost_light(const image *img) {
    double most = 0;
    for (int y = 0; y < img->height; y++)
        for (int x = 0; x < img->width; x++)
            if (image_at(img, x, y)->y > 0)
                most =
                    fmax(most, hypot(x + 0.5 - img->width / 2.0, y + 0.5 - img->height / 2.0));
    return most * 2 * seen / img->height;
}

int prove_window(const options *opt, image *window) {
    const image img = draw_window(opt);
    image expected = expected_window(opt->width, opt->height);
    const double pixel = 2 * seen / opt->height;
    const double radius = window_radius(water_index, eye_depth), rim = radius / pixel;
    int failed = claim("all light in the picture", ring_mean(&img, 0, opt->width),
                       ring_mean(&expected, 0, opt->width));
    failed += claim("along the window's rim", ring_mean(&img, 0.9 * rim, rim + 1),
                    ring_mean(&expected, 0.9 * rim, rim + 1));
    failed += claim("straight up: n²(1 - R0)", ring_mean(&img, 0, 0.1 * rim),
                    (estimate){window_light(water_index, 1), 0, 1});
    const double found = outermost_light(&img);
    const bool holds = fabs(found - radius) < pixel;
    printf("the window's radius: %.4f, expected %.4f within a pixel of %.4f: %s\n", found,
           radius, pixel, holds ? "holds" : "FAILS");
    image_free(&expected);
    *window = img;
    return failed + !holds;
}
