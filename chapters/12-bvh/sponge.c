// sponge.c: Menger's sponge. A cube of 3 x 3 x 3 cubes, of which the middle one and its six
// neighbours are missing; so is each of the twenty others, and so on. Two of its cubes never
// touch in an edge or a corner alone, so its surface is closed: two faces at every edge.
#include <stdlib.h>
#include <string.h>

#include "chapters/12-bvh/draft.h"
#include "chapters/12-bvh/shapes.h"

typedef struct {
    draft d;
    int level, finer; // a side of a cube is cut in `finer`
    int n;            // pieces along a side of the whole
    int *layers[2];   // for z even and odd: 1 + the index of the point at x, y; 0: none yet
} sponge;

static long layer_size(const sponge *s) {
    return (s->n + 1L) * (s->n + 1L);
}

// In base 3: no place where two coordinates have the digit 1.
static bool solid(const sponge *s, const int at[3]) {
    for (int i = 0; i < 3; i++)
        if (at[i] < 0 || at[i] >= s->n) return false;
    int x = at[0] / s->finer, y = at[1] / s->finer, z = at[2] / s->finer;
    for (int level = 0; level < s->level; level++, x /= 3, y /= 3, z /= 3)
        if ((x % 3 == 1) + (y % 3 == 1) + (z % 3 == 1) >= 2) return false;
    return true;
}

static int sponge_point(sponge *s, const int at[3]) {
    int *known = &s->layers[at[2] % 2][at[1] * (s->n + 1) + at[0]];
    if (*known) return *known - 1;
    const double n = s->n;
    const wide3 p = {at[0] / n - 0.5, at[1] / n - 0.5, at[2] / n - 0.5};
    const int made = draft_point(&s->d, p, p);
    *known = made + 1;
    return made;
}

// The face of the cube `at` whose outward normal is plus or minus the axis.
static void sponge_face(sponge *s, const int at[3], int axis, bool plus) {
    static const int square[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const int right = (axis + 1) % 3, up = (axis + 2) % 3;
    int k[4];
    for (int i = 0; i < 4; i++) {
        int corner[3] = {at[0], at[1], at[2]};
        corner[axis] += plus;
        corner[right] += square[i][!plus]; // the other way round from the other side
        corner[up] += square[i][plus];
        k[i] = sponge_point(s, corner);
    }
    draft_square(&s->d, k[0], k[1], k[2], k[3]);
}

static void sponge_cube(sponge *s, const int at[3]) {
    if (!solid(s, at)) return;
    for (int axis = 0; axis < 3; axis++) {
        for (int plus = 0; plus < 2; plus++) {
            int beside[3] = {at[0], at[1], at[2]};
            beside[axis] += plus ? 1 : -1;
            if (!solid(s, beside)) sponge_face(s, at, axis, plus);
        }
    }
}

// 2 20^level + 4 8^level: the six sides of the whole have 6 8^level of them. From one level to the
// next each cube's S become 20 S, without the 2 8^level at each of the 24 places where two touch.
static long sponge_squares(int level) {
    long twenty = 1, eight = 1;
    for (int i = 0; i < level; i++) twenty *= 20, eight *= 8;
    return 2 * twenty + 4 * eight;
}

// The finest sponge of at most 1.5 times as many triangles, its squares cut finer to come near.
static sponge sponge_new(long triangles) {
    sponge s = {.n = 1};
    for (; 4 * sponge_squares(s.level + 1) <= 3 * triangles; s.level++) s.n *= 3;
    s.finer = draft_side((double)triangles / 2 / (double)sponge_squares(s.level));
    s.n *= s.finer;
    const long squares = sponge_squares(s.level) * s.finer * s.finer;
    s.d = draft_new(squares + 2, 2 * squares, false); // by Euler: at most 2 more points
    for (int i = 0; i < 2; i++) s.layers[i] = mesh_room(layer_size(&s), sizeof(int));
    return s;
}

mesh shape_sponge(long triangles) {
    sponge s = sponge_new(triangles);
    for (int at[3] = {0}; at[2] < s.n; at[2]++) {
        for (at[1] = 0; at[1] < s.n; at[1]++)
            for (at[0] = 0; at[0] < s.n; at[0]++) sponge_cube(&s, at);
        memset(s.layers[at[2] % 2], 0, (size_t)layer_size(&s) * sizeof(int)); // for z + 2
    }
    for (int i = 0; i < 2; i++) free(s.layers[i]);
    return draft_done(s.d);
}
