// 05-triangle: the triangles of 01-rasterize, traced; a mesh, flat and smooth; and
// what gets through between two triangles that share an edge.
#include "chapters/05-triangle/triangle.h"

// ---- the triangles of 01 ---------------------------------------------------------

// The index, or -1. The first of the equally near stays, as in the z-buffer.
static int nearest_triangle(ray r, triangle_point *nearest) {
    int index = -1;
    *nearest = (triangle_point){NO_HIT, 0, 0};
    for (int i = 0; i < demo_triangle_count; i++) {
        const triangle_point q = triangle_hit(demo_triangles[i].t, r, 0, nearest->t);
        if (q.t == NO_HIT) continue;
        *nearest = q;
        index = i;
    }
    return index;
}

static color paint_seen(const void *unused, ray r, rng *g) {
    (void)unused, (void)g;
    triangle_point q;
    const int i = nearest_triangle(r, &q);
    return i < 0 ? demo_background : demo_triangles[i].paint;
}

// The weights of p1, p2 and p3 as red, green and blue.
static color weights_seen(const void *unused, ray r, rng *g) {
    (void)unused, (void)g;
    triangle_point q;
    if (nearest_triangle(r, &q) < 0) return demo_background;
    return (color){1 - q.u - q.v, q.u, q.v};
}

static image draw_demo(const char *name, const options *opt, radiance f) {
    const vec3 eye = {0, 0, 0}, target = {0, 0, -1}, up = {0, 1, 0};
    const camera cam = camera_look_at(eye, target, up, DEMO_FOV, opt->width, opt->height);
    return render(name, &cam, f, NULL, opt);
}

// ---- a mesh --------------------------------------------------------------------------

static const vec3 axis = {(real)0.35, 1, (real)0.8};

static color lit(vec3 n) {
    const vec3 towards_lamp = {(real)0.5, (real)0.7, (real)0.5};
    const real light = (real)0.1 + (real)0.9 * fmax(dot(n, towards_lamp), 0);
    return scale(light, (color){(real)0.9, (real)0.75, (real)0.45});
}

// Left of the middle each triangle has its own normal, to the right the points have.
static color flat_and_smooth(const void *scene, ray r, rng *g) {
    (void)g;
    const mesh *m = scene;
    int i = 0;
    const triangle_point q = mesh_hit(m, r, 0, NO_HIT, &i);
    if (q.t == NO_HIT) return demo_background;
    if (r.d.x < 0) return lit(triangle_surface(mesh_triangle(m, i), r, q).n);
    return lit(mesh_surface(m, i, r, q).n);
}

static image draw_mesh(const char *name, const options *opt) {
    mesh torus = mesh_torus((vec3){0, 0, -4}, axis, 1, (real)0.45, 24, 12);
    const vec3 eye = {0, 0, 0}, target = {0, 0, -1}, up = {0, 1, 0};
    const camera cam = camera_look_at(eye, target, up, 40, opt->width, opt->height);
    const image img = render(name, &cam, flat_and_smooth, &torus, opt);
    mesh_free(&torus);
    return img;
}

// ---- leaks ---------------------------------------------------------------------------

typedef struct {
    mesh torus;
    triangle_point (*hit)(triangle T, ray r, real t_min, real t_max);
} closed;

// The torus is closed: who sees the inner side looks through a gap.
static color outside_or_gap(const void *scene, ray r, rng *g) {
    (void)g;
    const closed *c = scene;
    color seen = demo_background;
    real t = NO_HIT;
    for (int i = 0; i < c->torus.count; i++) {
        const triangle T = mesh_triangle(&c->torus, i);
        const triangle_point q = c->hit(T, r, 0, t);
        if (q.t == NO_HIT) continue;
        const hit h = triangle_surface(T, r, q);
        const real shade = i % 2 ? (real)0.75 : (real)0.45;
        seen = h.front ? scale(shade, (color){(real)0.9, (real)0.75, (real)0.45})
                       : (color){(real)0.9, 0, (real)0.1};
        t = q.t;
    }
    return seen;
}

enum { ZOOM = 5 }; // a ray is drawn as a square of 5 x 5 pixels

static image enlarged(const image *small, int width, int height) {
    const image img = image_new(width, height);
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++)
            *image_at(&img, x, y) = *image_at(small, x / ZOOM, y / ZOOM);
    return img;
}

// A corner of the torus under so strong a magnification that the directions of
// neighbouring rays differ by a few steps of float.
static image draw_leaks(const char *name, const options *opt, bool sealed) {
    closed c = {mesh_torus((vec3){0, 0, -4}, axis, 1, (real)0.45, 24, 12),
                sealed ? triangle_hit : triangle_hit_slide};
    const real fov = 1700 * REAL_EPSILON; // degrees: 2e-4 in float
    const int width = 1 + (opt->width - 1) / ZOOM, height = 1 + (opt->height - 1) / ZOOM;
    const vec3 eye = {0, 0, 0}, corner = c.torus.points[18 * 12 + 2], up = {0, 1, 0};
    const camera cam = camera_look_at(eye, corner, up, fov, width, height);
    image small = render(name, &cam, outside_or_gap, &c, opt);
    const image img = enlarged(&small, opt->width, opt->height);
    image_free(&small);
    mesh_free(&c.torus);
    return img;
}

static const choice pictures[] = {
    {"triangles", "the triangles of 01-rasterize, traced: the same pixels"},
    {"barycentric", "the weights of the corners as red, green and blue"},
    {"mesh", "a torus: flat to the left, smooth to the right"},
    {"leaks",
     "the inside test at a shared corner, 200000 times magnified; red: a gap, blue: two"},
    {"sealed", "the same with triangle_hit"},
    {0},
};

static image draw(const char *name, const options *opt) {
    if (shows(opt, "barycentric")) return draw_demo(name, opt, weights_seen);
    if (shows(opt, "mesh")) return draw_mesh(name, opt);
    if (shows(opt, "leaks")) return draw_leaks(name, opt, false);
    if (shows(opt, "sealed")) return draw_leaks(name, opt, true);
    return draw_demo(name, opt, paint_seen);
}

int main(int argc, char **argv) {
    const program about = {
        .name = "05-triangle",
        .summary = "Draws the triangles of 01-rasterize by tracing rays, and a mesh.",
        .uses = USES_SIZE | USES_SAMPLES | USES_SEED | USES_THREADS | USES_PREVIEW,
        .defaults =
            {.width = 640, .height = 400, .samples = 1, .seed = 1, .out = "05-triangle.png"},
        .shows = pictures,
    };
    const options opt = options_parse(argc, argv, &about);
    image img = draw(about.name, &opt);
    image_write(&img, opt.out);
    image_free(&img);
}
