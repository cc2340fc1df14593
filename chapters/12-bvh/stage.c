// stage.c: see stage.h.
#include "chapters/12-bvh/stage.h"

#include <string.h>

#include "chapters/12-bvh/shapes.h"

#define V(x, y, z) \
    { (real)(x), (real)(y), (real)(z) }

// ---- the shapes ----------------------------------------------------------------------

#define PALE \
    { .albedo = V(0.3, 0.27, 0.23) }
#define METAL(r, g, b) \
    { .lobe = GGX, .albedo = V(r, g, b), .alpha = (real)0.2 }
#define MATTE_OF(r, g, b) \
    { .albedo = V(r, g, b) }
#define OUTSIDE(of, x, y, z, ty)                                                           \
    {                                                                                      \
        .mesh = of, .floor = PALE, .lamp = {V(-2.6, 3.6, 2.2), (real)0.9}, .radiance = 16, \
        .eye = V(x, y, z), .target = V(0, ty, 0), .fov = (real)40                          \
    }

static const exhibit exhibits[] = {
    {"sphereflake", shape_sphereflake, 600000,
     OUTSIDE(METAL(0.9, 0.6, 0.25), 0.5, 1, 2.7, -0.05)},
    {"knot", shape_knot, 600000, OUTSIDE(MATTE_OF(0.45, 0.07, 0.04), 0.5, 1, 3.1, 0)},
    {"hills", shape_hills, 600000, OUTSIDE(MATTE_OF(0.14, 0.2, 0.07), 1.1, 1.2, 1.6, -0.05)},
    {"sponge", shape_sponge, 600000, OUTSIDE(MATTE_OF(0.5, 0.38, 0.2), 1.2, 1, 1.9, -0.03)},
    {"cloud", shape_cloud, 20000, OUTSIDE(MATTE_OF(0.6, 0.25, 0.03), 0.5, 1, 3, 0)},
    {"cave",
     shape_cave,
     600000,
     {.mesh = MATTE_OF(0.75, 0.6, 0.45),
      .inside = true,
      .lamp = {V(-0.12, 0.15, -0.1), (real)0.03},
      .radiance = 160,
      .eye = V(0, 0, 0),
      .target = V(0, 0, -1),
      .fov = 70}},
    {"stadium",
     shape_stadium,
     600000,
     {.mesh = MATTE_OF(0.65, 0.6, 0.5),
      .inside = true,
      .lamp = {V(-0.002, 0.006, 0.004), (real)0.001},
      .radiance = 60,
      .eye = V(0.002, 0.001, 0.006),
      .target = V(0, 0, 0),
      .fov = 40}},
};

const exhibit *exhibit_named(const char *name) {
    for (int i = 0; i < COUNT(exhibits); i++)
        if (strcmp(exhibits[i].name, name) == 0) return &exhibits[i];
    return NULL;
}

// ---- any mesh ------------------------------------------------------------------------

aabb mesh_box(const mesh *m) {
    aabb box = aabb_empty;
    for (int i = 0; i < m->count; i++) box = aabb_join(box, aabb_of(mesh_triangle(m, i)));
    return box;
}

// Corner i of the box, seen from its centre.
static vec3 corner_of(aabb box, int i) {
    const vec3 half = scale((real)0.5, sub(box.max, box.min));
    return (vec3){i & 1 ? half.x : -half.x, i & 2 ? half.y : -half.y, i & 4 ? half.z : -half.z};
}

// How far from the target must the eye be? Each corner, x to the right, y up and z towards the
// eye, must stay inside the picture: |x| <= (distance - z) tan(half the width).
static real distance_to_see(aabb box, const camera *cam) {
    const real across = (real)cam->width / 2 / cam->focal,
               along_up = (real)cam->height / 2 / cam->focal;
    real distance = 0;
    for (int i = 0; i < 8; i++) {
        const vec3 c = corner_of(box, i);
        const real x = fabs(dot(c, cam->right)), y = fabs(dot(c, cam->up));
        distance = fmax(distance, fmax(x / across, y / along_up) - dot(c, cam->forward));
    }
    return distance;
}

setting setting_around(aabb box, int width, int height) {
    const real fov = 40;
    const vec3 middle = aabb_centre(box), from = normalize((vec3)V(0.4, 0.45, 1));
    const camera cam =
        camera_look_at(from, (vec3)V(0, 0, 0), (vec3)V(0, 1, 0), fov, width, height);
    const real R = length(sub(box.max, box.min)) / 2,
               distance = (real)1.08 * distance_to_see(box, &cam);
    return (setting){.mesh = MATTE_OF(0.6, 0.55, 0.5),
                     .floor = PALE,
                     .lamp = {add(middle, scale(R, (vec3)V(-2.6, 3.6, 2.2))), (real)0.9 * R},
                     .radiance = 16,
                     .eye = add(middle, scale(distance, from)),
                     .target = middle,
                     .fov = fov};
}

// ---- the stage -----------------------------------------------------------------------

// Bodies in the order of scene_nearest: the lamp, the floor, the mesh.
void stage_set(stage *s, const mesh *m, const bvh *tree, setting how) {
    const aabb box = mesh_box(m);
    const real gap = length(sub(box.max, box.min)) / 2048; // a flat mesh is not in the floor
    *s = (stage){.m = *m, .by_tree = bvh_finder(tree), .how = how};
    s->m.finder = &s->by_tree;
    s->floor = (plane){{0, box.min.y - gap, 0}, {0, 1, 0}};
    int bodies = 0;
    s->surfaces[bodies++].emittance = (color){how.radiance, how.radiance, how.radiance};
    if (!how.inside) s->surfaces[bodies++] = how.floor;
    s->surfaces[bodies++] = how.mesh;
    const scene all = {.spheres = &s->how.lamp,
                       .sphere_count = 1,
                       .planes = &s->floor,
                       .plane_count = how.inside ? 0 : 1,
                       .meshes = &s->m,
                       .mesh_count = 1,
                       .sky = how.inside ? NULL : clear_sky};
    s->room = lit(all, s->surfaces, BY_POWER);
}

void stage_free(stage *s) {
    lit_free(&s->room);
}

color heat(long steps, long black) {
    static const color colors[] = {{0, 0, 0},        {0.1f, 0, 0.2f},  {0, 0.1f, 0.7f},
                                   {0, 0.45f, 0.2f}, {0.85f, 0.7f, 0}, {0.8f, 0.05f, 0},
                                   {1, 1, 1}};
    const real at = fmax(0, log2((real)steps / (real)black));
    const int i = (int)at;
    if (i >= COUNT(colors) - 1) return colors[COUNT(colors) - 1];
    return lerp(colors[i], colors[i + 1], at - (real)i);
}
