// 04-sphere: spheres on the checkered floor, shaded by their normals; open tubes; and what
// the slide's formula makes of a far sphere and of a huge one.
#include "chapters/04-sphere/sphere.h"

static const plane floor_plane = {.x = {0, -1, 0}, .n = {0, 1, 0}};

static const sphere spheres[] = {
    {{0, 0, -4}, 1},
    {{(real)-2.1, (real)-0.3, (real)-4.6}, (real)0.7},
    {{(real)1.9, (real)-0.45, (real)-3.4}, (real)0.55},
    {{(real)-0.95, (real)-0.7, (real)-2.7}, (real)0.3},
    {{(real)0.55, (real)-0.8, (real)-2.4}, (real)0.2},
    {{(real)3.2, (real)0.5, (real)-7.5}, (real)1.5},
    {{(real)-4.6, 0, -8}, 1},
};

static const cylinder tubes[] = {
    {{(real)-1.3, -1, -4}, {(real)-1.3, (real)0.4, -4}, (real)0.7},
    {{(real)0.2, (real)-0.6, (real)-3.2}, {(real)2.2, (real)-0.6, (real)-4.4}, (real)0.4},
    {{(real)0.3, -1, (real)-5.5}, {(real)1.1, (real)1.2, (real)-5.5}, (real)0.25},
};

// ---- colours ------------------------------------------------------------------------

static color sky(vec3 d) {
    const real height = fmax(d.y / length(d), 0);
    return lerp((color){1, 1, 1}, (color){(real)0.35, (real)0.6, 1}, height);
}

static color board(vec3 p) {
    return checks(p.x, p.z) ? (color){(real)0.1, (real)0.3, (real)0.2}
                            : (color){(real)0.9, (real)0.9, (real)0.85};
}

// Every component of a unit normal lies in [-1, 1], every component of a colour in [0, 1].
static color normal_color(vec3 n) {
    return scale((real)0.5, add(n, (vec3){1, 1, 1}));
}

static color floor_or_sky(ray r) {
    const real t = plane_hit(floor_plane, r, 0, NO_HIT);
    return t == NO_HIT ? sky(r.d) : board(ray_at(r, t));
}

// ---- spheres and tubes -----------------------------------------------------------------

typedef real sphere_function(sphere S, ray r, real t_min, real t_max);

// The nearest of all: a sphere found may only be replaced by a nearer one.
static color nearest_sphere(sphere_function *hits, ray r) {
    real t = plane_hit(floor_plane, r, 0, NO_HIT);
    const sphere *nearest = NULL;
    for (int i = 0; i < COUNT(spheres); i++) {
        const real t_sphere = hits(spheres[i], r, 0, t);
        if (t_sphere == NO_HIT) continue;
        t = t_sphere;
        nearest = &spheres[i];
    }
    return nearest ? normal_color(sphere_surface(*nearest, r, t).n) : floor_or_sky(r);
}

static color by_normal(const void *unused, ray r, rng *g) {
    (void)unused, (void)g;
    return nearest_sphere(sphere_hit, r);
}

// The mistake: the larger root, where the ray leaves the sphere.
static real larger_root(sphere S, ray r, real t_min, real t_max) {
    const real t = sphere_hit(S, r, t_min, NO_HIT);
    return t == NO_HIT ? NO_HIT : sphere_hit(S, r, t, t_max);
}

static color with_larger_root(const void *unused, ray r, rng *g) {
    (void)unused, (void)g;
    return nearest_sphere(larger_root, r);
}

// Perpendicular to the axis, outward.
static vec3 tube_normal(cylinder C, vec3 p) {
    const vec3 axis = normalize(sub(C.b, C.a)), from_a = sub(p, C.a);
    return normalize(sub(from_a, scale(dot(from_a, axis), axis)));
}

static color with_tubes(const void *unused, ray r, rng *g) {
    (void)unused, (void)g;
    real t = plane_hit(floor_plane, r, 0, NO_HIT);
    const cylinder *nearest = NULL;
    for (int i = 0; i < COUNT(tubes); i++) {
        const real t_tube = cylinder_hit(tubes[i], r, 0, t);
        if (t_tube == NO_HIT) continue;
        t = t_tube;
        nearest = &tubes[i];
    }
    return nearest ? normal_color(tube_normal(*nearest, ray_at(r, t))) : floor_or_sky(r);
}

// ---- where float ends -------------------------------------------------------------------

// About 2000 radii from the spheres, in a direction that is no axis's. They stand side by side
// at right angles to it: at ±2.7 (1950, 0, -260) / 1967.
static const vec3 far_eye = {260, 355, 1950};

// With the discriminant of exercise far_discriminant, in real arithmetic.
static real far_sphere_hit(sphere S, ray r, real t_min, real t_max) {
    const real discriminant = far_discriminant(S, r);
    if (!(discriminant >= 0)) return NO_HIT;
    const double a = dot(r.d, r.d), middle = -dot(sub(r.O, S.c), r.d) / a;
    const double half = sqrt((double)discriminant) / a;
    return nearest_root((roots){2, middle - half, middle + half}, t_min, t_max);
}

static const struct {
    sphere S;
    sphere_function *hits;
} far_spheres[] = {
    {{{(real)-2.676, 0, (real)0.357}, 1}, sphere_hit_slide},
    {{{0, 0, 0}, 1}, far_sphere_hit},
    {{{(real)2.676, 0, (real)-0.357}, 1}, sphere_hit},
};

// Shaded as most programs do it, from the rounded point: n = (O + t d - c) / r.
static color far_away(const void *unused, ray r, rng *g) {
    (void)unused, (void)g;
    for (int i = 0; i < COUNT(far_spheres); i++) {
        const sphere S = far_spheres[i].S;
        const real t = far_spheres[i].hits(S, r, 0, NO_HIT);
        if (t != NO_HIT) return normal_color(normalize(sub(ray_at(r, t), S.c)));
    }
    return sky(r.d);
}

static const sphere ground = {{0, (real)-1e6, 0}, (real)1e6};

// The left half by the slide's formula, the right half by sphere_hit.
static color on_ground(const void *unused, ray r, rng *g) {
    (void)unused, (void)g;
    sphere_function *const hits = r.d.x < 0 ? sphere_hit_slide : sphere_hit;
    const real t = hits(ground, r, 0, NO_HIT);
    return t == NO_HIT ? sky(r.d) : board(ray_at(r, t));
}

// ---- the program -------------------------------------------------------------------------

static const choice pictures[] = {
    {"spheres", "spheres on the checkered floor, shaded by their normals"},
    {"larger-root", "the mistake: the larger root is taken"},
    {"tubes", "open tubes (exercise cylinder_hit)"},
    {"far", "2000 radii away: slide, far_discriminant, sphere_hit"},
    {"ground", "a ground sphere of radius 10^6: slide left, sphere_hit right"},
    {0},
};

static camera camera_for(const options *opt) {
    const vec3 up = {0, 1, 0}, origin = {0, 0, 0};
    const vec3 eye = {(real)0.2, (real)0.6, 1}, target = {(real)0.1, (real)-0.35, -4};
    const vec3 above_ground = {(real)0.3, 1, (real)0.2};
    const vec3 ahead = {(real)0.3, (real)0.75, (real)-0.8};
    const int w = opt->width, h = opt->height;
    if (shows(opt, "far")) return camera_look_at(far_eye, origin, up, (real)0.145, w, h);
    if (shows(opt, "ground")) return camera_look_at(above_ground, ahead, up, 50, w, h);
    return camera_look_at(eye, target, up, 40, w, h);
}

int main(int argc, char **argv) {
    const program about = {
        .name = "04-sphere",
        .summary = "Draws spheres, and what rounding does to them.",
        .uses = USES_SIZE | USES_SAMPLES | USES_SEED | USES_THREADS | USES_PREVIEW,
        .defaults =
            {.width = 640, .height = 400, .samples = 32, .seed = 1, .out = "04-sphere.png"},
        .shows = pictures,
    };
    const options opt = options_parse(argc, argv, &about);
    const camera cam = camera_for(&opt);
    const radiance f = shows(&opt, "larger-root") ? with_larger_root
                       : shows(&opt, "tubes")     ? with_tubes
                       : shows(&opt, "far")       ? far_away
                       : shows(&opt, "ground")    ? on_ground
                                                  : by_normal;
    image img = render(about.name, &cam, f, NULL, &opt);
    image_write(&img, opt.out);
    image_free(&img);
}
