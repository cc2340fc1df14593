// surfaces.c: what is made from a rectangular grid: hills and the knot.
#include "chapters/12-bvh/draft.h"
#include "chapters/12-bvh/noise.h"
#include "chapters/12-bvh/shapes.h"

// ---- hills over the square |x|, |z| <= HALF; y is up ------------------------------------

#define HALF 0.7      // the corners lie in the ball of radius 1
#define STEEPNESS 0.4 // of one octave
enum { HILL_OCTAVES = 8 };

static int hill_point(draft *d, double x, double z) {
    const noise n = noise_sum(x + 5, z + 5, 1.5, HILL_OCTAVES, 12);
    const wide3 up = {-STEEPNESS * n.x, 1, -STEEPNESS * n.y};
    return draft_point(d, (wide3){x, STEEPNESS * n.value, z}, wide_unit(up));
}

mesh shape_hills(long triangles) {
    const int side = draft_side((double)triangles / 2), points = side + 1;
    draft d = draft_new((long)points * points, 2L * side * side, true);
    for (int i = 0; i <= side; i++)
        for (int k = 0; k <= side; k++)
            hill_point(&d, HALF * (2.0 * i / side - 1), HALF * (2.0 * k / side - 1));
    for (int i = 0; i < side; i++) {
        for (int k = 0; k < side; k++) {
            const int a = i * points + k;
            draft_square(&d, a, a + 1, a + points + 1, a + points);
        }
    }
    return draft_done(d);
}

// ---- the knot ------------------------------------------------------------------------------

// Its middle line runs on a torus around the z axis, twice around the axis and three times
// around the ring. RING + WAVE + TUBE = 1.
#define RING 0.55
#define WAVE 0.28
#define TUBE 0.17
#define SLENDERNESS 8.3 // the middle line's length / the tube's circumference

typedef struct {
    wide3 c, n, b; // on the middle line; across it, off the torus and along the torus
} knot_frame;

static knot_frame knot_at(double t) {
    const double c2 = cos(2 * t), s2 = sin(2 * t), c3 = cos(3 * t), s3 = sin(3 * t);
    const double far = RING + WAVE * c3;
    const wide3 n = {c3 * c2, c3 * s2, s3};
    const wide3 ahead = {-2 * far * s2 - 3 * WAVE * s3 * c2, 2 * far * c2 - 3 * WAVE * s3 * s2,
                         3 * WAVE * c3};
    return (knot_frame){{far * c2, far * s2, WAVE * s3}, n, wide_cross(n, wide_unit(ahead))};
}

static void knot_ring(draft *d, knot_frame f, int across, double size) {
    for (int k = 0; k < across; k++) {
        const double turn = 2 * PI * k / across;
        const wide3 side = {cos(turn) * f.n.x, cos(turn) * f.n.y, cos(turn) * f.n.z};
        const wide3 n = wide_along(side, sin(turn), f.b), p = wide_along(f.c, TUBE, n);
        draft_point(d, (wide3){size * p.x, size * p.y, size * p.z}, n);
    }
}

void draft_knot(draft *d, knot_grid g, double size) {
    const int first = d->made;
    for (int i = 0; i < g.around; i++) {
        const int here = first + i * g.across, next = first + (i + 1) % g.around * g.across;
        knot_ring(d, knot_at(2 * PI * i / g.around), g.across, size);
        for (int k = 0; k < g.across; k++) {
            const int l = (k + 1) % g.across;
            draft_square(d, here + k, next + k, next + l, here + l);
        }
    }
}

knot_grid knot_grid_of(long triangles) {
    const double squares = (double)triangles / 2;
    const double across = fmax(3, round(sqrt(squares / SLENDERNESS)));
    return (knot_grid){(int)fmax(12, round(squares / across)), (int)across};
}

mesh shape_knot(long triangles) {
    const knot_grid g = knot_grid_of(triangles);
    const long squares = (long)g.around * g.across;
    draft d = draft_new(squares, 2 * squares, true);
    draft_knot(&d, g, 1);
    return draft_done(d);
}
