// scenes.c: rooms in numbers.
#include "chapters/10-importance-sampling/scenes.h"

#define V(x, y, z) \
    { (real)(x), (real)(y), (real)(z) }

void fill_box_surfaces(surface surfaces[BOX_BODIES], real alpha) {
    for (int i = 0; i < BOX_BODIES; i++)
        surfaces[i] = (surface){.lobe = LAMBERT,
                                .albedo = box_surfaces[i].albedo,
                                .emittance = box_surfaces[i].emittance};
    if (alpha > 0)
        surfaces[BALL_LEFT] =
            (surface){.lobe = GGX, .albedo = V(0.95, 0.93, 0.88), .alpha = alpha};
}

// ---- the plates ----------------------------------------------------------------------

static const vec3 veach_eye = V(0, 2.2, 9.5);
static const vec3 row_of_lamps = V(0, 4.4, -1.2); // its middle
static const struct {
    vec3 middle;
    real alpha;
} plates[PLATES] = {
    {V(0, 0.02, 3.4), (real)0.16},
    {V(0, 0.28, 1.95), (real)0.08},
    {V(0, 0.75, 0.55), (real)0.03},
    {V(0, 1.45, -0.7), (real)0.006},
};
static const struct {
    real x, r;
} round_lamps[ROUND_LAMPS] = {{(real)-2.7, (real)0.03},
                              {(real)-0.9, (real)0.1},
                              {(real)0.9, (real)0.3},
                              {(real)2.7, (real)0.75}};
static const int halves[][3] = {{0, 1, 2}, {0, 2, 3}};

// Its normal lies half way between the camera and the row of lamps.
static void turn_plate(vec3 points[4], vec3 middle) {
    const vec3 to_eye = normalize(sub(veach_eye, middle));
    const vec3 n = normalize(add(to_eye, normalize(sub(row_of_lamps, middle))));
    const vec3 across = {(real)2.6, 0, 0},
               back = scale((real)0.55, normalize(cross(n, across)));
    points[0] = sub(sub(middle, across), back);
    points[1] = sub(add(middle, across), back);
    points[2] = add(add(middle, across), back);
    points[3] = add(sub(middle, across), back);
}

scene veach_build(veach_plates *v) {
    for (int i = 0; i < ROUND_LAMPS; i++) {
        const real r = round_lamps[i].r, L = (real)0.9 / (r * r);
        v->balls[i] = (sphere){add(row_of_lamps, (vec3){round_lamps[i].x, 0, 0}), r};
        v->surfaces[i] = (surface){.emittance = {L, L, L}};
    }
    v->walls[0] = (plane){V(0, -0.6, 0), V(0, 1, 0)};
    v->walls[1] = (plane){V(0, 0, -3.2), V(0, 0, 1)};
    for (int i = 0; i < PLATE_WALLS; i++)
        v->surfaces[ROUND_LAMPS + i] = (surface){.albedo = V(0.4, 0.4, 0.4)};
    for (int i = 0; i < PLATES; i++) {
        turn_plate(v->points[i], plates[i].middle);
        v->plates[i] =
            (mesh){.points = v->points[i], .corners = halves, .count = COUNT(halves)};
        v->surfaces[ROUND_LAMPS + PLATE_WALLS + i] =
            (surface){.lobe = GGX, .albedo = V(0.35, 0.37, 0.4), .alpha = plates[i].alpha};
    }
    return (scene){.spheres = v->balls,
                   .sphere_count = ROUND_LAMPS,
                   .planes = v->walls,
                   .plane_count = PLATE_WALLS,
                   .meshes = v->plates,
                   .mesh_count = PLATES};
}

camera veach_camera(int width, int height) {
    const vec3 target = V(0, 1.75, 0), up = V(0, 1, 0);
    return camera_look_at(veach_eye, target, up, 40, width, height);
}

// ---- the row -------------------------------------------------------------------------

#define BALL(i) \
    { V(2.2 * (i)-5.5, 1, 0), 1 }
static const sphere row_balls[] = {
    BALL(0), BALL(1), BALL(2), BALL(3), BALL(4), BALL(5), {V(-6, 9, 7), (real)0.6}};
static const plane row_floor = {V(0, 0, 0), V(0, 1, 0)};

#define COPPER(i, a) [i] = {.lobe = GGX, .albedo = V(0.95, 0.64, 0.54), .alpha = (real)(a)}
const surface row_surfaces[] = {
    COPPER(0, 0.01),
    COPPER(1, 0.1),
    COPPER(2, 0.2),
    COPPER(3, 0.4),
    COPPER(4, 0.7),
    COPPER(5, 1),
    [ROW] = {.emittance = V(120, 110, 90)},
    [ROW + 1] = {.albedo = V(0.35, 0.35, 0.33)},
};

const scene row_bodies = {.spheres = row_balls,
                          .sphere_count = COUNT(row_balls),
                          .planes = &row_floor,
                          .plane_count = 1,
                          .sky = clear_sky};

camera row_camera(int width, int height) {
    const vec3 eye = V(0, 3, 18), target = V(0, 0.8, 0), up = V(0, 1, 0);
    const real half_width = 7, slope = half_width / 18 * (real)height / (real)width;
    return camera_look_at(eye, target, up, (real)(atan(slope) * 360 / PI), width, height);
}
