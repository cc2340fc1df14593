// things.h: round things in a square of the plane, most of them in one corner, and boxes around them.
#ifndef SLIDES_THINGS_H
#define SLIDES_THINGS_H

#include "slides/figures/svg.h"

enum { CROWD = 11, THINGS = 16, SIDE = 8 }; // of the square (0, 0) to (SIDE, SIDE)

typedef struct {
    point low, high;
} box;

typedef struct {
    point c;
    double r;
} thing;

void things_make(thing *t); // THINGS of them, none touches another
void things_draw(drawing *d, const thing *t, int count);
box things_box(const thing *t, int count);
void things_sort(thing *t, int count, int axis); // by centre: 0 along x, 1 along y

// The slide's cost n_l A_l + n_r A_r when the first `left` of the things stand on one side. In the
// plane a line meets a box in proportion to its border.
double border(box b);
double split_cost(const thing *t, int count, int left);
// The cheapest of all splits; the things are left sorted for it.
int cheapest(thing *t, int count);

// A ray for t >= 0, and where it is in a box: from `enter` to `leave`, if enter <= leave.
typedef struct {
    point O, u;
} line;
point line_at(line l, double t);
void line_in(line l, box b, double *enter, double *leave);
// The nearest thing's t; INFINITY: none.
double line_hit(line l, const thing *t, int count);

#endif
