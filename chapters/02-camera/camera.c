// camera.c: see camera.h. The derivations are in README.md.
#include "chapters/02-camera/camera.h"

#include <stdio.h>

#include "chapters/01-rasterize/rasterize.h"
#include "common/die.h"
#include "common/progress.h"
#include "common/wide3.h"

// From eye to target, of unit length; the largest component is divided out first,
// so that no square overflows or vanishes.
static wide3 direction_of_view(vec3 eye, vec3 target) {
    const wide3 v = wide_sub(target, eye);
    const double size = fmax(fabs(v.x), fmax(fabs(v.y), fabs(v.z)));
    if (!is_finite(eye) || !is_finite(target) || !isfinite(size))
        die(EXIT_RUN, "camera: eye or target is not finite");
    if (size == 0) die(EXIT_RUN, "camera: eye and target are the same point");
    const wide3 w = {v.x / size, v.y / size, v.z / size};
    const double length_of_w = sqrt(wide_dot(w, w));
    return (wide3){w.x / length_of_w, w.y / length_of_w, w.z / length_of_w};
}

static real focal_in_pixels(real fov_degrees, int height) {
    const real focal = focal_length(height, fov_degrees);
    if (!(fov_degrees > 0 && fov_degrees < 180 && isfinite(focal)))
        die(EXIT_RUN, "camera: a field of view of %g degrees: expected above 0 and below 180",
            (double)fov_degrees);
    return focal;
}

camera camera_look_at(vec3 eye, vec3 target, vec3 up, real fov_degrees, int width, int height) {
    const vec3 forward = narrow(direction_of_view(eye, target));
    const vec3 right = camera_right(forward, up);
    return (camera){.eye = eye,
                    .right = right,
                    .up = narrow(wide_cross(widen(right), widen(forward))),
                    .forward = forward,
                    .width = width,
                    .height = height,
                    .focal = focal_in_pixels(fov_degrees, height)};
}

camera camera_across(vec3 eye, vec3 target, real half_width, int width, int height) {
    const real slope = half_width / length(sub(target, eye)) * (real)height / (real)width;
    const real fov = (real)(atan(slope) * 360 / PI);
    return camera_look_at(eye, target, (vec3){0, 1, 0}, fov, width, height);
}

// By rejection: a point of the square around the disc, until one lies in it.
void lens_point(rng *g, real *u, real *v) {
    real a, b;
    do {
        a = 2 * rng_real(g) - 1;
        b = 2 * rng_real(g) - 1;
    } while (a * a + b * b > 1);
    *u = a, *v = b;
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
        fprintf(stderr, "warning: %s: %ld of %ld samples are negative or not finite\n", what,
                wrong, p.total);
    return img;
}
