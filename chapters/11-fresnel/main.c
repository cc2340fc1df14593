// 11-fresnel: glass and metals. Two of the pictures prove what they show: the program
// measures in them what must be there, and fails when it is not.
#include "chapters/09-path-tracer/box.h"
#include "chapters/11-fresnel/proofs.h"
#include "common/die.h"

#define V(x, y, z) \
    { (real)(x), (real)(y), (real)(z) }

typedef struct {
    glass_room room;
    int s; // bounces at most
} job;

static color look(const void *data, ray r, rng *g) {
    const job *j = data;
    return glass_trace(&j->room, r, j->s, g);
}

static image draw(const options *opt, const camera *cam, radiance f, const void *data) {
    return render("11-fresnel", cam, f, data, opt);
}

// A scene with no lamp but its sky.
static image draw_under_sky(const options *opt, const camera *cam, scene bodies,
                            const surface *surfaces, const substance *of) {
    job j = {{lit(bodies, surfaces, BY_BRDF), of, {0}}, opt->depth};
    const image img = draw(opt, cam, look, &j);
    lit_free(&j.room.room);
    return img;
}

// A checkered floor infinitely far below, under a clear sky.
static color board_sky(vec3 d) {
    if (d.y >= 0) return clear_sky(d);
    const int light = checks(2 * d.x / d.y, 2 * d.z / d.y);
    return light ? (color)V(0.75, 0.75, 0.7) : (color)V(0.1, 0.25, 0.18);
}

// ---- box: chapter 09's room with a ball of gold and one of glass -------------------

static image show_box(const options *opt) {
    surface surfaces[BOX_BODIES];
    for (int i = 0; i < BOX_BODIES; i++) {
        const matte m = box_surfaces[i];
        surfaces[i] = (surface){.albedo = m.albedo, .emittance = m.emittance};
    }
    const substance of[BOX_BODIES] = {
        [BALL_LEFT] = {.kind = METAL, .metal = &metals[0]},
        [BALL_RIGHT] = {.kind = GLASS, .n = (real)1.5},
    };
    job j = {{lit(box_bodies, surfaces, BY_POWER), of, {0}}, opt->depth};
    const camera cam = box_camera(opt->width, opt->height);
    const image img = draw(opt, &cam, look, &j);
    lit_free(&j.room.room);
    return img;
}

// ---- rows of balls on a floor --------------------------------------------------------

enum { ROW_MOST = 8 };
static const plane ground = {V(0, 0, 0), V(0, 1, 0)};

// As many balls as there are radii, side by side on a brown floor.
static image draw_row(const options *opt, const real *radii, int count, const substance *of) {
    sphere row[ROW_MOST];
    surface surfaces[ROW_MOST + 1] = {{0}};
    real x = 0;
    for (int i = 0; i < count; i++) {
        x += radii[i];
        row[i] = (sphere){{x, radii[i], 0}, radii[i]};
        x += radii[i] + (real)0.2;
    }
    const real half = (x - (real)0.2) / 2;
    for (int i = 0; i < count; i++) row[i].c.x -= half;
    surfaces[count].albedo = (color)V(0.5, 0.4, 0.32);
    const scene bodies = {.spheres = row,
                          .sphere_count = count,
                          .planes = &ground,
                          .plane_count = 1,
                          .sky = clear_sky};
    const vec3 eye = {0, 3, 14}, target = {0, radii[count - 1], 0};
    const camera cam = camera_across(eye, target, half + (real)0.3, opt->width, opt->height);
    return draw_under_sky(opt, &cam, bodies, surfaces, of);
}

static image show_metals(const options *opt) {
    substance of[ROW_MOST] = {{0}};
    const real radii[] = {1, 1, 1, 1, 1, 1, 1};
    for (int i = 0; metals[i].name; i++)
        of[i] = (substance){.kind = METAL, .metal = &metals[i]};
    return draw_row(opt, radii, COUNT(radii), of);
}

// The same green glass, thicker and thicker.
static image show_absorb(const options *opt) {
    const substance green = {.kind = GLASS, .n = (real)1.5, .sigma = V(0.9, 0.15, 0.6)};
    const substance of[ROW_MOST] = {green, green, green};
    const real radii[] = {(real)0.35, (real)0.7, (real)1.4};
    return draw_row(opt, radii, COUNT(radii), of);
}

// ---- fresnel-schlick: both rays of each boundary followed, so that nothing is noise ------

typedef real reflectance(real cosine, real eta);

typedef struct {
    sphere ball;
    real n;
    reflectance *R;
} lone_ball;

// Recursive, with two rays out of one: 2^s in all. A picture of one ball can afford it.
static color split(const lone_ball *b, ray r, int s) {
    const real t = sphere_hit(b->ball, r, 0, NO_HIT);
    if (t == NO_HIT) return board_sky(r.d);
    if (s == 0) return (color){0, 0, 0};
    const hit h = sphere_surface(b->ball, r, t);
    const vec3 n = h.front ? h.n : neg(h.n);
    const real eta = h.front ? b->n : 1 / b->n;
    vec3 through;
    const bool passes = refract(r.d, n, eta, &through);
    const real R = passes ? b->R(fmin(-dot(r.d, n), 1), eta) : 1;
    const ray back = {offset_origin(h.p, h.error, n, n), keep_unit(reflect(r.d, n))};
    color L = scale(R, split(b, back, s - 1));
    if (!passes) return L;
    const ray on = {offset_origin(h.p, h.error, neg(n), neg(n)), through};
    return add(L, scale(1 - R, split(b, on, s - 1)));
}

static color look_split(const void *data, ray r, rng *g) {
    (void)g;
    return split(data, (ray){r.O, normalize(r.d)}, 6);
}

static image draw_split(const options *opt, reflectance *R) {
    const lone_ball b = {{{0, 0, 0}, 1}, (real)1.5, R};
    const vec3 eye = {0, (real)0.6, 5}, target = {0, 0, 0};
    const camera cam =
        camera_across(eye, target, (real)1.15, image_part_width(opt->width, 0, 4), opt->height);
    return draw(opt, &cam, look_split, &b);
}

// Ten times |a - b|.
static image difference(const image *a, const image *b) {
    image d = image_new(a->width, a->height);
    for (int i = 0; i < a->width * a->height; i++)
        d.pixels[i] = scale(10, absolute(sub(a->pixels[i], b->pixels[i])));
    return d;
}

// Exact, Schlick, and ten times how far off he is: with the right cosine, and as the
// slide's formula may be read, with the ray's own on both sides.
static image show_schlick(const options *opt) {
    image parts[4] = {draw_split(opt, fresnel_dielectric), draw_split(opt, schlick)};
    image slide = draw_split(opt, schlick_slide);
    parts[2] = difference(&parts[0], &parts[1]);
    parts[3] = difference(&parts[0], &slide);
    image_free(&slide);
    return image_side_by_side(parts, COUNT(parts));
}

// ---- nested: a ball of glass, filled with water, with a bubble in it ---------------------

enum { OUTER, HOLLOW, WATER, BUBBLE, NESTED_BODIES };

static const substance nested[NESTED_BODIES] = {
    [OUTER] = {.kind = GLASS, .n = (real)1.5, .priority = 1},
    [HOLLOW] = {.kind = GLASS, .n = 1, .priority = 2},
    [WATER] = {.kind = GLASS, .n = (real)1.33, .priority = 3},
    [BUBBLE] = {.kind = GLASS, .n = 1, .priority = 4},
};

// Radius 0: there is none.
static image draw_nested(const options *opt, real hollow, real water) {
    const sphere balls[NESTED_BODIES] = {[OUTER] = {V(0, 0, 0), 1},
                                         [HOLLOW] = {V(0, 0, 0), hollow},
                                         [WATER] = {V(0, 0, 0), water},
                                         [BUBBLE] = {V(-0.3, 0.3, 0.2), (real)0.25}};
    const surface surfaces[NESTED_BODIES] = {{.alpha = 0}};
    const scene bodies = {.spheres = balls, .sphere_count = NESTED_BODIES, .sky = board_sky};
    const vec3 eye = {0, (real)0.7, 6}, target = {0, 0, 0};
    const camera cam =
        camera_across(eye, target, (real)1.15, image_part_width(opt->width, 0, 3), opt->height);
    return draw_under_sky(opt, &cam, bodies, surfaces, nested);
}

// Left: the water overlaps the glass, and its priority says that it is there. Middle: the glass
// is hollow, and the water's surface is the hollow's: a ray meets one of the two. Right: the water
// is a thousandth smaller, with a film of air around it.
static image show_nested(const options *opt) {
    const real size = (real)0.9;
    image parts[] = {draw_nested(opt, 0, size), draw_nested(opt, size, size),
                     draw_nested(opt, size, size * (real)0.999)};
    return image_side_by_side(parts, COUNT(parts));
}

// ---- the two that prove what they show: proofs.c -----------------------------------------

static image show_caustic(const options *opt) {
    image floors[FLOORS];
    const int failed = prove_caustic(opt, floors);
    if (failed) die(EXIT_RUN, "%d claims about the caustic fail", failed);
    image all = image_side_by_side(floors, FLOORS);
    for (int i = 0; i < all.width * all.height; i++) { // light of any strength to 0 .. 1
        const real E = all.pixels[i].y;
        all.pixels[i] = scale(1 / (2 + E), all.pixels[i]);
    }
    return all;
}

static image show_critical(const options *opt) {
    image window;
    const int failed = prove_window(opt, &window);
    if (failed) die(EXIT_RUN, "%d claims about the window fail", failed);
    for (int i = 0; i < window.width * window.height; i++)
        window.pixels[i] = scale((real)0.4, window.pixels[i]);
    return window;
}

// ---- the program ---------------------------------------------------------------------------

static image show(const options *opt) {
    if (shows(opt, "metals")) return show_metals(opt);
    if (shows(opt, "absorb")) return show_absorb(opt);
    if (shows(opt, "fresnel-schlick")) return show_schlick(opt);
    if (shows(opt, "nested")) return show_nested(opt);
    if (shows(opt, "caustic")) return show_caustic(opt);
    if (shows(opt, "critical")) return show_critical(opt);
    return show_box(opt);
}

static const choice pictures[] = {
    {"box", "a ball of gold and one of glass in chapter 09's room"},
    {"metals", "gold, silver, copper, aluminium, iron, chromium, tungsten"},
    {"fresnel-schlick",
     "exact, Schlick, ten times his error; the same with the slide's cosine"},
    {"absorb", "three thicknesses of green glass"},
    {"nested", "water in glass: overlapping, touching, with a film of air"},
    {"caustic", "light gathered by a ball of glass: checked against light traced forwards"},
    {"critical", "the sky from under water: checked against Snell and Fresnel"},
    {0},
};

int main(int argc, char **argv) {
    const program about = {
        .name = "11-fresnel",
        .summary = "Draws glass and metals, with Snell's law and Fresnel's formulas.",
        .uses = USES_SIZE | USES_SAMPLES | USES_DEPTH | USES_SEED | USES_THREADS | USES_PREVIEW,
        .defaults = {.width = 320,
                     .height = 320,
                     .samples = 128,
                     .depth = 32,
                     .seed = 1,
                     .out = "11-fresnel.png"},
        .shows = pictures,
    };
    const options opt = options_parse(argc, argv, &about);
    image img = show(&opt);
    image_write(&img, opt.out);
    image_free(&img);
}
