// camera.c: see camera.h. The derivations are in README.md.
#include "chapters/02-camera/camera.h"

#include <stdio.h>
#include <stdlib.h>

#include "common/die.h"
#include "common/progress.h"

camera camera_look_at(vec3 eye, vec3 target, vec3 up, real fov_degrees, int width, int height) {
    const vec3 view = sub(target, eye);
    if (!(dot(view, view) > 0)) die(EXIT_RUN, "camera: eye and target are the same point");
    if (!(fov_degrees > 0 && fov_degrees < 180))
        die(EXIT_RUN, "camera: field of view %g is not between 0 and 180 degrees",
            (double)fov_degrees);
    const vec3 forward = normalize(view);
    const vec3 right = camera_right(forward, up);
    return (camera){.eye = eye,
                    .right = right,
                    .up = cross(right, forward),
                    .forward = forward,
                    .width = width,
                    .height = height,
                    .focal = (real)(height / 2.0 / tan(fov_degrees * PI / 360))};
}

// A uniform point of the unit disc, by rejection.
static void lens_point(rng *g, real *u, real *v) {
    do {
        *u = 2 * rng_real(g) - 1;
        *v = 2 * rng_real(g) - 1;
    } while (*u * *u + *v * *v > 1);
}

ray camera_sample(const camera *cam, real x, real y, rng *g) {
    if (cam->kind == ORTHOGRAPHIC) return orthographic_ray(cam, x, y);
    if (cam->kind == PINHOLE) return camera_ray(cam, x, y);
    real u, v;
    lens_point(g, &u, &v);
    return thin_lens_ray(cam, x, y, u, v);
}

// One sample of the pixel (x, y), and the only place where light enters a picture.
static color sample_pixel(const camera *cam, radiance f, const void *scene, const options *opt,
                          int x, int y, int sample) {
    rng g = rng_sample(opt->seed, x, y, sample);
    real dx = (real)0.5, dy = (real)0.5;
    if (opt->samples > 1) {
        dx = rng_real(&g);
        dy = rng_real(&g);
    }
    const ray r = camera_sample(cam, x + dx, y + dy, &g);
    return f(scene, r, &g);
}

static bool is_light(color c) {
    return is_finite(c) && c.x >= 0 && c.y >= 0 && c.z >= 0;
}

// Summed in double: a float sum of a million samples would lose the last digits.
static color pixel_mean(const camera *cam, radiance f, const void *scene, const options *opt,
                        int x, int y, long *wrong) {
    double red = 0, green = 0, blue = 0;
    for (int s = 0; s < opt->samples; s++) {
        const color c = sample_pixel(cam, f, scene, opt, x, y, s);
        *wrong += !is_light(c);
        red += c.x;
        green += c.y;
        blue += c.z;
    }
    const int n = opt->samples;
    return (color){(real)(red / n), (real)(green / n), (real)(blue / n)};
}

image render(const char *what, const camera *cam, radiance f, const void *scene,
             const options *opt) {
    image img = image_new(cam->width, cam->height);
    progress p = progress_start(what, (long)cam->width * cam->height * opt->samples,
                                opt->preview ? &img : NULL);
    long wrong = 0;
#pragma omp parallel for schedule(dynamic) reduction(+ : wrong)
    for (int y = 0; y < cam->height; y++) {
        for (int x = 0; x < cam->width; x++) {
            *image_at(&img, x, y) = pixel_mean(cam, f, scene, opt, x, y, &wrong);
        }
        progress_row(&p, y, (long)cam->width * opt->samples);
    }
    progress_end(&p);
    if (wrong > 0)
        fprintf(stderr, "warning: %s: %ld samples are negative or not finite\n", what, wrong);
    return img;
}
