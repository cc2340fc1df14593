// rasterize.h: triangles are projected onto the image plane and the covered
// pixels are filled in, the nearest triangle winning (z-buffer).
#ifndef CHAPTER_RASTERIZE_H
#define CHAPTER_RASTERIZE_H

#include "common/image.h"

// Corners; seen counter-clockwise from the outside. The lecture's p1, p2, p3.
typedef struct {
    vec3 p1, p2, p3;
} triangle;

typedef struct {
    triangle t;
    color paint;
} painted;

// The eye in the origin looks along -z; x is to the right, y up. The image
// plane lies `focal` pixels before the eye.
typedef struct {
    int width, height; // pixels
    real focal;        // pixels
} projection;

// A point of the picture: x, y in pixels from the top left corner, y down, so
// the centre of the first pixel is (0.5, 0.5). depth = -z > 0. In double: a
// float's last bit already decides whether a pixel on an edge is covered.
typedef struct {
    double x, y, depth;
} raster_point;

// Colour and z-buffer.
typedef struct {
    image img;
    double *depth; // INFINITY where nothing was drawn
} framebuffer;

// (height / 2) / tan(fov / 2), for a vertical field of view of 0 < degrees < 180.
real focal_length(int height, real fov_degrees);

// x = w/2 + f X/(-Z), y = h/2 - f Y/(-Z). Needs p in front of the eye: p.z < 0.
raster_point project(projection P, vec3 p);

framebuffer framebuffer_new(int width, int height, color background);
void framebuffer_free(framebuffer *fb);

// Fills the pixels whose centre the triangle covers and where it is nearest; of
// two equally near the first drawn stays. Either orientation is filled. Zero
// area fills nothing. Returns false, and draws nothing, when a corner lies at
// or behind the eye's plane: that would need clipping, which no scene of this
// chapter requires.
bool rasterize(framebuffer *fb, projection P, painted tri);

// rasterize() for `count` triangles, in order. Bands of rows are shared out among
// the cores; each pixel belongs to one band, so the picture is the same for any
// number of threads. Returns how many triangles were refused.
int rasterize_all(framebuffer *fb, projection P, const painted *triangles, int count);

// The scene that 05-triangle traces: in generic positions, some piercing
// each other, all in front of the eye. The paint includes the light (scene.c).
extern const painted demo_triangles[];
extern const int demo_triangle_count;
extern const color demo_background;
#define DEMO_FOV 50 // degrees, vertical

// Exercises: exercises/01-rasterize/ ---------------------------------------

// Twice the signed area of the triangle a, b, (x, y): zero on the line through
// a and b, positive on the side that is to the left when walking from a to b on
// the screen as you see it (y down!). Pineda 1988.
double edge_function(raster_point a, raster_point b, double x, double y);

// The fill rule: does a pixel centre that lies exactly on the edge from a to b
// belong to the triangle on the left of it? True for left edges (going down on
// the screen) and top edges (horizontal, going left). So of two triangles that
// share an edge exactly one owns it, and no pixel is drawn twice.
bool owns_edge(raster_point a, raster_point b);

// The depth at (x, y) of the plane through three projected corners that are
// not on one line: 1/depth is linear on the screen, depth is not.
double depth_at(const raster_point p[3], double x, double y);

#endif
