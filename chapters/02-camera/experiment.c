// experiment.c: see experiment.h.
// Each half of the rays makes a picture of its own, with its own seed. Their mean
// is the result; their difference shows how large its noise is.
#include "chapters/02-camera/experiment.h"

#include <stdio.h>

#include "common/measure.h"

static double half_of_difference_squared(color a, color b) {
    const vec3 d = scale((real)0.5, sub(a, b));
    return (double)dot(d, d) / 3;
}

static experiment combine(image a, image b, long rays, long reached, double seconds) {
    experiment e = {
        .rays = rays, .reached = reached, .rays_per_second = (double)rays / seconds};
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

void experiment_report(const experiment *f, const experiment *b) {
    printf("forwards:  of %ld rays, %ld reached the camera", f->rays, f->reached);
    if (f->reached > 0) printf(" (1 in %ld)", f->rays / f->reached);
    printf("\nbackwards: of %ld rays, all began at the camera\n", b->rays);
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

void lamp_experiment(const options *opt, experiment *f, experiment *b) {
    const camera cam = lamp_camera(opt->width, opt->height, LENS_RADIUS);
    options even = *opt; // two halves
    even.samples += even.samples % 2;
    *f = forwards(&cam, &even);
    *b = backwards(&cam, &even);
}
