// Right: another method and other code: made of the chapters' modules, lamps and BRDF by the
// power heuristic. Nothing of the solution is used.
#include <stdlib.h>
#include <string.h>

#include "chapters/10-importance-sampling/scenes.h"

#define V(x, y, z) \
    { (real)(x), (real)(y), (real)(z) }
enum { SPP = 24, WIDTH = 128, HEIGHT = 96 };

// ---- scene 1 -------------------------------------------------------------------------

static const sphere three[] = {{V(0.45, 0.5, 0.9), (real)0.45},
                               {V(-0.8, 0.9, -0.4), (real)0.9},
                               {V(2.5, 2.2, 8), (real)1.2}};
static const plane ground = {V(0, 0, 0), V(0, 1, 0)};
static const vec3 corners[] = {V(0.3, 0.2, -1.2), V(1.1, 2.3, -1.9), V(2.4, 0.5, -1.6)};
static const int one[][3] = {{0, 1, 2}};
static const mesh triangle_mesh = {
    .points = corners, .corners = one, .count = 1, .around = {V(1.3, 1.3, -1.5), 2}};
static const scene shapes_bodies = {.spheres = three,
                                    .sphere_count = COUNT(three),
                                    .planes = &ground,
                                    .plane_count = 1,
                                    .meshes = &triangle_mesh,
                                    .mesh_count = 1};

static color depth(const void *sc, ray r, rng *g) {
    (void)g;
    int body = 0;
    r.d = normalize(r.d);
    const hit h = scene_nearest(sc, r, 0, NO_HIT, &body);
    return h.t == NO_HIT ? (color){0, 0, 0} : (color){h.t, h.t, h.t};
}

static color normal(const void *sc, ray r, rng *g) {
    (void)g;
    int body = 0;
    const hit h = scene_nearest(sc, r, 0, NO_HIT, &body);
    if (h.t == NO_HIT) return (color){0, 0, 0};
    return h.front ? h.n : neg(h.n);
}

// ---- scene 2 -------------------------------------------------------------------------

static const sphere balls[] = {
    {V(-1.05, 1, -0.3), 1}, {V(0.95, 0.7, 0.4), (real)0.7}, {V(0.1, 0.3, 1.3), (real)0.3}};
static const color tints[] = {V(0.9, 0.9, 0.9), V(0.95, 0.75, 0.4), V(0.8, 0.15, 0.1)};
static const scene mirror_bodies = {
    .spheres = balls, .sphere_count = COUNT(balls), .planes = &ground, .plane_count = 1};

static color check(vec3 p) {
    const bool even = ((int)floor(p.x) + (int)floor(p.z)) % 2 == 0;
    return even ? (color)V(0.9, 0.85, 0.7) : (color)V(0.15, 0.2, 0.3);
}

static color mirror(const void *sc, ray r, rng *g) {
    int body = 0;
    r.d = normalize(r.d);
    const hit h = scene_nearest(sc, r, 0, NO_HIT, &body);
    if (h.t == NO_HIT) {
        const real s = r.d.y > 0 ? r.d.y : 0;
        return lerp((color)V(1, 1, 1), (color)V(0.25, 0.45, 0.9), s);
    }
    if (body == 3) return check(h.p);
    if (body == 2) return tints[2];
    const vec3 d = reflect(r.d, h.n);
    return mul(tints[body], mirror(sc, (ray){offset_origin(h.p, h.error, h.n, d), d}, g));
}

// ---- scene 3 -------------------------------------------------------------------------

static const sphere box_balls[] = {{V(-0.42, 0.45, -0.35), (real)0.45},
                                   {V(0.5, 0.3, 0.3), (real)0.3}};
static const plane walls[] = {{V(-1, 0, 0), V(1, 0, 0)},
                              {V(1, 0, 0), V(-1, 0, 0)},
                              {V(0, 0, 0), V(0, 1, 0)},
                              {V(0, 2, 0), V(0, -1, 0)},
                              {V(0, 0, -1), V(0, 0, 1)}};
static const vec3 lamp_points[] = {V(-0.35, 1.9, -0.5), V(0.45, 1.9, -0.5), V(0.45, 1.9, 0.3),
                                   V(-0.35, 1.9, 0.3)};
static const int lamp_corners[][3] = {{0, 1, 2}, {0, 2, 3}};
static const mesh lamp_mesh = {.points = lamp_points,
                               .corners = lamp_corners,
                               .count = 2,
                               .around = {V(0.05, 1.9, -0.1), (real)0.6}};
#define WHITE \
    { .albedo = V(0.7, 0.68, 0.62) }
static const surface surfaces[] = {{.albedo = V(0.3, 0.45, 0.7)},
                                   {.albedo = V(0.72, 0.55, 0.2)},
                                   {.albedo = V(0.6, 0.1, 0.08)},
                                   {.albedo = V(0.12, 0.4, 0.15)},
                                   WHITE,
                                   WHITE,
                                   WHITE,
                                   {.emittance = V(11, 9, 6)}};
static const scene room_bodies = {.spheres = box_balls,
                                  .sphere_count = COUNT(box_balls),
                                  .planes = walls,
                                  .plane_count = COUNT(walls),
                                  .meshes = &lamp_mesh,
                                  .mesh_count = 1};

static color path(const void *sc, ray r, rng *g) {
    return light_trace(sc, r, 100, g);
}

int main(int argc, char **argv) {
    if (argc < 4) return 2;
    const char *name = argv[1];
    options opt = {.samples = 1, .seed = strtoull(argv[3], NULL, 10)};
    const bool first = strcmp(name, "depth") == 0 || strcmp(name, "normal") == 0;
    camera cam = camera_look_at((vec3)V(1.2, 1.7, 4.1), (vec3)V(-0.1, 0.6, 0), (vec3)V(0, 1, 0),
                                50, WIDTH, HEIGHT);
    if (strcmp(name, "mirror") == 0)
        cam = camera_look_at((vec3)V(0.4, 1.3, 5.2), (vec3)V(0.1, 0.8, 0), (vec3)V(0, 1, 0), 42,
                             WIDTH, HEIGHT);
    image img;
    if (strcmp(name, "path") == 0) {
        const lit_room lit_box = lit(room_bodies, surfaces, BY_POWER);
        cam = camera_look_at((vec3)V(0.1, 1.05, 3.3), (vec3)V(0, 0.95, 0), (vec3)V(0, 1, 0), 40,
                             WIDTH, HEIGHT);
        opt.samples = SPP;
        img = render("box", &cam, path, &lit_box, &opt);
    } else if (first) {
        img = render(name, &cam, name[0] == 'd' ? depth : normal, &shapes_bodies, &opt);
    } else {
        img = render(name, &cam, mirror, &mirror_bodies, &opt);
    }
    image_write(&img, argv[2]);
}
