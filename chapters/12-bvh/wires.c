// wires.c: see wires.h.
#include "chapters/12-bvh/wires.h"

#include <stdlib.h>

#include "common/die.h"

typedef struct {
    const camera *cam;
    const bvh *tree;
    real *cover; // of each pixel, 0 to 1
} board;

// Where p is in the picture, in pixels; z is how far before the eye.
static vec3 seen_at(const camera *cam, vec3 p) {
    const vec3 v = sub(p, cam->eye);
    const real z = dot(v, cam->forward), k = cam->focal / z;
    return (vec3){(real)cam->width / 2 + k * dot(v, cam->right),
                  (real)cam->height / 2 - k * dot(v, cam->up), z};
}

// A dot of the size of a pixel, shared among the four that it lies over.
static void put_dot(const board *b, real x, real y, real strength) {
    const int left = (int)floor(x - (real)0.5), top = (int)floor(y - (real)0.5);
    for (int j = top; j <= top + 1; j++)
        for (int i = left; i <= left + 1; i++) {
            if (i < 0 || j < 0 || i >= b->cam->width || j >= b->cam->height) continue;
            const real share =
                (1 - fabs(x - (real)0.5 - (real)i)) * (1 - fabs(y - (real)0.5 - (real)j));
            real *cover = &b->cover[j * b->cam->width + i];
            *cover = fmax(*cover, strength * share);
        }
}

enum { DOTS = 4096 }; // an edge has at most

static void draw_edge(const board *b, vec3 from, vec3 to) {
    const vec3 p = seen_at(b->cam, from), q = seen_at(b->cam, to);
    const bool whole = p.z > 0 && q.z > 0;
    const real pixels = fmax(fabs(p.x - q.x), fabs(p.y - q.y));
    const int dots = whole && 2 * pixels < DOTS ? 1 + (int)(2 * pixels) : DOTS;
    for (int i = 0; i <= dots; i++) {
        const vec3 at = lerp(from, to, (real)i / (real)dots), on = seen_at(b->cam, at);
        if (!(on.z > 0 && fabs(on.x) < DOTS * 4 && fabs(on.y) < DOTS * 4)) continue;
        const ray r = {b->cam->eye, sub(at, b->cam->eye)};
        const bool hidden = bvh_any(b->tree, r, 0, (real)0.999, NULL);
        put_dot(b, on.x, on.y, hidden ? (real)0.12 : 1);
    }
}

// The corners of a box are numbered by three bits; an edge changes one of them.
static vec3 corner(aabb box, int i) {
    return (vec3){i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y,
                  i & 4 ? box.max.z : box.min.z};
}

static void draw_box(const board *b, aabb box) {
    for (int i = 0; i < 8; i++)
        for (int bit = 1; bit < 8; bit *= 2)
            if (!(i & bit)) draw_edge(b, corner(box, i), corner(box, i | bit));
}

static void draw_below(const board *b, int node, int depth) {
    const bvh_node *n = &b->tree->nodes[node];
    if (depth == 0 || n->count) {
        draw_box(b, n->box);
        return;
    }
    draw_below(b, n->first, depth - 1);
    draw_below(b, n->first + 1, depth - 1);
}

void wires_draw(image *img, const camera *cam, const bvh *tree, int depth, color c) {
    const int pixels = img->width * img->height;
    const board b = {cam, tree, calloc((size_t)pixels, sizeof *b.cover)};
    if (!b.cover) die(EXIT_RUN, "no memory to draw boxes");
    if (tree->count) draw_below(&b, 0, depth);
    for (int i = 0; i < pixels; i++) img->pixels[i] = lerp(img->pixels[i], c, b.cover[i]);
    free(b.cover);
}
