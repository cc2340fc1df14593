// scenes.c: the three scenes in numbers, as the task gives them.
#include "solutions/homework/raytracer.h"

#define V(x, y, z) \
    { (real)(x), (real)(y), (real)(z) }

// ---- 1: shapes -----------------------------------------------------------------------

static const body shapes[] = {
    {.shape = PLANE, .p = {V(0, 0, 0)}, .n = V(0, 1, 0)},
    {.shape = SPHERE, .p = {V(0.45, 0.5, 0.9)}, .r = (real)0.45},
    {.shape = SPHERE, .p = {V(-0.8, 0.9, -0.4)}, .r = (real)0.9},
    {.shape = SPHERE, .p = {V(2.5, 2.2, 8)}, .r = (real)1.2},
    {.shape = TRIANGLE, .p = {V(0.3, 0.2, -1.2), V(1.1, 2.3, -1.9), V(2.4, 0.5, -1.6)}},
};
const scene shapes_scene = {.eye = V(1.2, 1.7, 4.1),
                            .target = V(-0.1, 0.6, 0),
                            .fov = 50,
                            .bodies = shapes,
                            .count = COUNT(shapes)};

// ---- 2: mirrors ----------------------------------------------------------------------

static const body mirrors[] = {
    {.shape = PLANE,
     .p = {V(0, 0, 0)},
     .n = V(0, 1, 0),
     .finish = GLOW,
     .color = V(0.9, 0.85, 0.7),
     .color2 = V(0.15, 0.2, 0.3),
     .checkered = true},
    {.shape = SPHERE,
     .p = {V(-1.05, 1, -0.3)},
     .r = 1,
     .finish = MIRROR,
     .color = V(0.9, 0.9, 0.9)},
    {.shape = SPHERE,
     .p = {V(0.95, 0.7, 0.4)},
     .r = (real)0.7,
     .finish = MIRROR,
     .color = V(0.95, 0.75, 0.4)},
    {.shape = SPHERE,
     .p = {V(0.1, 0.3, 1.3)},
     .r = (real)0.3,
     .finish = GLOW,
     .color = V(0.8, 0.15, 0.1)},
};
const scene mirror_scene = {.eye = V(0.4, 1.3, 5.2),
                            .target = V(0.1, 0.8, 0),
                            .fov = 42,
                            .bodies = mirrors,
                            .count = COUNT(mirrors),
                            .sky = true};

// ---- 3: the box ----------------------------------------------------------------------

#define WALL(point, normal, albedo) \
    { .shape = PLANE, .p = {point}, .n = normal, .color = albedo }
#define WHITE V(0.7, 0.68, 0.62)
#define RADIANCE V(11, 9, 6)
static const body box[] = {
    WALL(V(-1, 0, 0), V(1, 0, 0), V(0.6, 0.1, 0.08)),
    WALL(V(1, 0, 0), V(-1, 0, 0), V(0.12, 0.4, 0.15)),
    WALL(V(0, 0, 0), V(0, 1, 0), WHITE),
    WALL(V(0, 2, 0), V(0, -1, 0), WHITE),
    WALL(V(0, 0, -1), V(0, 0, 1), WHITE),
    {.shape = SPHERE,
     .p = {V(-0.42, 0.45, -0.35)},
     .r = (real)0.45,
     .color = V(0.3, 0.45, 0.7)},
    {.shape = SPHERE, .p = {V(0.5, 0.3, 0.3)}, .r = (real)0.3, .color = V(0.72, 0.55, 0.2)},
    {.shape = TRIANGLE,
     .p = {V(-0.35, 1.9, -0.5), V(0.45, 1.9, -0.5), V(0.45, 1.9, 0.3)},
     .finish = GLOW,
     .color = RADIANCE},
    {.shape = TRIANGLE,
     .p = {V(-0.35, 1.9, -0.5), V(0.45, 1.9, 0.3), V(-0.35, 1.9, 0.3)},
     .finish = GLOW,
     .color = RADIANCE},
};
const scene box_scene = {.eye = V(0.1, 1.05, 3.3),
                         .target = V(0, 0.95, 0),
                         .fov = 40,
                         .bodies = box,
                         .count = COUNT(box),
                         .lamp = {.corner = V(-0.35, 1.9, -0.5),
                                  .a = V(0.8, 0, 0),
                                  .b = V(0, 0, 0.8),
                                  .n = V(0, -1, 0),
                                  .area = (real)0.64,
                                  .radiance = RADIANCE}};
