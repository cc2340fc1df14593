// shapes.c: see shapes.h. The small ones are here; hills and knot are in surfaces.c, the
// others in files of their own.
#include "chapters/12-bvh/shapes.h"

#include "chapters/12-bvh/draft.h"

mesh shape_icosphere(long triangles) {
    const int k = draft_side((double)triangles / 20);
    draft d = draft_new(10L * k * k + 2, 20L * k * k, true);
    draft_ball(&d, (wide3){0, 0, 0}, 1, k);
    return draft_done(d);
}

// ---- a cloud ----------------------------------------------------------------------------

// Uniform in the ball of radius 1, and not its centre.
static wide3 in_ball(rng *g) {
    for (;;) {
        const double x = rng_double(g), y = rng_double(g), z = rng_double(g);
        const wide3 p = {2 * x - 1, 2 * y - 1, 2 * z - 1};
        const double pp = wide_dot(p, p);
        if (pp <= 1 && pp > 0) return p;
    }
}

// An equilateral triangle, its corners at the distance `size` from its centre.
static void grain(draft *d, double size, rng *g) {
    static const double cosine[] = {1, -0.5, -0.5},
                        sine[] = {0, 0.86602540378443865, -0.86602540378443865};
    const wide3 c = wide_along((wide3){0, 0, 0}, 1 - size, in_ball(g));
    const wide3 s = wide_unit(in_ball(g)), t = wide_unit(wide_cross(s, in_ball(g)));
    const int first = d->made;
    for (int i = 0; i < 3; i++)
        draft_point(d, wide_along(wide_along(c, size * cosine[i], s), size * sine[i], t), s);
    draft_triangle(d, first, first + 1, first + 2);
}

mesh shape_cloud(long triangles) {
    const double size = 1 / (1 + sqrt((double)triangles));
    draft d = draft_new(3 * triangles, triangles, false);
    rng g = rng_seed(12, 0);
    for (long i = 0; i < triangles; i++) grain(&d, size, &g);
    return draft_done(d);
}

// ---- the teapot in the stadium ----------------------------------------------------------

#define TEAPOT 0.001 // as large as this is the ball that holds the knot
enum { HALL = 12 };

// Of its corner i the bits say whether x, y and z are high. Its walls are seen from inside.
static void draft_hall(draft *d, wide3 low, wide3 high) {
    static const int walls[HALL / 2][4] = {{0, 2, 6, 4}, {1, 5, 7, 3}, {0, 4, 5, 1},
                                           {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 6, 7, 5}};
    const int first = d->made;
    for (int i = 0; i < 8; i++) {
        const wide3 p = {i & 1 ? high.x : low.x, i & 2 ? high.y : low.y,
                         i & 4 ? high.z : low.z};
        draft_point(d, p, p);
    }
    for (int i = 0; i < HALL / 2; i++) {
        const int *k = walls[i];
        draft_square(d, first + k[0], first + k[1], first + k[2], first + k[3]);
    }
}

mesh shape_stadium(long triangles) {
    const knot_grid g = knot_grid_of(triangles - HALL);
    const long squares = (long)g.around * g.across;
    draft d = draft_new(squares + 8, 2 * squares + HALL, false);
    draft_knot(&d, g, TEAPOT);
    draft_hall(&d, (wide3){-0.4, -TEAPOT, -0.6}, (wide3){0.6, 0.4, 0.4});
    return draft_done(d);
}

// ------------------------------------------------------------------------------------------

#define AT(x, y, z) \
    { (real)(x), (real)(y), (real)(z) }
const shape shapes[] = {
    {"icosphere", "a sphere", shape_icosphere, AT(0.8, 1, 3), AT(0, 0, 0)},
    {"hills", "hills, a height field", shape_hills, AT(1.1, 1.2, 1.6), AT(0, -0.05, 0)},
    {"knot", "a tube in a knot", shape_knot, AT(0.5, 1, 3.1), AT(0, 0, 0)},
    {"sphereflake", "balls on balls", shape_sphereflake, AT(0.5, 1, 2.7), AT(0, 0.13, 0)},
    {"sponge", "Menger's sponge", shape_sponge, AT(1.2, 1, 1.9), AT(0, -0.03, 0)},
    {"cave", "a wrinkled cave, from inside", shape_cave, AT(0, 0, 0.2), AT(0.3, 0, -0.5)},
    {"cloud", "a cloud of small triangles", shape_cloud, AT(0.5, 1, 3), AT(0, 0, 0)},
    {"stadium", "a tiny knot in a large hall", shape_stadium, AT(0.002, 0.001, 0.006),
     AT(0, 0, 0)},
    {0},
};
