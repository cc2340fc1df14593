// 01-rasterize: triangles projected and filled in, and what the picture shows
// without the z-buffer, with a wrong depth, and without the fill rule.
#include "chapters/01-rasterize/rasterize.h"

#include <stdlib.h>

#include "common/die.h"
#include "common/options.h"

static size_t pixel_count(const framebuffer *fb) {
    return (size_t)fb->img.width * (size_t)fb->img.height;
}

static bool is_drawn(const framebuffer *fb, size_t pixel) {
    return fb->depth[pixel] < (double)INFINITY;
}

static void forget_depth(framebuffer *fb) {
    for (size_t i = 0; i < pixel_count(fb); i++) fb->depth[i] = (double)INFINITY;
}

static void draw_scene(framebuffer *fb, projection P) {
    const int refused = rasterize_all(fb, P, demo_triangles, demo_triangle_count);
    if (refused > 0) die(EXIT_RUN, "%d triangles reach behind the eye", refused);
}

// ---- without a z-buffer: the last one drawn stays -----------------------------------

static void draw_over(framebuffer *fb, projection P, const painted *triangles) {
    for (int i = 0; i < demo_triangle_count; i++) {
        forget_depth(fb);
        rasterize(fb, P, triangles[i]);
    }
}

static void draw_as_listed(framebuffer *fb, projection P) {
    draw_over(fb, P, demo_triangles);
}

static int farther_first(const void *left, const void *right) {
    const triangle a = ((const painted *)left)->t, b = ((const painted *)right)->t;
    const real za = a.p1.z + a.p2.z + a.p3.z, zb = b.p1.z + b.p2.z + b.p3.z;
    return (za > zb) - (za < zb);
}

// The painter's algorithm: far triangles first, by the depth of their middle.
static void draw_far_to_near(framebuffer *fb, projection P) {
    const size_t count = (size_t)demo_triangle_count;
    painted *sorted = malloc(count * sizeof *sorted);
    if (!sorted) die(EXIT_RUN, "no memory for %d triangles", demo_triangle_count);
    for (size_t i = 0; i < count; i++) sorted[i] = demo_triangles[i];
    qsort(sorted, count, sizeof *sorted, farther_first);
    draw_over(fb, P, sorted);
    free(sorted);
}

// ---- contours of depth -----------------------------------------------------------------

// Every other quarter of a unit is darker, as on a map.
static void draw_contours(framebuffer *fb) {
    for (size_t i = 0; i < pixel_count(fb); i++)
        if (is_drawn(fb, i) && (long)floor(4 * fb->depth[i]) % 2 == 0)
            fb->img.pixels[i] = scale((real)0.6, fb->img.pixels[i]);
}

static void draw_depth(framebuffer *fb, projection P) {
    draw_scene(fb, P);
    draw_contours(fb);
}

// The mistake: depth itself interpolated, as if it were linear on the screen.
static double linear_depth(const raster_point p[3], double x, double y) {
    const double w0 = edge_function(p[1], p[2], x, y);
    const double w1 = edge_function(p[2], p[0], x, y);
    const double w2 = edge_function(p[0], p[1], x, y);
    return (w0 * p[0].depth + w1 * p[1].depth + w2 * p[2].depth) / (w0 + w1 + w2);
}

// The pixels of one triangle, which `mask` finds, each with the wrong depth.
static void draw_linear(framebuffer *fb, framebuffer *mask, projection P, painted tri) {
    const raster_point p[] = {project(P, tri.t.p1), project(P, tri.t.p2), project(P, tri.t.p3)};
    const size_t width = (size_t)P.width;
    forget_depth(mask);
    rasterize(mask, P, tri);
    for (size_t i = 0; i < pixel_count(fb); i++) {
        if (!is_drawn(mask, i)) continue;
        const double depth =
            linear_depth(p, (double)(i % width) + 0.5, (double)(i / width) + 0.5);
        if (!(depth < fb->depth[i])) continue;
        fb->depth[i] = depth;
        fb->img.pixels[i] = tri.paint;
    }
}

static void draw_linear_depth(framebuffer *fb, projection P) {
    framebuffer mask = framebuffer_new(P.width, P.height, demo_background);
    for (int i = 0; i < demo_triangle_count; i++) draw_linear(fb, &mask, P, demo_triangles[i]);
    framebuffer_free(&mask);
    draw_contours(fb);
}

// ---- who owns a pixel on an edge? ---------------------------------------------------------

// A fan of triangles around the centre of a pixel. The rim, in pixels, is made of
// centres too, and many more lie exactly on an edge.
enum { ZOOM = 20, SPOKES = 8 }; // a pixel is drawn as a square of 20 x 20
static const vec3 rim[SPOKES] = {
    {9, 0, 0},  {8, 4, 0},   {0, 6, 0},  {-6, 6, 0},
    {-8, 0, 0}, {-6, -3, 0}, {0, -5, 0}, {5, -5, 0},
};

// With P.focal = 1 and depth 1 a unit is a pixel, exactly.
static painted spoke(projection P, int i) {
    const vec3 centre = {P.width % 2 ? 0 : (real)0.5, P.height % 2 ? 0 : (real)0.5, -1};
    const color paint = i % 2 ? (color){(real)0.08, (real)0.3, (real)0.45}
                              : (color){(real)0.15, (real)0.5, (real)0.3};
    return (painted){
        {centre, add(centre, rim[i]), add(centre, rim[(i + 1) % SPOKES])},
        paint,
    };
}

// The mistake: every triangle takes all pixels on its edges.
static void take_all_edges(framebuffer *mask, projection P, triangle t) {
    const raster_point p[] = {project(P, t.p1), project(P, t.p2), project(P, t.p3)};
    for (size_t i = 0; i < pixel_count(mask); i++) {
        const double x = (double)(i % (size_t)P.width) + 0.5;
        const double y = (double)(i / (size_t)P.width) + 0.5;
        if (edge_function(p[0], p[1], x, y) >= 0 && edge_function(p[1], p[2], x, y) >= 0 &&
            edge_function(p[2], p[0], x, y) >= 0)
            mask->depth[i] = 1;
    }
}

// Draws the fan on a screen of few pixels; those drawn twice become orange, more
// often white.
static void draw_small_fan(framebuffer *small, projection P, bool rule) {
    framebuffer mask = framebuffer_new(P.width, P.height, demo_background);
    for (int i = 0; i < SPOKES; i++) {
        const painted tri = spoke(P, i);
        forget_depth(&mask);
        if (rule)
            rasterize(&mask, P, tri);
        else
            take_all_edges(&mask, P, tri.t);
        for (size_t k = 0; k < pixel_count(small); k++) {
            if (!is_drawn(&mask, k)) continue;
            const color again =
                small->depth[k] == 1 ? (color){1, (real)0.4, 0} : (color){1, 1, 1};
            small->img.pixels[k] = is_drawn(small, k) ? again : tri.paint;
            small->depth[k] = is_drawn(small, k) ? small->depth[k] + 1 : 1;
        }
    }
    framebuffer_free(&mask);
}

// Does an edge of the fan pass within 0.05 pixels of (x, y)?
static bool near_edge(projection P, double x, double y) {
    for (int i = 0; i < SPOKES; i++) {
        const triangle t = spoke(P, i).t;
        const raster_point p[] = {project(P, t.p1), project(P, t.p2), project(P, t.p3)};
        for (int k = 0; k < 2; k++) {
            const raster_point a = p[k], b = p[k + 1];
            const double dx = b.x - a.x, dy = b.y - a.y, length2 = dx * dx + dy * dy;
            const double along = fmin(fmax(((x - a.x) * dx + (y - a.y) * dy) / length2, 0), 1);
            if (hypot(x - a.x - along * dx, y - a.y - along * dy) < 0.05) return true;
        }
    }
    return false;
}

static void draw_fan(framebuffer *fb, bool rule) {
    const projection P = {1 + (fb->img.width - 1) / ZOOM, 1 + (fb->img.height - 1) / ZOOM, 1};
    framebuffer small = framebuffer_new(P.width, P.height, demo_background);
    draw_small_fan(&small, P, rule);
    for (int y = 0; y < fb->img.height; y++)
        for (int x = 0; x < fb->img.width; x++) {
            const bool grid = x % ZOOM == 0 || y % ZOOM == 0;
            const bool edge = near_edge(P, (x + 0.5) / ZOOM, (y + 0.5) / ZOOM);
            const color c = *image_at(&small.img, x / ZOOM, y / ZOOM);
            *image_at(&fb->img, x, y) =
                edge ? (color){0, 0, 0} : scale(grid ? (real)0.8 : 1, c);
        }
    framebuffer_free(&small);
}

static void draw_owned(framebuffer *fb, projection P) {
    (void)P;
    draw_fan(fb, true);
}

static void draw_all_edges(framebuffer *fb, projection P) {
    (void)P;
    draw_fan(fb, false);
}

// ---- the program -------------------------------------------------------------------------

static const choice pictures[] = {
    {"scene", "the triangles, the nearest in every pixel"},
    {"listed", "the mistake: no z-buffer, the last one drawn stays"},
    {"painter", "no z-buffer either, but far triangles are drawn first"},
    {"depth", "contours of equal depth, a quarter of a unit apart"},
    {"linear", "the mistake: depth taken as linear on the screen"},
    {"owned", "a fan of triangles on few pixels; each pixel has one owner"},
    {"edges", "the mistake: all own their edges; orange: drawn twice, white: more"},
    {0},
};

static void (*const draw[])(framebuffer *fb, projection P) = {
    draw_scene,        draw_as_listed, draw_far_to_near, draw_depth,
    draw_linear_depth, draw_owned,     draw_all_edges,
};

int main(int argc, char **argv) {
    const program about = {
        .name = "01-rasterize",
        .summary = "Draws triangles by filling the pixels that they cover.",
        .uses = USES_SIZE | USES_THREADS,
        .defaults = {.width = 640, .height = 400, .out = "01-rasterize.png"},
        .shows = pictures,
    };
    const options opt = options_parse(argc, argv, &about);
    const projection P = {opt.width, opt.height, focal_length(opt.height, DEMO_FOV)};
    framebuffer fb = framebuffer_new(opt.width, opt.height, demo_background);
    for (int i = 0; pictures[i].name; i++)
        if (shows(&opt, pictures[i].name)) draw[i](&fb, P);
    image_write(&fb.img, opt.out);
    framebuffer_free(&fb);
}
