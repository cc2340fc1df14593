// rasterize.c: see rasterize.h. The derivations are in README.md.
#include "chapters/01-rasterize/rasterize.h"

#include <stdlib.h>

#include "common/die.h"

real focal_length(int height, real fov_degrees) {
    return (real)(height / 2.0 / tan(fov_degrees * PI / 360));
}

raster_point project(projection P, vec3 p) {
    const double depth = -(double)p.z;
    return (raster_point){P.width / 2.0 + (double)P.focal * p.x / depth,
                          P.height / 2.0 - (double)P.focal * p.y / depth, depth};
}

framebuffer framebuffer_new(int width, int height, color background) {
    framebuffer fb = {image_new(width, height), NULL};
    const size_t count = (size_t)width * (size_t)height;
    fb.depth = malloc(count * sizeof *fb.depth);
    if (!fb.depth) die(EXIT_RUN, "no memory for a z-buffer of %d x %d pixels", width, height);
    for (size_t i = 0; i < count; i++) {
        fb.img.pixels[i] = background;
        fb.depth[i] = INFINITY;
    }
    return fb;
}

void framebuffer_free(framebuffer *fb) {
    image_free(&fb->img);
    free(fb->depth);
    fb->depth = NULL;
}

// On the inner side of the edge, or on an edge that the triangle owns.
static bool inside_edge(raster_point a, raster_point b, double x, double y) {
    const double e = edge_function(a, b, x, y);
    return e > 0 || (e == 0 && owns_edge(a, b));
}

// p is counter-clockwise as seen on the screen.
static bool pixel_inside(const raster_point p[3], double x, double y) {
    return inside_edge(p[0], p[1], x, y) && inside_edge(p[1], p[2], x, y) &&
           inside_edge(p[2], p[0], x, y);
}

// The whole number in [0, limit] nearest below x, for any x.
static int clamp_pixel(double x, int limit) {
    return (int)floor(fmin(fmax(x, 0), limit));
}

static void fill(framebuffer *fb, const raster_point p[3], color paint) {
    const int w = fb->img.width, h = fb->img.height;
    const int x0 = clamp_pixel(fmin(p[0].x, fmin(p[1].x, p[2].x)), w);
    const int x1 = clamp_pixel(fmax(p[0].x, fmax(p[1].x, p[2].x)) + 1, w);
    const int y0 = clamp_pixel(fmin(p[0].y, fmin(p[1].y, p[2].y)), h);
    const int y1 = clamp_pixel(fmax(p[0].y, fmax(p[1].y, p[2].y)) + 1, h);
    for (int y = y0; y < y1; y++) {
        for (int x = x0; x < x1; x++) {
            if (!pixel_inside(p, x + 0.5, y + 0.5)) continue;
            const double depth = depth_at(p, x + 0.5, y + 0.5);
            double *nearest = &fb->depth[(size_t)y * (size_t)w + (size_t)x];
            if (!(depth < *nearest)) continue;
            *nearest = depth;
            *image_at(&fb->img, x, y) = paint;
        }
    }
}

bool rasterize(framebuffer *fb, projection P, painted tri) {
    const triangle t = tri.t;
    if (!(t.p1.z < 0 && t.p2.z < 0 && t.p3.z < 0)) return false;
    const raster_point a = project(P, t.p1), b = project(P, t.p2), c = project(P, t.p3);
    const double area = edge_function(a, b, c.x, c.y);
    if (area > 0) fill(fb, (const raster_point[]){a, b, c}, tri.paint);
    if (area < 0) fill(fb, (const raster_point[]){a, c, b}, tri.paint);
    return true;
}
