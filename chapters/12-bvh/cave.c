// cave.c: a sphere kneaded until it is a cave.
//
// Each step is a shear: it slides all points along one axis by a function of the two other
// coordinates. A shear is one to one and keeps volumes. So however many follow each other, the
// surface never meets itself, holds as much as the sphere did, and keeps inside what was inside.
// The origin stays where it is: noise is 0 there. (Triangles that are too few for the wrinkles
// may cross each other; they still share all their edges.)
#include "chapters/12-bvh/draft.h"
#include "chapters/12-bvh/noise.h"
#include "chapters/12-bvh/shapes.h"

#define SLIDE 0.72    // of the coarsest wrinkles, in radii of the sphere; a quarter each time
#define FREQUENCY 2.5 // of them; twice as much each time
#define SIZE 0.62     // fits the ball of radius 1
enum { WRINKLES = 5 };

static wide3 knead(wide3 p) {
    double a = SLIDE, f = FREQUENCY;
    for (uint32_t seed = 0; seed < 3 * WRINKLES; seed += 3, a /= 4, f *= 2) {
        p.x += a * noise_at(f * p.y, f * p.z, seed).value;
        p.y += a * noise_at(f * p.z, f * p.x, seed + 1).value;
        p.z += a * noise_at(f * p.x, f * p.y, seed + 2).value;
    }
    return p;
}

static wide3 on_wall(wide3 u, const void *nothing) {
    (void)nothing;
    const wide3 p = knead(u);
    return (wide3){SIZE * p.x, SIZE * p.y, SIZE * p.z};
}

// Its outside becomes the side that is seen.
static void turn_inside_out(draft *d) {
    for (int i = 0; i < d->count; i++) {
        int *k = d->corners[i];
        const int a = k[0];
        k[0] = k[1], k[1] = a;
    }
}

mesh shape_cave(long triangles) {
    const int k = draft_side((double)triangles / 20);
    draft d = draft_new(10L * k * k + 2, 20L * k * k, false);
    draft_globe(&d, k, on_wall, NULL);
    turn_inside_out(&d);
    return draft_done(d);
}
