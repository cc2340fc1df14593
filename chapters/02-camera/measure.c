// measure.c: ways to work out a camera's rays and its axis to the right, their
// error and their cost; and the share of light that finds the camera by itself.
#include "chapters/02-camera/lamp.h"
#include "common/exact3.h"
#include "common/wide3.h"

enum { CASES = 4096, ROUNDS = 9, EYES = 64 };

// Rays of EYES cameras of one kind, that look from different places.
typedef struct {
    camera cam[EYES];
    vec3 corner[EYES], across[EYES], down[EYES]; // for the variant "world corner"
    real x[CASES], y[CASES];
} cases;

// ---- the variants: the direction of a ray ------------------------------------------

static vec3 in_pixels(const cases *c, int i) {
    return camera_ray(&c->cam[i % EYES], c->x[i], c->y[i]).d;
}

static vec3 of_unit_length(const cases *c, int i) {
    return normalize(camera_ray(&c->cam[i % EYES], c->x[i], c->y[i]).d);
}

// As in many a textbook: x and y from -1 to 1, times the tangent of half the angle.
static vec3 by_tangent(const cases *c, int i) {
    const camera *cam = &c->cam[i % EYES];
    const real w = (real)cam->width, h = (real)cam->height, tangent = h / 2 / cam->focal;
    const real u = (2 * c->x[i] / w - 1) * tangent * w / h;
    const real v = (1 - 2 * c->y[i] / h) * tangent;
    return add(add(scale(u, cam->right), scale(v, cam->up)), cam->forward);
}

// The image plane stands in the world, its corner and sides are stored; d is the
// way to its point from the eye.
static vec3 from_world_corner(const cases *c, int i) {
    const int e = i % EYES;
    const vec3 p =
        add(c->corner[e], add(scale(c->x[i], c->across[e]), scale(c->y[i], c->down[e])));
    return sub(p, c->cam[e].eye);
}

static vec3 double_inside(const cases *c, int i) {
    const camera *cam = &c->cam[i % EYES];
    const wide3 ahead = wide_along((wide3){0, 0, 0}, (double)cam->focal, widen(cam->forward));
    const wide3 right =
        wide_along(ahead, (double)c->x[i] - cam->width / 2.0, widen(cam->right));
    return narrow(wide_along(right, cam->height / 2.0 - (double)c->y[i], widen(cam->up)));
}

#define TIMED(f)                                          \
    static void run_##f(void *data) {                     \
        const cases *c = data;                            \
        real sum = 0;                                     \
        for (int i = 0; i < CASES; i++) sum += f(c, i).x; \
        keep((double)sum);                                \
    }
TIMED(in_pixels)
TIMED(of_unit_length)
TIMED(by_tangent)
TIMED(from_world_corner)
TIMED(double_inside)

static const struct {
    const char *name;
    vec3 (*direction)(const cases *c, int i);
    timed run;
} variants[] = {
    {"camera_ray (pixels)", in_pixels, {"pixels", run_in_pixels}},
    {"normalised", of_unit_length, {"normalised", run_of_unit_length}},
    {"tangent, -1 to 1", by_tangent, {"tangent", run_by_tangent}},
    {"corner in the world", from_world_corner, {"corner", run_from_world_corner}},
    {"double inside", double_inside, {"double inside", run_double_inside}},
};

// ---- the cases ----------------------------------------------------------------------

static vec3 direction(rng *g) {
    for (;;) {
        const vec3 v = in_cube(g);
        if (dot(v, v) > (real)0.01 && dot(v, v) <= 1) return normalize(v);
    }
}

// The corner form's image plane: one unit before the eye.
static void place_corner(cases *c, int e) {
    const camera *cam = &c->cam[e];
    const real pixel = 1 / cam->focal;
    const vec3 middle = add(cam->eye, cam->forward);
    const vec3 to_left = scale(-pixel * (real)cam->width / 2, cam->right);
    c->across[e] = scale(pixel, cam->right);
    c->down[e] = scale(-pixel, cam->up);
    c->corner[e] = add(middle, add(to_left, scale(pixel * (real)cam->height / 2, cam->up)));
}

// Right, up and forward are x, y and -z, and nothing is rounded in a basis.
static void along_the_axes(cases *c) {
    for (int e = 0; e < EYES; e++) {
        c->cam[e].right = (vec3){1, 0, 0};
        c->cam[e].up = (vec3){0, 1, 0};
        c->cam[e].forward = (vec3){0, 0, -1};
        place_corner(c, e);
    }
}

static void fill(cases *c, real coordinates, double fov, int size) {
    rng g = rng_seed(1, 2);
    for (int e = 0; e < EYES; e++) {
        const vec3 eye = scale(coordinates, direction(&g));
        const vec3 target = add(eye, scale(coordinates, direction(&g)));
        c->cam[e] = camera_look_at(eye, target, direction(&g), (real)fov, size, size);
        place_corner(c, e);
    }
    for (int i = 0; i < CASES; i++) {
        c->x[i] = (real)(rng_bits(&g) % (uint32_t)size) + (real)0.5;
        c->y[i] = (real)(rng_bits(&g) % (uint32_t)size) + (real)0.5;
    }
}

// (a x b)·c
static exact volume(vec3 a, vec3 b, vec3 c) {
    return ((exact)a.y * b.z - (exact)a.z * b.y) * c.x +
           ((exact)a.z * b.x - (exact)a.x * b.z) * c.y +
           ((exact)a.x * b.y - (exact)a.y * b.x) * c.z;
}

// How far from (x, y) the line along d goes through the image plane, in pixels; the
// picture's width when it is lost altogether. The basis is taken as it is stored, not
// quite perpendicular (Cramer's rule), so this is the error of the ray alone.
static double pixels_off(const camera *cam, real x, real y, vec3 d) {
    const exact ahead = volume(cam->right, cam->up, d);
    const exact a = volume(cam->up, cam->forward, d) * cam->focal / ahead;
    const exact b = volume(cam->forward, cam->right, d) * cam->focal / ahead;
    const double off_x = (double)(a - ((exact)x - cam->width / 2.0));
    const double off_y = (double)(b - (cam->height / 2.0 - (exact)y));
    const double off = hypot(off_x, off_y);
    if (off < 1e-30) return 0; // what 113 bits leave of nothing
    return off < cam->width ? off : cam->width;
}

// ---- the tables: directions -------------------------------------------------------------

static void directions(const cases *c, const char *table, const char *x_name, double x,
                       bool clocked) {
    double ns[COUNT(variants)];
    timed runs[COUNT(variants)];
    for (int v = 0; v < COUNT(variants); v++) runs[v] = variants[v].run, ns[v] = NAN;
    if (clocked) measure_ns(runs, COUNT(variants), (void *)c, CASES, ROUNDS, ns);
    for (int v = 0; v < COUNT(variants); v++) {
        static double error[CASES];
        for (int i = 0; i < CASES; i++)
            error[i] =
                pixels_off(&c->cam[i % EYES], c->x[i], c->y[i], variants[v].direction(c, i));
        csv_row(table, variants[v].name, x_name, x, "pixels off, 99th percentile",
                quantile(error, CASES, 0.99), "ns", ns[v]);
    }
}

// Where a ray meets what lies one unit ahead: the rounding of O + t d, in pixels.
// Beside it the same in a world whose origin is the eye.
static void points_seen(const cases *c, double coordinates) {
    static double world[CASES], relative[CASES];
    for (int i = 0; i < CASES; i++) {
        const camera *cam = &c->cam[i % EYES];
        const ray r = camera_ray(cam, c->x[i], c->y[i]);
        const real t = 1 / cam->focal;
        const vec3 seen = ray_at(r, t);
        // Exact, and only then rounded: a direction that holds the point's error.
        const vec3 d = {(real)((exact)seen.x - r.O.x), (real)((exact)seen.y - r.O.y),
                        (real)((exact)seen.z - r.O.z)};
        world[i] = pixels_off(cam, c->x[i], c->y[i], d);
        relative[i] = pixels_off(cam, c->x[i], c->y[i], ray_at((ray){{0, 0, 0}, r.d}, t));
    }
    const char *table = "camera: point one unit ahead", *error = "pixels off, median";
    csv_row(table, "O + t d in the world", "eye's coordinates", coordinates, error,
            quantile(world, CASES, 0.5), "ns", NAN);
    csv_row(table, "origin in the eye", "eye's coordinates", coordinates, error,
            quantile(relative, CASES, 0.5), "ns", NAN);
}

// ---- the axis to the right ----------------------------------------------------------------

static vec3 naive(vec3 forward, vec3 up) {
    return normalize(cross(forward, up));
}

// Near parallel, another axis takes the place of up.
static vec3 threshold(vec3 forward, vec3 up) {
    const vec3 right = cross(forward, up), a = absolute(forward);
    if (length(right) > (real)1e-3) return normalize(right);
    return normalize(cross(forward, a.x < a.y ? (vec3){1, 0, 0} : (vec3){0, 1, 0}));
}

typedef struct {
    vec3 forward[CASES], up[CASES];
} views;

#define TIMED_RIGHT(f)                                                       \
    static void right_##f(void *data) {                                      \
        const views *v = data;                                               \
        real sum = 0;                                                        \
        for (int i = 0; i < CASES; i++) sum += f(v->forward[i], v->up[i]).x; \
        keep((double)sum);                                                   \
    }
TIMED_RIGHT(naive)
TIMED_RIGHT(threshold)
TIMED_RIGHT(camera_right)

static const struct {
    const char *name;
    vec3 (*right)(vec3 forward, vec3 up);
    timed run;
} rights[] = {
    {"cross and normalise", naive, {"naive", right_naive}},
    {"|cross| < 1e-3: another axis", threshold, {"threshold", right_threshold}},
    {"camera_right", camera_right, {"camera_right", right_camera_right}},
};

static bool orthonormal(vec3 right, vec3 forward) {
    const double allowed = sizeof(real) == 4 ? 3e-7 : 6e-16;
    const double size = sqrt(wide_dot(widen(right), widen(right)));
    return fabs(size - 1) <= allowed && fabs(wide_dot(widen(right), widen(forward))) <= allowed;
}

// Is right where forward x up says, to a degree? Not asked where that is noise.
static bool turned(vec3 right, vec3 forward, vec3 up) {
    const wide3 across = wide_cross(widen(forward), widen(up));
    const double along = wide_dot(across, widen(right)), size = sqrt(wide_dot(across, across));
    return !(is_finite(right) && along > 0.9998 * size); // cos 1°
}

static void axes(const views *w, const char *table, const char *x_name, double x,
                 bool by_turn) {
    double ns[COUNT(rights)];
    timed runs[COUNT(rights)];
    for (int v = 0; v < COUNT(rights); v++) runs[v] = rights[v].run;
    measure_ns(runs, COUNT(rights), (void *)w, CASES, ROUNDS, ns);
    for (int v = 0; v < COUNT(rights); v++) {
        long wrong = 0;
        for (int i = 0; i < CASES; i++) {
            const vec3 right = rights[v].right(w->forward[i], w->up[i]);
            wrong += by_turn ? turned(right, w->forward[i], w->up[i])
                             : !orthonormal(right, w->forward[i]);
        }
        csv_row(table, rights[v].name, x_name, x,
                by_turn ? "share turned by over 1°, or NaN" : "share skew or NaN",
                (double)wrong / CASES, "ns", ns[v]);
    }
}

// up = size (forward + angle times something): parallel but for about that angle.
static void look(views *w, double angle, double size) {
    rng g = rng_seed(2, 2);
    for (int i = 0; i < CASES; i++) {
        w->forward[i] = direction(&g);
        const vec3 aside = scale((real)angle, direction(&g));
        w->up[i] = scale((real)size, add(w->forward[i], aside));
    }
}

// ---- the light that finds the camera --------------------------------------------------------

static void arrivals(double radius) {
    const long rays = 4000000;
    const camera cam = lamp_camera(96, 60, (real)radius);
    long reached;
    image img = lamp_forwards("forwards", &cam, &demo_lamp, rays, 1, &reached);
    image_free(&img);
    const char *table = "light: share of rays that reach the camera";
    csv_row(table, "forwards", "lens radius", radius, "share", (double)reached / (double)rays,
            "ns", NAN);
    csv_row(table, "backwards", "lens radius", radius, "share", 1, "ns", NAN);
}

int main(void) {
    static cases c;
    static const double fovs[] = {1e-3, 1e-2, 0.1, 1, 10, 60, 120, 179};
    for (int i = 0; i < COUNT(fovs); i++) {
        fill(&c, 1, fovs[i], 1024);
        directions(&c, "camera: direction, field of view", "degrees", fovs[i], true);
        along_the_axes(&c);
        directions(&c, "camera: direction, looking along -z", "degrees", fovs[i], false);
    }
    for (int size = 1; size <= 16384; size *= 4) {
        fill(&c, 1, 60, size);
        directions(&c, "camera: direction, size of the picture", "pixels a side", size, false);
    }
    for (int k = 0; k <= 9; k += 3) {
        fill(&c, (real)pow(10, k), 60, 1024);
        directions(&c, "camera: direction, eye far from the origin", "coordinates", pow(10, k),
                   false);
        points_seen(&c, pow(10, k));
    }
    static views w;
    for (int k = 0; k >= -9; k--) {
        look(&w, pow(10, k), 1);
        axes(&w, "camera_right: skew near parallel", "angle, radians", pow(10, k), false);
        axes(&w, "camera_right: turned near parallel", "angle, radians", pow(10, k), true);
    }
    for (int k = -30; k <= 30; k += 10) {
        look(&w, 1, pow(10, k));
        axes(&w, "camera_right: length of up", "|up|", pow(10, k), true);
    }
    for (int i = 0; i < 6; i++) arrivals(ldexp(0.025, i));
    arrivals(0);
}
