// globe.c: a sphere made of the icosahedron's twenty faces, as a grid.
//
// The faces are taken in pairs, as ten diamonds: five hang from the north pole, five stand on
// the south pole between them. The points of a diamond are a grid, its corners A at (0, 0),
// B at (k, 0), C at (k, k), D at (0, k). The north pole is the A of the upper ones, the south
// pole the C of the lower ones. Diamonds share their sides: each owns the two at B.
#include <stdlib.h>

#include "chapters/12-bvh/draft.h"

enum { DIAMONDS = 5 }; // at each pole
static const wide3 north = {0, 0, 1}, south = {0, 0, -1};

// ---- which points -----------------------------------------------------------------

typedef struct {
    int first; // index of the north pole; the south pole follows
    int k;     // squares along a diamond's side
} globe;

// The index of the point (a, b) of a diamond, or of the neighbour that owns it.
static int globe_point(globe g, int i, bool lower, int a, int b) {
    const int next = (i + 1) % DIAMONDS;
    if (a > 0 && b < g.k) return g.first + 2 + ((2 * i + lower) * g.k + a - 1) * g.k + b;
    if (lower && b < g.k) return globe_point(g, next, false, g.k, b);
    if (lower) return a == g.k ? g.first + 1 : globe_point(g, next, true, g.k, a);
    if (a > 0) return globe_point(g, i, true, a, 0);
    return b == 0 ? g.first : globe_point(g, next, false, b, 0);
}

// Its squares, cut from B's side to D's: the middle one along the edge of the icosahedron.
static void globe_corners(draft *d, globe g, int i, bool lower) {
    for (int a = 0; a < g.k; a++)
        for (int b = 0; b < g.k; b++)
            draft_square(d, globe_point(g, i, lower, a + 1, b),
                         globe_point(g, i, lower, a + 1, b + 1),
                         globe_point(g, i, lower, a, b + 1), globe_point(g, i, lower, a, b));
}

// ---- where they are ---------------------------------------------------------------

typedef struct {
    wide3 A, B, C, D;
} diamond;

// The icosahedron's ten corners between the poles: at every 36°, above and below in turn.
static wide3 upper_corner(int i) {
    static const double turns[DIAMONDS][2] = {{1, 0},
                                              {0.30901699437494742, 0.95105651629515357},
                                              {-0.80901699437494742, 0.58778525229247313},
                                              {-0.80901699437494742, -0.58778525229247313},
                                              {0.30901699437494742, -0.95105651629515357}};
    const double *turn = turns[i % DIAMONDS]; // cosine and sine of 72° i
    return wide_unit((wide3){2 * turn[0], 2 * turn[1], 1});
}

static wide3 lower_corner(int i) {
    return wide_along((wide3){0, 0, 0}, -1, upper_corner(i + 3));
}

static diamond diamond_at(int i, bool lower) {
    if (lower)
        return (diamond){upper_corner(i + 1), lower_corner(i), south, lower_corner(i + 1)};
    return (diamond){north, upper_corner(i), lower_corner(i), upper_corner(i + 1)};
}

// The point (a, b) of the flat faces A B D and C D B, times k.
static wide3 on_faces(diamond f, int k, int a, int b) {
    const int s = k - a - b; // A's or C's share
    const wide3 to_s = wide_along((wide3){0, 0, 0}, abs(s), s > 0 ? f.A : f.C);
    return wide_along(wide_along(to_s, s > 0 ? a : k - b, f.B), s > 0 ? b : k - a, f.D);
}

static void globe_points(draft *d, diamond f, int k, placing place, const void *to) {
    for (int a = 1; a <= k; a++) {
        for (int b = 0; b < k; b++) {
            const wide3 u = wide_unit(on_faces(f, k, a, b));
            draft_point(d, place(u, to), u);
        }
    }
}

void draft_globe(draft *d, int k, placing place, const void *to) {
    const globe g = {d->made, k};
    draft_point(d, place(north, to), north);
    draft_point(d, place(south, to), south);
    for (int i = 0; i < DIAMONDS; i++) {
        for (int lower = 0; lower < 2; lower++) {
            globe_points(d, diamond_at(i, lower), k, place, to);
            globe_corners(d, g, i, lower);
        }
    }
}

// ---- balls ------------------------------------------------------------------------

typedef struct {
    wide3 c;
    double r;
} ball;

static wide3 on_ball(wide3 u, const void *to) {
    const ball *b = to;
    return wide_along(b->c, b->r, u);
}

void draft_ball(draft *d, wide3 c, double r, int k) {
    const ball b = {c, r};
    draft_globe(d, k, on_ball, &b);
}
