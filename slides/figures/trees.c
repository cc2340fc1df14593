// trees.c: boxes, splits and cells, in two dimensions.
#include "common/real.h"
#include <stdlib.h>

#include "common/rng.h"
#include "slides/figures/figures.h"

static double lesser(double a, double b) {
    return a < b ? a : b;
}
static double greater(double a, double b) {
    return a > b ? a : b;
}

// ---- the slab test --------------------------------------------------------------------

// The ray is in the box where it is between the planes of x and between those of y.
void slab_figure(const char *folder) {
    drawing d = svg_begin(folder, "slab", (point){-0.4, -0.4}, (point){7.4, 3.6}, 900);
    const point low = {2.6, 1}, high = {4.6, 2.4}, O = {0.3, 0.35}, u = {1, 0.42};
    const double x1 = (low.x - O.x) / u.x, x2 = (high.x - O.x) / u.x;
    const double y1 = (low.y - O.y) / u.y, y2 = (high.y - O.y) / u.y;
    const double enter = greater(x1, y1), leave = lesser(x2, y2);
    svg_box(&d, low, high, OBJECT, PALE);
    for (int i = 0; i < 2; i++) {
        const double x = i ? high.x : low.x, y = i ? high.y : low.y;
        svg_line(&d, (point){x, -0.3}, (point){x, 3.5}, HELP);
        svg_line(&d, (point){-0.3, y}, (point){7.3, y}, HELP);
    }
    svg_arrow(&d, O, (point){O.x + 6.6 * u.x, O.y + 6.6 * u.y}, OBJECT);
    svg_line(&d, (point){O.x + enter * u.x, O.y + enter * u.y},
             (point){O.x + leave * u.x, O.y + leave * u.y}, RAY);
    const double ts[] = {x1, x2, y1, y2};
    const char *names[] = {"x_1", "x_2", "y_1", "y_2"};
    for (int i = 0; i < 4; i++) {
        const point at = {O.x + ts[i] * u.x, O.y + ts[i] * u.y};
        svg_dot(&d, at, i < 2 ? OBJECT : LIGHT);
        svg_symbol(&d, at, i == 2 ? -0.5 : 0.5, i == 2 ? 0.8 : -0.8, names[i]);
    }
    svg_symbol(&d, O, -0.3, 0.7, "O");
    svg_end(&d);
}

// ---- things in the plane ------------------------------------------------------------------

enum { THINGS = 14 };
typedef struct {
    point low, high;
    double r;
    point c;
} thing;

static bool apart(const thing *t, int count, point c, double r) {
    for (int i = 0; i < count; i++)
        if (hypot(t[i].c.x - c.x, t[i].c.y - c.y) < t[i].r + r + 0.05) return false;
    return true;
}

// Most of them in one corner, the others scattered over the rest of the box.
static void things_make(thing *t) {
    enum { CROWD = 9 };
    static const point lows[] = {{4, 0.4}, {7.2, 0.5}, {5.3, 2.6}, {7.3, 3.5}, {1.5, 3.6}};
    static const point near = {0.3, 0.3}, crowd = {3, 2.6}, lone = {1.5, 1.1};
    rng g = rng_seed(9, 14);
    for (int i = 0; i < THINGS;) {
        const point low = i < CROWD ? near : lows[i - CROWD], size = i < CROWD ? crowd : lone;
        const double x = rng_double(&g), y = rng_double(&g), r = 0.13 + 0.2 * rng_double(&g);
        const point c = {low.x + size.x * x, low.y + size.y * y};
        if (!apart(t, i, c, r)) continue;
        t[i++] = (thing){{c.x - r, c.y - r}, {c.x + r, c.y + r}, r, c};
    }
}

static void draw_things(drawing *d, const thing *t, int count) {
    for (int i = 0; i < count; i++) svg_circle(d, t[i].c, t[i].r, OBJECT, PALE);
}

typedef struct {
    point low, high;
} box;

static box box_of(const thing *t, int count) {
    box b = {t[0].low, t[0].high};
    for (int i = 1; i < count; i++) {
        b.low = (point){lesser(b.low.x, t[i].low.x), lesser(b.low.y, t[i].low.y)};
        b.high = (point){greater(b.high.x, t[i].high.x), greater(b.high.y, t[i].high.y)};
    }
    return b;
}

static double around(box b) { // in the plane a line meets a box in proportion to this
    return 2 * (b.high.x - b.low.x + b.high.y - b.low.y);
}

static int by_x(const void *a, const void *b) {
    const double x = ((const thing *)a)->c.x, y = ((const thing *)b)->c.x;
    return (x > y) - (x < y);
}
static int by_y(const void *a, const void *b) {
    const double x = ((const thing *)a)->c.y, y = ((const thing *)b)->c.y;
    return (x > y) - (x < y);
}

// The cheapest of all splits by the slide's c; the things are left sorted for it.
static int cheapest(thing *t, int count) {
    double best = INFINITY;
    int axis = 0, left = 0;
    for (int a = 0; a < 2; a++) {
        qsort(t, (size_t)count, sizeof *t, a ? by_y : by_x);
        for (int k = 1; k < count; k++) {
            const double c =
                k * around(box_of(t, k)) + (count - k) * around(box_of(t + k, count - k));
            if (c < best) best = c, axis = a, left = k;
        }
    }
    qsort(t, (size_t)count, sizeof *t, axis ? by_y : by_x);
    return left;
}

static const point corner_low = {0, 0}, corner_high = {9, 5};

static drawing begin(const char *folder, const char *name) {
    return svg_begin(folder, name, (point){-0.2, -0.2}, (point){9.2, 5.2}, 900);
}

void boxes_figure(const char *folder) {
    drawing d = begin(folder, "boxes");
    thing t[THINGS];
    things_make(t);
    const int left = cheapest(t, THINGS);
    const box all = box_of(t, THINGS), l = box_of(t, left), r = box_of(t + left, THINGS - left);
    svg_box(&d, all.low, all.high, OBJECT, NO_FILL);
    svg_box(&d, l.low, l.high, RAY, NO_FILL);
    svg_box(&d, r.low, r.high, LIGHT, NO_FILL);
    draw_things(&d, t, THINGS);
    svg_end(&d);
}

// Median, midpoint and the cheapest, as three lines through the same things.
void split_figure(const char *folder) {
    drawing d = begin(folder, "split");
    thing t[THINGS];
    things_make(t);
    qsort(t, THINGS, sizeof *t, by_x);
    const double median = (t[THINGS / 2 - 1].c.x + t[THINGS / 2].c.x) / 2;
    const double middle = (t[0].c.x + t[THINGS - 1].c.x) / 2;
    const int left = cheapest(t, THINGS);
    const bool upright = t[left].c.x > t[left - 1].c.x && t[left].c.x >= t[left - 1].high.x;
    const double best = (t[left - 1].c.x + t[left].c.x) / 2;
    draw_things(&d, t, THINGS);
    svg_line(&d, (point){median, 0}, (point){median, 5}, OBJECT);
    svg_line(&d, (point){middle, 0}, (point){middle, 5}, HELP);
    if (upright) svg_line(&d, (point){best, 0}, (point){best, 5}, RAY);
    svg_symbol(&d, (point){median, 5}, -0.4, -0.4, "1");
    svg_symbol(&d, (point){middle, 5}, 0.4, -0.4, "2");
    if (upright) svg_symbol(&d, (point){best, 5}, 0.4, -0.4, "3");
    svg_end(&d);
}

static void draw_tree(drawing *d, thing *t, int count, int depth) {
    static const pen pens[] = {OBJECT, RAY, LIGHT, HELP, FAINT};
    const box b = box_of(t, count);
    svg_box(d, b.low, b.high, pens[depth < 4 ? depth : 4], NO_FILL);
    if (count <= 2) return;
    const int left = cheapest(t, count);
    draw_tree(d, t, left, depth + 1);
    draw_tree(d, t + left, count - left, depth + 1);
}

void bvh_figure(const char *folder) {
    drawing d = begin(folder, "bvh");
    thing t[THINGS];
    things_make(t);
    draw_things(&d, t, THINGS);
    draw_tree(&d, t, THINGS, 0);
    svg_end(&d);
}

// ---- the tree as an array -----------------------------------------------------------------

static void link_down(drawing *d, point from, point to) {
    svg_line(d, from, to, HELP);
}

void flat_figure(const char *folder) {
    drawing d = svg_begin(folder, "flat", (point){-0.3, -0.3}, (point){9.3, 4.4}, 950);
    static const point at[] = {{4.6, 4}, {2.6, 3}, {6.6, 3}, {1.6, 2},
                               {3.4, 2}, {5.7, 2}, {7.5, 2}};
    static const int parent[] = {-1, 0, 0, 1, 1, 2, 2};
    static const char *names[] = {"A", "B", "C", "D", "E", "F", "G"};
    static const int order[] = {0, -1, 1, 2, 3, 4, 5, 6};
    for (int i = 1; i < 7; i++) link_down(&d, at[parent[i]], at[i]);
    for (int i = 0; i < 7; i++) {
        svg_circle(&d, at[i], 0.3, OBJECT, i < 3 ? PALE : WARM);
        svg_symbol(&d, at[i], 0, 0, names[i]);
    }
    for (int i = 0; i < 8; i++) {
        const point low = {0.5 + i, 0.1}, high = {1.5 + i, 0.9};
        svg_box(&d, low, high, OBJECT, order[i] < 0 ? NO_FILL : order[i] < 3 ? PALE : WARM);
        if (order[i] >= 0) svg_symbol(&d, (point){1 + i, 0.5}, 0, 0, names[order[i]]);
    }
    svg_end(&d);
}

// ---- cells ------------------------------------------------------------------------------

static int touching(const thing *t, box cell) {
    int count = 0;
    for (int i = 0; i < THINGS; i++) {
        const double x = lesser(greater(t[i].c.x, cell.low.x), cell.high.x) - t[i].c.x;
        const double y = lesser(greater(t[i].c.y, cell.low.y), cell.high.y) - t[i].c.y;
        if (hypot(x, y) <= t[i].r) count++;
    }
    return count;
}

// Spatial splits: the cheapest of many planes, counting what straddles on both sides.
static void draw_kd(drawing *d, const thing *t, box cell, int depth) {
    const int here = touching(t, cell);
    if (here <= 2 || depth == 0) return;
    enum { TRIES = 40 };
    double best = here * around(cell);
    box l = cell, r = cell;
    for (int i = 1; i < 2 * TRIES; i++) {
        const double share = (double)(i % TRIES) / TRIES;
        if (share == 0) continue;
        box a = cell, b = cell;
        if (i < TRIES)
            a.high.x = b.low.x = cell.low.x + share * (cell.high.x - cell.low.x);
        else
            a.high.y = b.low.y = cell.low.y + share * (cell.high.y - cell.low.y);
        const double c = touching(t, a) * around(a) + touching(t, b) * around(b);
        if (c < best) best = c, l = a, r = b;
    }
    if (best == here * around(cell)) return;
    svg_line(d, (point){r.low.x, r.low.y}, l.high, RAY);
    draw_kd(d, t, l, depth - 1);
    draw_kd(d, t, r, depth - 1);
}

void kd_figure(const char *folder) {
    drawing d = begin(folder, "kd");
    thing t[THINGS];
    things_make(t);
    draw_things(&d, t, THINGS);
    draw_kd(&d, t, (box){corner_low, corner_high}, 6);
    svg_box(&d, corner_low, corner_high, OBJECT, NO_FILL);
    svg_end(&d);
}

static void draw_octree(drawing *d, const thing *t, box cell, int depth) {
    svg_box(d, cell.low, cell.high, RAY, NO_FILL);
    if (touching(t, cell) <= 2 || depth == 0) return;
    const point c = {(cell.low.x + cell.high.x) / 2, (cell.low.y + cell.high.y) / 2};
    for (int i = 0; i < 4; i++) {
        const point low = {i & 1 ? c.x : cell.low.x, i & 2 ? c.y : cell.low.y};
        const point high = {i & 1 ? cell.high.x : c.x, i & 2 ? cell.high.y : c.y};
        draw_octree(d, t, (box){low, high}, depth - 1);
    }
}

void octree_figure(const char *folder) {
    drawing d = begin(folder, "octree");
    thing t[THINGS];
    things_make(t);
    draw_things(&d, t, THINGS);
    draw_octree(&d, t, (box){corner_low, corner_high}, 4);
    svg_box(&d, corner_low, corner_high, OBJECT, NO_FILL);
    svg_end(&d);
}
