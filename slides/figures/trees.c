// trees.c: the slab test, boxes and splits, in two dimensions.
#include "common/real.h"
#include <stdbool.h>

#include "common/rng.h"
#include "slides/figures/figures.h"
#include "slides/figures/things.h"

// ---- the slab test --------------------------------------------------------------------

static void draw_span(drawing *d, double y, double from, double to, pen p, const char *name) {
    svg_line(d, (point){from, y}, (point){to, y}, p);
    svg_dot(d, (point){from, y}, p);
    svg_dot(d, (point){to, y}, p);
    svg_symbol(d, (point){-0.1, y}, 0, 0, name);
}

// The ray is in the box where it is between the planes of x and between those of y. Below, the
// same as spans of t.
void slab_figure(const char *folder) {
    drawing d = svg_begin(folder, "slab", (point){-0.4, -2.5}, (point){7.6, 4}, 640);
    const box b = {{2.4, 1.2}, {4.6, 2.7}};
    const line l = {{0.4, 0.3}, {1, 0.52}};
    const double x1 = (b.low.x - l.O.x) / l.u.x, x2 = (b.high.x - l.O.x) / l.u.x;
    const double y1 = (b.low.y - l.O.y) / l.u.y, y2 = (b.high.y - l.O.y) / l.u.y;
    double enter, leave;
    line_in(l, b, &enter, &leave);
    svg_box(&d, b.low, b.high, OBJECT, PALE);
    for (int i = 0; i < 2; i++) {
        const double x = i ? b.high.x : b.low.x, y = i ? b.high.y : b.low.y;
        svg_line(&d, (point){x, -2.4}, (point){x, 3.6}, HELP);
        svg_line(&d, (point){0.2, y}, (point){6.5, y}, HELP);
        svg_symbol(&d, (point){x, 3.6}, 0, 0.6, i ? "x_max" : "x_min");
        svg_symbol(&d, (point){6.5, y}, 1.1, 0, i ? "y_max" : "y_min");
    }
    svg_arrow(&d, l.O, line_at(l, 6), OBJECT);
    svg_line(&d, line_at(l, enter), line_at(l, leave), RAY);
    for (int i = 0; i < 2; i++) {
        svg_dot(&d, line_at(l, i ? x2 : x1), OBJECT);
        svg_dot(&d, line_at(l, i ? y2 : y1), LIGHT);
    }
    svg_symbol(&d, l.O, -0.5, 0.5, "O");
    // x = O.x + t for this ray: a span of t stands below the part of the ray that it means
    draw_span(&d, -0.7, l.O.x + x1, l.O.x + x2, OBJECT, "t_x");
    draw_span(&d, -1.4, l.O.x + y1, l.O.x + y2, LIGHT, "t_y");
    draw_span(&d, -2.1, l.O.x + enter, l.O.x + leave, RAY, "t");
    svg_end(&d);
}

// ---- where to divide ------------------------------------------------------------------

static drawing begin(const char *folder, const char *name, double depth_below) {
    return svg_begin(folder, name, (point){-0.1, -0.1 - depth_below},
                     (point){SIDE + 0.1, SIDE + 0.1}, 560);
}

// Random lines that meet the box of all: those in red also meet the left box.
static void draw_lines(drawing *d, box all, box inner) {
    rng g = rng_seed(1, 2);
    const point c = {(all.low.x + all.high.x) / 2, (all.low.y + all.high.y) / 2};
    const double radius = hypot(all.high.x - c.x, all.high.y - c.y);
    for (int lines = 0; lines < 40;) {
        const double angle = PI * rng_double(&g), off = radius * (2 * rng_double(&g) - 1);
        const point u = {cos(angle), sin(angle)};
        const line l = {{c.x - off * u.y - 20 * u.x, c.y + off * u.x - 20 * u.y}, u};
        double enter, leave, t0, t1;
        line_in(l, all, &enter, &leave);
        if (enter > leave) continue;
        line_in(l, inner, &t0, &t1);
        svg_line(d, line_at(l, enter), line_at(l, leave), t0 <= t1 ? THIN : FAINT);
        lines++;
    }
}

void boxes_figure(const char *folder) {
    drawing d = begin(folder, "boxes", 0);
    thing t[THINGS];
    things_make(t);
    const int left = cheapest(t, THINGS);
    const box all = things_box(t, THINGS), l = things_box(t, left),
              r = things_box(t + left, THINGS - left);
    draw_lines(&d, all, l);
    things_draw(&d, t, THINGS);
    svg_box(&d, all.low, all.high, OBJECT, NO_FILL);
    svg_box(&d, l.low, l.high, RAY, NO_FILL);
    svg_box(&d, r.low, r.high, LIGHT, NO_FILL);
    svg_symbol(&d, (point){all.low.x, all.high.y}, 0.9, -0.9, "A");
    svg_symbol(&d, (point){l.low.x, l.high.y}, 1.8, 0.8, "A_l");
    svg_symbol(&d, r.low, 1, 0.9, "A_r");
    svg_end(&d);
}

static void draw_upright(drawing *d, double x, pen p, const char *name) {
    svg_line(d, (point){x, -2.6}, (point){x, SIDE - 0.5}, p);
    svg_symbol(d, (point){x, SIDE - 0.2}, 0, 0, name);
}

// Median, midpoint and the cheapest, as three lines through the same things; below, what each
// place to cut costs.
void split_figure(const char *folder) {
    drawing d = begin(folder, "split", 2.7);
    thing t[THINGS];
    things_make(t);
    things_sort(t, THINGS, 0);
    const double median = (t[THINGS / 2 - 1].c.x + t[THINGS / 2].c.x) / 2;
    const double middle = (t[0].c.x + t[THINGS - 1].c.x) / 2;
    double cost[THINGS] = {0}, most = 0;
    int best = 1;
    for (int k = 1; k < THINGS; k++) {
        cost[k] = split_cost(t, THINGS, k);
        if (cost[k] > most) most = cost[k];
        if (cost[k] < cost[best]) best = k;
    }
    draw_upright(&d, median, OBJECT, "1");
    draw_upright(&d, middle, LIGHT, "2");
    draw_upright(&d, (t[best - 1].c.x + t[best].c.x) / 2, RAY, "3");
    things_draw(&d, t, THINGS);
    svg_line(&d, (point){0, -2.6}, (point){SIDE, -2.6}, OBJECT);
    for (int k = 1; k < THINGS; k++) { // between two centres the cut may lie anywhere
        const double y = -2.6 + 2.2 * cost[k] / most;
        svg_line(&d, (point){t[k - 1].c.x, y}, (point){t[k].c.x, y}, OBJECT);
        if (k > 1)
            svg_line(&d, (point){t[k - 1].c.x, -2.6 + 2.2 * cost[k - 1] / most},
                     (point){t[k - 1].c.x, y}, FAINT);
    }
    svg_symbol(&d, (point){0, -0.4}, 0.5, 0, "c");
    svg_end(&d);
}

// What n things cost as a leaf, and divided: a step, and two halves with 2/3 of the surface each.
void leaf_figure(const char *folder) {
    drawing d = svg_begin(folder, "leaf", (point){-0.6, -1}, (point){8.4, 6.6}, 520);
    svg_arrow(&d, (point){0, 0}, (point){7.4, 0}, OBJECT);
    svg_arrow(&d, (point){0, 0}, (point){0, 6.4}, OBJECT);
    svg_line(&d, (point){0, 0}, (point){6, 6}, RAY);
    svg_line(&d, (point){0, 1}, (point){6, 5}, LIGHT);
    svg_line(&d, (point){3, 0}, (point){3, 3}, HELP);
    svg_dot(&d, (point){3, 3}, OBJECT);
    svg_symbol(&d, (point){7.4, 0}, 0.6, 0, "n");
    svg_symbol(&d, (point){3, 0}, 0, -0.8, "3");
    svg_symbol(&d, (point){6, 6}, 0.6, 0.2, "n");
    svg_symbol(&d, (point){6, 5}, 2.1, -0.1, "1 + 2n/3");
    svg_end(&d);
}

// ---- the tree of boxes ----------------------------------------------------------------

// A ray goes down: solid boxes are met, dashed ones asked and missed, pale ones never asked.
static void draw_tree(drawing *d, thing *t, int count, line l, bool asked) {
    const box b = things_box(t, count);
    double enter, leave;
    line_in(l, b, &enter, &leave);
    const bool met = asked && enter <= leave, leaf = count <= 2;
    svg_box(d, b.low, b.high,
            met     ? OBJECT
            : asked ? HELP
                    : FAINT,
            met && leaf ? WARM : NO_FILL);
    if (leaf) {
        things_draw(d, t, count);
        return;
    }
    const int left = cheapest(t, count);
    draw_tree(d, t, left, l, met);
    draw_tree(d, t + left, count - left, l, met);
}

void bvh_figure(const char *folder) {
    drawing d = begin(folder, "bvh", 0);
    thing t[THINGS];
    things_make(t);
    const line l = {{0, 4.4}, {8, 2.6}};
    draw_tree(&d, t, THINGS, l, true);
    svg_arrow(&d, l.O, line_at(l, line_hit(l, t, THINGS)), RAY);
    svg_end(&d);
}

// ---- the tree as an array -----------------------------------------------------------------

void flat_figure(const char *folder) {
    drawing d = svg_begin(folder, "flat", (point){-0.1, -0.9}, (point){8.3, 4.4}, 720);
    static const point at[] = {{4.1, 4}, {2.1, 3}, {6.1, 3}, {1.1, 2},
                               {3.1, 2}, {5.1, 2}, {7.1, 2}};
    static const int parent[] = {-1, 0, 0, 1, 1, 2, 2};
    static const char *names[] = {"A", "B", "C", "D", "E", "F", "G"};
    static const int order[] = {0, -1, 1, 2, 3, 4, 5, 6};
    static const char *places[] = {"0", "1", "2", "3", "4", "5", "6", "7"};
    for (int i = 1; i < 7; i++) svg_line(&d, at[parent[i]], at[i], HELP);
    for (int i = 0; i < 7; i++) {
        svg_circle(&d, at[i], 0.32, OBJECT, i < 3 ? PALE : WARM);
        svg_symbol(&d, at[i], 0, 0, names[i]);
    }
    for (int i = 0; i < 8; i++) {
        const point low = {0.1 + i, 0.1}, high = {1.1 + i, 0.9};
        svg_box(&d, low, high, OBJECT, order[i] < 0 ? NO_FILL : order[i] < 3 ? PALE : WARM);
        if (order[i] >= 0) svg_symbol(&d, (point){0.6 + i, 0.5}, 0, 0, names[order[i]]);
        svg_words(&d, (point){0.6 + i, -0.4}, 0, 0, places[i]);
    }
    svg_end(&d);
}
