// main.c: raytracer NAME OUT.pfm SEED [SAMPLES [BOUNCES]] draws one of four pictures:
// depth and normal of scene 1, the mirrors of scene 2, the box of scene 3.
#include <stdlib.h>
#include <string.h>

#include "common/die.h"
#include "solutions/homework/raytracer.h"

static color depth(const scene *sc, ray r, int bounces, rng *g) {
    (void)bounces, (void)g;
    const hit h = nearest(sc, r, 0, FAR);
    return h.b ? (color){h.t, h.t, h.t} : (color){0, 0, 0};
}

static color normal(const scene *sc, ray r, int bounces, rng *g) {
    (void)bounces, (void)g;
    const hit h = nearest(sc, r, 0, FAR);
    return h.b ? h.n : (color){0, 0, 0};
}

static const struct {
    const char *name;
    look look;
    const scene *scene;
    bool centre; // one ray through the pixel's centre, else many through all of it
} pictures[] = {
    {"depth", depth, &shapes_scene, true},
    {"normal", normal, &shapes_scene, true},
    {"mirror", mirror_light, &mirror_scene, true},
    {"path", path_light, &box_scene, false},
};

typedef struct {
    int picture, samples, bounces;
    uint64_t seed;
} job;

static color pixel(const job *j, int x, int y) {
    const scene *sc = pictures[j->picture].scene;
    color sum = {0, 0, 0};
    for (int i = 0; i < j->samples; i++) {
        rng g = rng_sample(j->seed, x, y, i);
        const real u = j->samples == 1 ? (real)0.5 : rng_real(&g);
        const real v = j->samples == 1 ? (real)0.5 : rng_real(&g);
        const ray r = camera_ray(sc, (real)x + u, (real)y + v);
        sum = add(sum, pictures[j->picture].look(sc, r, j->bounces, &g));
    }
    return scale(1 / (real)j->samples, sum);
}

static job read_job(int argc, char **argv) {
    if (argc < 4) die(EXIT_USAGE, "usage: raytracer NAME OUT.pfm SEED [SAMPLES [BOUNCES]]");
    job j = {.seed = strtoull(argv[3], NULL, 10), .samples = SAMPLES, .bounces = BOUNCES};
    if (argc > 4) j.samples = atoi(argv[4]);
    if (argc > 5) j.bounces = atoi(argv[5]);
    while (j.picture < COUNT(pictures) && strcmp(argv[1], pictures[j.picture].name) != 0)
        j.picture++;
    if (j.picture == COUNT(pictures)) die(EXIT_USAGE, "no picture is called %s", argv[1]);
    if (pictures[j.picture].centre) j.samples = 1;
    return j;
}

int main(int argc, char **argv) {
    const job j = read_job(argc, argv);
    image img = image_new(WIDTH, HEIGHT);
#pragma omp parallel for schedule(dynamic)
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) *image_at(&img, x, y) = pixel(&j, x, y);
    image_write(&img, argv[2]);
    image_free(&img);
}
