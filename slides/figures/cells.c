// cells.c: space divided: k-d tree and octree, in two dimensions.
#include "common/real.h"
#include <stdbool.h>

#include "slides/figures/figures.h"
#include "slides/figures/things.h"

static drawing begin(const char *folder, const char *name) {
    return svg_begin(folder, name, (point){-0.1, -0.1}, (point){SIDE + 0.1, SIDE + 0.1}, 560);
}

static int touching(const thing *t, box cell) {
    int count = 0;
    for (int i = 0; i < THINGS; i++) {
        const double x = fmin(fmax(t[i].c.x, cell.low.x), cell.high.x) - t[i].c.x;
        const double y = fmin(fmax(t[i].c.y, cell.low.y), cell.high.y) - t[i].c.y;
        if (hypot(x, y) <= t[i].r) count++;
    }
    return count;
}

// ---- walks ------------------------------------------------------------------------------

// A walk along the ray up to its hit: the cells in their order.
enum { CELLS = 64 };
typedef struct {
    line l;
    double hit;
    box cells[CELLS]; // those that the ray is in before the hit
    int count;
} walk;

static void visit(walk *w, box cell) {
    double enter, leave;
    line_in(w->l, cell, &enter, &leave);
    if (enter < leave && enter < w->hit && w->count < CELLS) w->cells[w->count++] = cell;
}

static double entry(const walk *w, int i) {
    double enter, leave;
    line_in(w->l, w->cells[i], &enter, &leave);
    return enter;
}

static void draw_walk(drawing *d, const walk *w) {
    for (int i = 0; i < w->count; i++) {
        int before = 1;
        for (int j = 0; j < w->count; j++) before += entry(w, j) < entry(w, i);
        char name[12];
        snprintf(name, sizeof name, "%d", before);
        double enter, leave;
        line_in(w->l, w->cells[i], &enter, &leave);
        const point middle = line_at(w->l, (enter + fmin(leave, w->hit)) / 2);
        const bool above = w->cells[i].low.y + w->cells[i].high.y > 2 * middle.y;
        svg_words(d, middle, 0, above ? 0.8 : -0.8, name);
    }
    svg_arrow(d, w->l.O, line_at(w->l, w->hit), RAY);
}

static walk walk_through(const thing *t) {
    const point O = {0, 4.5}, at = t[CROWD + 3].c;
    walk w = {.l = {O, {at.x - O.x, at.y - O.y}}};
    w.hit = line_hit(w.l, t, THINGS);
    return w;
}

static void shade(drawing *d, const walk *w) {
    for (int i = 0; i < w->count; i++)
        svg_box(d, w->cells[i].low, w->cells[i].high, FAINT, WARM);
}

// ---- k-d tree ---------------------------------------------------------------------------

typedef struct {
    box low, high;
} halves;

static halves cut(box cell, int axis, double share) {
    halves h = {cell, cell};
    if (axis)
        h.low.high.y = h.high.low.y = cell.low.y + share * (cell.high.y - cell.low.y);
    else
        h.low.high.x = h.high.low.x = cell.low.x + share * (cell.high.x - cell.low.x);
    return h;
}

// The cheapest of many planes, counting what straddles on both sides; a leaf where none is cheaper.
static bool divide(const thing *t, box cell, halves *found) {
    enum { TRIES = 64 };
    const int here = touching(t, cell);
    double best = here * border(cell) * 0.9;
    bool any = false;
    for (int i = 0; i < 2 * TRIES; i++) {
        const double share = (double)(i % TRIES) / TRIES;
        if (share == 0) continue;
        const halves h = cut(cell, i / TRIES, share);
        const double c =
            touching(t, h.low) * border(h.low) + touching(t, h.high) * border(h.high);
        if (c < best) best = c, *found = h, any = true;
    }
    return any && here > 1;
}

static void grow_kd(drawing *d, const thing *t, box cell, int depth, walk *w) {
    halves h;
    if (depth == 0 || !divide(t, cell, &h)) {
        if (!d) visit(w, cell);
        return;
    }
    grow_kd(d, t, h.low, depth - 1, w);
    grow_kd(d, t, h.high, depth - 1, w);
    if (d) svg_line(d, h.high.low, h.low.high, OBJECT);
}

static const box root = {{0, 0}, {SIDE, SIDE}};

void kd_figure(const char *folder) {
    drawing d = begin(folder, "kd");
    thing t[THINGS];
    things_make(t);
    walk w = walk_through(t);
    grow_kd(NULL, t, root, 6, &w);
    shade(&d, &w);
    grow_kd(&d, t, root, 6, &w);
    svg_box(&d, root.low, root.high, OBJECT, NO_FILL);
    things_draw(&d, t, THINGS);
    draw_walk(&d, &w);
    svg_end(&d);
}

// A long triangle, edge on: it is listed in the first cell, and hit in the second, behind a thing
// that only the second cell knows.
void straddle_figure(const char *folder) {
    drawing d = svg_begin(folder, "straddle", (point){-0.2, -0.6}, (point){8.2, 4.6}, 700);
    const line l = {{0.5, 1}, {1, 0.14}};
    const point p = {2.6, 4.1}, q = {7.8, 1.2};
    const thing ball = {{4.9, 1.65}, 0.4};
    const double middle = 4, ux = q.x - p.x, uy = q.y - p.y;
    const double far = ((p.x - l.O.x) * uy - (p.y - l.O.y) * ux) / (l.u.x * uy - l.u.y * ux);
    svg_box(&d, (point){0, 0}, (point){middle, 4.4}, OBJECT, NO_FILL);
    svg_box(&d, (point){middle, 0}, (point){8, 4.4}, OBJECT, NO_FILL);
    svg_circle(&d, ball.c, ball.r, OBJECT, PALE);
    svg_line(&d, p, q, OBJECT);
    svg_line(&d, l.O, line_at(l, line_hit(l, &ball, 1)), RAY);
    svg_line(&d, line_at(l, line_hit(l, &ball, 1)), line_at(l, far), HELP);
    svg_dot(&d, line_at(l, far), OBJECT);
    svg_dot(&d, line_at(l, line_hit(l, &ball, 1)), RAY);
    svg_dot(&d, l.O, OBJECT);
    svg_symbol(&d, l.O, 0, 0.8, "O");
    svg_symbol(&d, line_at(l, far), 0.5, 0.7, "t_1");
    svg_symbol(&d, line_at(l, line_hit(l, &ball, 1)), -0.7, 0.7, "t_2");
    svg_words(&d, (point){middle / 2, 0}, 0, -0.7, "1");
    svg_words(&d, (point){3 * middle / 2, 0}, 0, -0.7, "2");
    svg_end(&d);
}

// ---- octree ---------------------------------------------------------------------------

static box quarter(box cell, int i) {
    const point c = {(cell.low.x + cell.high.x) / 2, (cell.low.y + cell.high.y) / 2};
    return (box){{i & 1 ? c.x : cell.low.x, i & 2 ? c.y : cell.low.y},
                 {i & 1 ? cell.high.x : c.x, i & 2 ? cell.high.y : c.y}};
}

static void grow_octree(drawing *d, const thing *t, box cell, int depth, walk *w) {
    if (d) svg_box(d, cell.low, cell.high, OBJECT, NO_FILL);
    if (touching(t, cell) <= 2 || depth == 0) {
        if (!d) visit(w, cell);
        return;
    }
    for (int i = 0; i < 4; i++) grow_octree(d, t, quarter(cell, i), depth - 1, w);
}

void octree_figure(const char *folder) {
    drawing d = begin(folder, "octree");
    thing t[THINGS];
    things_make(t);
    walk w = walk_through(t);
    grow_octree(NULL, t, root, 4, &w);
    shade(&d, &w);
    grow_octree(&d, t, root, 4, &w);
    things_draw(&d, t, THINGS);
    draw_walk(&d, &w);
    svg_end(&d);
}

// The children and two rays: along +x, +y the numbers rise, and mirrored along x with mask 1.
void order_figure(const char *folder) {
    drawing d = svg_begin(folder, "order", (point){-0.3, -0.3}, (point){10.3, 4.7}, 760);
    static const char *numbers[] = {"0", "1", "2", "3"};
    for (int side = 0; side < 2; side++) {
        const double x = 5.6 * side, s = side ? -1 : 1, middle = x + 2.2;
        const box cell = {{x, 0}, {x + 4.4, 4.4}};
        for (int i = 0; i < 4; i++) {
            const box b = quarter(cell, i);
            svg_box(&d, b.low, b.high, OBJECT, i == (side ? 0 : 1) ? NO_FILL : WARM);
            svg_words(&d, (point){(b.low.x + b.high.x) / 2, (b.low.y + b.high.y) / 2},
                      i & 1 ? 1.2 : -1.2, i & 2 ? 1 : -1, numbers[i]);
        }
        svg_arrow(&d, (point){middle - s * 2.6, 0.9}, (point){middle + s * 1.3, 4.6}, RAY);
    }
    svg_end(&d);
}
