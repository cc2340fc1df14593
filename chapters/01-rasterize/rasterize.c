// rasterize.c: see rasterize.h. The derivations are in README.md.
#include "chapters/01-rasterize/rasterize.h"

#include <stdlib.h>

#include "common/die.h"

enum { BAND = 32 }; // rows that one thread draws at a time

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

// ---- which pixels ------------------------------------------------------------

// On the inner side of the edge, or on an edge that the triangle owns. The two
// triangles that share an edge walk it in opposite directions; worked out from
// the same end, it rounds in the same way for both, and no pixel falls between.
static bool inside_edge(raster_point a, raster_point b, double x, double y) {
    const bool turn = a.y > b.y || (a.y == b.y && a.x > b.x);
    const double e = turn ? -edge_function(b, a, x, y) : edge_function(a, b, x, y);
    return e > 0 || (e == 0 && owns_edge(a, b));
}

// p is counter-clockwise as seen on the screen.
static bool pixel_inside(const raster_point p[3], double x, double y) {
    return inside_edge(p[0], p[1], x, y) && inside_edge(p[1], p[2], x, y) &&
           inside_edge(p[2], p[0], x, y);
}

typedef struct {
    int x0, x1, y0, y1; // x0 <= x < x1, y0 <= y < y1
} pixel_box;

// The whole number below x, kept within [least, most]: for any x, also 1e30 and NaN.
static int pixel_floor(double x, int least, int most) {
    return (int)floor(fmin(fmax(x, least), most));
}

// The pixels of `within` that the three corners can reach.
static pixel_box box_around(const raster_point p[3], pixel_box within) {
    const double left = fmin(p[0].x, fmin(p[1].x, p[2].x));
    const double right = fmax(p[0].x, fmax(p[1].x, p[2].x));
    const double top = fmin(p[0].y, fmin(p[1].y, p[2].y));
    const double bottom = fmax(p[0].y, fmax(p[1].y, p[2].y));
    return (pixel_box){.x0 = pixel_floor(left, within.x0, within.x1),
                       .x1 = pixel_floor(right + 1, within.x0, within.x1),
                       .y0 = pixel_floor(top, within.y0, within.y1),
                       .y1 = pixel_floor(bottom + 1, within.y0, within.y1)};
}

// ---- drawing -------------------------------------------------------------------

// The z-buffer: the pixel belongs to the nearest triangle so far.
static void draw_pixel(framebuffer *fb, const raster_point p[3], int x, int y, color paint) {
    const double depth = depth_at(p, x + 0.5, y + 0.5);
    double *nearest = &fb->depth[(size_t)y * (size_t)fb->img.width + (size_t)x];
    if (!(depth < *nearest)) return;
    *nearest = depth;
    *image_at(&fb->img, x, y) = paint;
}

static void fill(framebuffer *fb, pixel_box within, const raster_point p[3], color paint) {
    const pixel_box box = box_around(p, within);
    for (int y = box.y0; y < box.y1; y++)
        for (int x = box.x0; x < box.x1; x++)
            if (pixel_inside(p, x + 0.5, y + 0.5)) draw_pixel(fb, p, x, y, paint);
}

static bool in_front(triangle t) {
    return t.p1.z < 0 && t.p2.z < 0 && t.p3.z < 0;
}

static void rasterize_within(framebuffer *fb, pixel_box within, projection P, painted tri) {
    const raster_point a = project(P, tri.t.p1), b = project(P, tri.t.p2),
                       c = project(P, tri.t.p3);
    const double area = edge_function(a, b, c.x, c.y);
    if (area > 0) fill(fb, within, (const raster_point[]){a, b, c}, tri.paint);
    if (area < 0) fill(fb, within, (const raster_point[]){a, c, b}, tri.paint);
}

bool rasterize(framebuffer *fb, projection P, painted tri) {
    if (!in_front(tri.t)) return false;
    rasterize_within(fb, (pixel_box){0, fb->img.width, 0, fb->img.height}, P, tri);
    return true;
}

int rasterize_all(framebuffer *fb, projection P, const painted *triangles, int count) {
    const int w = fb->img.width, h = fb->img.height;
    int refused = 0;
    for (int i = 0; i < count; i++) refused += !in_front(triangles[i].t);
#pragma omp parallel for schedule(dynamic)
    for (int y = 0; y < h; y += BAND) {
        const pixel_box band = {0, w, y, y + BAND < h ? y + BAND : h};
        for (int i = 0; i < count; i++)
            if (in_front(triangles[i].t)) rasterize_within(fb, band, P, triangles[i]);
    }
    return refused;
}
