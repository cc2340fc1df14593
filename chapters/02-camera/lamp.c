// lamp.c: see lamp.h. The derivations are in README.md.
#include "chapters/02-camera/lamp.h"

#include <stdlib.h>

#include "common/die.h"
#include "common/progress.h"

const lamp demo_lamp = {
    .centre = {(real)0.4, (real)2.5, (real)-0.6}, .side = 1, .radiance = 30};

camera lamp_camera(int width, int height, real lens_radius) {
    const vec3 eye = {(real)-0.6, (real)1.6, (real)3.6}, target = {0, 0, (real)-0.3};
    camera cam = camera_look_at(eye, target, (vec3){0, 1, 0}, 36, width, height);
    cam.kind = THIN_LENS;
    cam.lens_radius = lens_radius;
    cam.focus = length(sub(target, eye));
    return cam;
}

// Squares of half a unit. What the floor reflects of the light, by colour.
static color floor_albedo(vec3 p) {
    const real column = floor(2 * p.x), row = floor(2 * p.z);
    const bool dark = fmod(column + row, 2) != 0;
    return dark ? (color){(real)0.1, (real)0.25, (real)0.2}
                : (color){(real)0.85, (real)0.8, (real)0.7};
}

static vec3 point_of_lamp(const lamp *l, rng *g) {
    const real x = rng_real(g) - (real)0.5;
    const real z = rng_real(g) - (real)0.5;
    return add(l->centre, (vec3){l->side * x, 0, l->side * z});
}

// A random unit vector, upwards with the density cos θ / π: a uniform point of
// the disc, lifted onto the hemisphere.
static vec3 upward_by_cosine(rng *g) {
    real x, z;
    lens_point(g, &x, &z);
    return (vec3){x, sqrt(fmax(1 - x * x - z * z, 0)), z};
}

// ---- backwards -------------------------------------------------------------------

color lamp_backwards(const void *scene, ray r, rng *g) {
    const lamp *l = scene;
    const real t = -r.O.y / r.d.y; // where y = 0
    if (!(t > 0 && isfinite(t))) return (color){0, 0, 0};
    const vec3 p = ray_at(r, t), to_lamp = sub(point_of_lamp(l, g), p);
    const real squared = dot(to_lamp, to_lamp);
    const real cosines = to_lamp.y * to_lamp.y / squared; // of floor and lamp: both horizontal
    const real area = l->side * l->side;
    return scale(l->radiance * area * cosines / ((real)PI * squared), floor_albedo(p));
}

// ---- forwards --------------------------------------------------------------------

// What a ray brings: where it landed, and its share of the light before the
// factors that all rays have in common.
typedef struct {
    int x, y;
    color light;
} landing;

// From the floor's point p along the unit vector s, through the lens to the image.
static bool pass_lens(const camera *cam, vec3 p, vec3 s, landing *where) {
    const real along = dot(s, cam->forward);
    if (!(along < 0)) return false; // moves away from the lens
    const vec3 to_eye = sub(cam->eye, p);
    const real t = dot(to_eye, cam->forward) / along; // to the plane of the lens
    const vec3 q = sub(scale(t, s), to_eye);          // from the eye
    if (!(t > 0 && dot(q, q) < cam->lens_radius * cam->lens_radius)) return false;
    // All rays of a pixel meet in one point of the plane in focus.
    const vec3 sharp = add(q, scale(cam->focus / along, s));
    const real to_pixels = cam->focal / cam->focus;
    const real x = floor((real)cam->width / 2 + to_pixels * dot(sharp, cam->right));
    const real y = floor((real)cam->height / 2 - to_pixels * dot(sharp, cam->up));
    if (!(x >= 0 && x < cam->width && y >= 0 && y < cam->height)) return false;
    const real square = along * along;
    *where = (landing){(int)x, (int)y, scale(1 / (square * square), floor_albedo(p))};
    return true;
}

static bool follow(const camera *cam, const lamp *l, rng *g, landing *where) {
    const vec3 start = point_of_lamp(l, g), d = neg(upward_by_cosine(g));
    if (d.y == 0) return false; // along the lamp: never meets the floor
    vec3 p = ray_at((ray){start, d}, -start.y / d.y);
    p.y = 0;
    const vec3 s = upward_by_cosine(g);
    return pass_lens(cam, p, s, where);
}

// Light in units of 2^-32, whole numbers: their sum is the same in every order in
// which threads may add, a sum of floating point numbers is not.
typedef struct {
    uint64_t red, green, blue;
} tally;

static void add_light(tally *sum, color light) {
    const double unit = 0x1p32;
#pragma omp atomic
    sum->red += (uint64_t)(light.x * unit);
#pragma omp atomic
    sum->green += (uint64_t)(light.y * unit);
#pragma omp atomic
    sum->blue += (uint64_t)(light.z * unit);
}

// The lamp's power is π L A, each ray carries an equal part; area: of the lens.
static image develop(const camera *cam, const lamp *l, const tally *sums, long rays) {
    const image img = image_new(cam->width, cam->height);
    const double power = PI * l->radiance * l->side * l->side;
    const double area = PI * cam->lens_radius * cam->lens_radius;
    const double factor =
        area > 0 ? power / (double)rays * cam->focal * cam->focal / area * 0x1p-32 : 0;
    for (long i = 0; i < (long)cam->width * cam->height; i++)
        img.pixels[i] = (color){(real)(factor * (double)sums[i].red),
                                (real)(factor * (double)sums[i].green),
                                (real)(factor * (double)sums[i].blue)};
    return img;
}

image lamp_forwards(const char *what, const camera *cam, const lamp *l, long rays,
                    uint64_t seed, long *reached) {
    enum { BLOCK = 1 << 16 }; // rays that share a generator: the unit of work
    tally *sums = calloc((size_t)cam->width * (size_t)cam->height, sizeof *sums);
    if (!sums)
        die(EXIT_RUN, "no memory for a picture of %dx%d pixels", cam->width, cam->height);
    progress p = progress_start(what, rays, NULL);
    long landed = 0;
#pragma omp parallel for schedule(dynamic) reduction(+ : landed)
    for (long first = 0; first < rays; first += BLOCK) {
        rng g = rng_sample(seed, (int)(first / BLOCK), 0, 0);
        const long count = rays - first < BLOCK ? rays - first : BLOCK;
        for (long i = 0; i < count; i++) {
            landing where;
            if (!follow(cam, l, &g, &where)) continue;
            add_light(&sums[(long)where.y * cam->width + where.x], where.light);
            landed++;
        }
        progress_add(&p, count);
    }
    progress_end(&p);
    *reached = landed;
    const image img = develop(cam, l, sums, rays);
    free(sums);
    return img;
}
