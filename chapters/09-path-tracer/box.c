// box.c: the room in numbers.
#include "chapters/09-path-tracer/box.h"

#define V(x, y, z) \
    { (real)(x), (real)(y), (real)(z) }

static const sphere balls[] = {
    [BALL_LEFT] = {V(-0.45, 0.42, -0.4), (real)0.42},
    [BALL_RIGHT] = {V(0.47, 0.34, 0.25), (real)0.34},
};

// The normals point into the room.
static const plane walls[] = {
    [WALL_LEFT - WALL_LEFT] = {V(-1, 0, 0), V(1, 0, 0)},
    [WALL_RIGHT - WALL_LEFT] = {V(1, 0, 0), V(-1, 0, 0)},
    [WALL_FLOOR - WALL_LEFT] = {V(0, 0, 0), V(0, 1, 0)},
    [WALL_CEILING - WALL_LEFT] = {V(0, 2, 0), V(0, -1, 0)},
    [WALL_BACK - WALL_LEFT] = {V(0, 0, -1), V(0, 0, 1)},
    [WALL_FRONT - WALL_LEFT] = {V(0, 0, 3.6), V(0, 0, -1)},
};

// A square, a little below the ceiling, that shines downwards.
static const vec3 lamp_points[] = {V(-0.5, 1.98, -0.6), V(0.5, 1.98, -0.6), V(0.5, 1.98, 0.4),
                                   V(-0.5, 1.98, 0.4)};
static const int lamp_corners[][3] = {{0, 1, 2}, {0, 2, 3}};
static const mesh lamp = {.points = lamp_points,
                          .corners = lamp_corners,
                          .count = COUNT(lamp_corners),
                          .around = {V(0, 1.98, -0.1), (real)0.708}}; // half the diagonal

const scene box_bodies = {.spheres = balls,
                          .sphere_count = COUNT(balls),
                          .planes = walls,
                          .plane_count = COUNT(walls),
                          .meshes = &lamp,
                          .mesh_count = 1};

#define WHITE V(0.76, 0.75, 0.72)
const matte box_surfaces[BOX_BODIES] = {
    [BALL_LEFT] = {.albedo = WHITE},
    [BALL_RIGHT] = {.albedo = V(0.85, 0.6, 0.2)},
    [WALL_LEFT] = {.albedo = V(0.63, 0.08, 0.06)},
    [WALL_RIGHT] = {.albedo = V(0.12, 0.42, 0.12)},
    [WALL_FLOOR] = {.albedo = WHITE},
    [WALL_CEILING] = {.albedo = WHITE},
    [WALL_BACK] = {.albedo = WHITE},
    [WALL_FRONT] = {.albedo = V(0, 0, 0)},
    [LAMP] = {.albedo = WHITE, .emittance = V(5.6, 4.8, 3.6)},
};

camera box_camera(int width, int height) {
    const vec3 eye = V(0, 1, 3.5), target = V(0, 1, 0), up = V(0, 1, 0);
    return camera_look_at(eye, target, up, 40, width, height);
}
