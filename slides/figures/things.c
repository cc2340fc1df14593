// things.c: see things.h.
#include "slides/figures/things.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

#include "common/rng.h"

static bool is_free(const thing *t, int count, thing a) {
    for (int i = 0; i < count; i++)
        if (hypot(a.c.x - t[i].c.x, a.c.y - t[i].c.y) < a.r + t[i].r + 0.06) return false;
    return true;
}

static thing small_in_the_corner(rng *g) {
    const double x = rng_double(g), y = rng_double(g), size = rng_double(g);
    return (thing){{0.5 + 2 * x, 0.5 + 2.8 * y}, 0.12 + 0.12 * size};
}

static thing large_elsewhere(int i, rng *g) {
    const double x = rng_double(g), y = rng_double(g), size = rng_double(g);
    const double r = 0.24 + 0.16 * size, within = SIDE - r - 0.1;
    return (thing){{fmin(3.6 + 0.95 * i + 0.3 * x, within), 0.8 + 6.6 * y}, r};
}

void things_make(thing *t) {
    rng g = rng_seed(9, 14);
    for (int i = 0; i < THINGS;) {
        const thing a = i < CROWD ? small_in_the_corner(&g) : large_elsewhere(i - CROWD, &g);
        if (is_free(t, i, a)) t[i++] = a;
    }
}

void things_draw(drawing *d, const thing *t, int count) {
    for (int i = 0; i < count; i++) svg_circle(d, t[i].c, t[i].r, OBJECT, PALE);
}

box things_box(const thing *t, int count) {
    box b = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
    for (int i = 0; i < count; i++) {
        b.low = (point){fmin(b.low.x, t[i].c.x - t[i].r), fmin(b.low.y, t[i].c.y - t[i].r)};
        b.high = (point){fmax(b.high.x, t[i].c.x + t[i].r), fmax(b.high.y, t[i].c.y + t[i].r)};
    }
    return b;
}

static int by_x(const void *a, const void *b) {
    const double x = ((const thing *)a)->c.x, y = ((const thing *)b)->c.x;
    return (x > y) - (x < y);
}
static int by_y(const void *a, const void *b) {
    const double x = ((const thing *)a)->c.y, y = ((const thing *)b)->c.y;
    return (x > y) - (x < y);
}

void things_sort(thing *t, int count, int axis) {
    qsort(t, (size_t)count, sizeof *t, axis ? by_y : by_x);
}

double border(box b) {
    return 2 * (b.high.x - b.low.x + b.high.y - b.low.y);
}

double split_cost(const thing *t, int count, int left) {
    return left * border(things_box(t, left)) +
           (count - left) * border(things_box(t + left, count - left));
}

int cheapest(thing *t, int count) {
    double best = INFINITY;
    int axis = 0, left = 0;
    for (int a = 0; a < 2; a++) {
        things_sort(t, count, a);
        for (int k = 1; k < count; k++) {
            const double c = split_cost(t, count, k);
            if (c < best) best = c, axis = a, left = k;
        }
    }
    things_sort(t, count, axis);
    return left;
}

point line_at(line l, double t) {
    return (point){l.O.x + t * l.u.x, l.O.y + t * l.u.y};
}

void line_in(line l, box b, double *enter, double *leave) {
    const double x1 = (b.low.x - l.O.x) / l.u.x, x2 = (b.high.x - l.O.x) / l.u.x;
    const double y1 = (b.low.y - l.O.y) / l.u.y, y2 = (b.high.y - l.O.y) / l.u.y;
    *enter = fmax(0, fmax(fmin(x1, x2), fmin(y1, y2)));
    *leave = fmin(fmax(x1, x2), fmax(y1, y2));
}

double line_hit(line l, const thing *t, int count) {
    double nearest = INFINITY;
    for (int i = 0; i < count; i++) {
        const double vx = l.O.x - t[i].c.x, vy = l.O.y - t[i].c.y;
        const double a = l.u.x * l.u.x + l.u.y * l.u.y, b = l.u.x * vx + l.u.y * vy;
        const double under = b * b - a * (vx * vx + vy * vy - t[i].r * t[i].r);
        if (under < 0) continue;
        const double root = (-b - sqrt(under)) / a;
        if (root > 0 && root < nearest) nearest = root;
    }
    return nearest;
}
