// sphereflake.c: nine balls on a ball, nine on each of them, and so on.
//
// Spheres packed as closely as can be have twelve neighbours each. A ball here has nine of
// them, six around its middle and three on top; each is a third as large. With all that is on
// it a ball reaches 1 + 2/3 + 2/9 + ... = 2 radii from its centre, so that neighbours, 60°
// apart, just touch.
#include "chapters/12-bvh/draft.h"
#include "chapters/12-bvh/shapes.h"

// ---- which way the nine are ----------------------------------------------------------

enum { NINE = 9 };

typedef struct {
    wide3 up, nine[NINE]; // of any length, and unit
} cluster;

static const cluster packed = {{1, 1, 1},
                               {{1, -1, 0},
                                {-1, 1, 0},
                                {1, 0, -1},
                                {-1, 0, 1},
                                {0, 1, -1},
                                {0, -1, 1},
                                {1, 1, 0},
                                {1, 0, 1},
                                {0, 1, 1}}};

// The same with `up` upwards: half a turn about the line h between, v -> 2 (v·h) h - v.
static cluster turned(const cluster *from, wide3 up) {
    const wide3 h = wide_unit(wide_along(wide_unit(from->up), 1, up));
    cluster to = {.up = up};
    for (int i = 0; i < NINE; i++) {
        const wide3 v = wide_unit(from->nine[i]);
        to.nine[i] = wide_along((wide3){-v.x, -v.y, -v.z}, 2 * wide_dot(v, h), h);
    }
    return to;
}

// ---- how fine they are ---------------------------------------------------------------

// Into how many parts an icosahedron's edge is cut on the balls of a level: a third as many as
// below it, so that all triangles are about of one size. 0: there are no such balls, since they
// would be icosahedra. `finest` is the first ball's.
static int flake_side(int finest, int level) {
    int thirds = 1;
    for (int i = 0; i < level; i++) thirds *= 3;
    if (level > 0 && finest < 2 * thirds) return 0;
    return (2 * finest + thirds) / (2 * thirds); // rounded
}

typedef struct {
    long balls, squares; // two triangles each
} flake_size;

static flake_size flake_size_of(int finest) {
    flake_size size = {0, 0};
    long balls = 1;
    for (int level = 0; flake_side(finest, level) > 0; level++, balls *= NINE) {
        const int k = flake_side(finest, level);
        size.balls += balls;
        size.squares += 10 * balls * k * k;
    }
    return size;
}

// The first whose successor is not nearer to what is wanted.
static int flake_finest(long triangles) {
    int finest = 1;
    while (flake_size_of(finest).squares + flake_size_of(finest + 1).squares < triangles)
        finest++;
    return finest;
}

// ---- the balls -----------------------------------------------------------------------

static void flake(draft *d, wide3 c, double r, const cluster *on_it, int finest, int level) {
    const int k = flake_side(finest, level);
    if (k == 0) return;
    draft_ball(d, c, r, k);
    for (int i = 0; i < NINE; i++) {
        const wide3 up = on_it->nine[i];
        const cluster next = turned(on_it, up);
        flake(d, wide_along(c, 4 * r / 3, up), r / 3, &next, finest, level + 1);
    }
}

mesh shape_sphereflake(long triangles) {
    const int finest = flake_finest(triangles);
    const flake_size size = flake_size_of(finest);
    draft d = draft_new(size.squares + 2 * size.balls, 2 * size.squares, true);
    const cluster upright = turned(&packed, (wide3){0, 1, 0});
    flake(&d, (wide3){0, 0, 0}, 0.5, &upright, finest, 0);
    return draft_done(d);
}
