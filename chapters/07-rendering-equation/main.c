// 07-rendering-equation: a floor under three lights and the hemisphere above a point,
// every integral a sum over directions or over the light; form factors beside their
// closed forms, and what the same sum costs in one to eight dimensions.
#include <stdio.h>

#include "chapters/07-rendering-equation/rendering.h"

#define PAINT(r, g, b) \
    { (real)(r), (real)(g), (real)(b) }

static const vec3 up = {0, 1, 0};

// ---- three lights over a floor -----------------------------------------------------

static const sphere ball = {{(real)-2.1, (real)0.95, (real)0.2}, (real)0.6};
static const disc plate = {{{(real)0.1, (real)1.35, (real)-0.5}, {(real)0.1, 1, (real)0.15}},
                           (real)0.8};
static const rectangle panel = {
    {(real)2.6, (real)0.15, (real)0.9}, {0, (real)1.2, 0}, {(real)-0.5, 0, (real)-1.5}};

typedef struct {
    radiance_field L_i; // 1 where it is seen, 0 elsewhere
    const void *light;
    color radiance;
} lamp;

static const lamp lamps[] = {
    {from_sphere, &ball, PAINT(3.2, 1.7, 0.8)},
    {from_disc, &plate, PAINT(0.9, 2.0, 1.0)},
    {from_rectangle, &panel, PAINT(0.9, 1.7, 4.0)},
};

// What arrives of the lamps from w. They do not hide each other: that takes the rays of
// chapter 09.
static color lamps_seen(vec3 x, vec3 w) {
    color sum = {0, 0, 0};
    for (int k = 0; k < COUNT(lamps); k++)
        sum = add(sum, scale((real)lamps[k].L_i(lamps[k].light, x, w), lamps[k].radiance));
    return sum;
}

// ---- the floor -----------------------------------------------------------------------

// E of each lamp at x.
typedef void solver(vec3 x, double *E);

enum { RINGS = 12, SECTORS = 32 }; // few, so that their bands are seen

static void by_hemisphere(vec3 x, double *E) {
    for (int k = 0; k < COUNT(lamps); k++)
        E[k] = irradiance(lamps[k].L_i, lamps[k].light, x, up, RINGS, SECTORS);
}

static void by_light(vec3 x, double *E) {
    E[0] = sphere_irradiance(ball, x, up);
    E[1] = disc_irradiance(plate, x, up, 8, 24);
    E[2] = rectangle_irradiance_by_area(GAUSS, 6, panel, x, up);
}

static const plane floor_plane = {.x = {0, 0, 0}, .n = {0, 1, 0}};
static const double floor_rho = 0.8;

static color floor_color(vec3 x, solver *solve) {
    double E[COUNT(lamps)];
    solve(x, E);
    color L_o = {0, 0, 0};
    for (int k = 0; k < COUNT(lamps); k++)
        L_o = add(L_o, scale((real)(lambert_brdf(floor_rho) * E[k]), lamps[k].radiance));
    return L_o;
}

// Of a lamp's own radiance, or all would be white: the picture ends at 1.
static const real lamp_shown = (real)0.25;

typedef struct {
    solver *solve;
} floor_job;

static color look_at_floor(const void *data, ray r, rng *g) {
    (void)g;
    const floor_job *job = data;
    const vec3 w = normalize(r.d);
    const color L = lamps_seen(r.O, w);
    if (dot(L, L) > 0) return scale(lamp_shown, L);
    const real t = plane_hit(floor_plane, r, 0, NO_HIT);
    return t < NO_HIT ? floor_color(ray_at(r, t), job->solve) : (color){0, 0, 0};
}

static image draw_floor(const options *opt, solver *solve) {
    const vec3 eye = {0, (real)3.1, (real)6.2}, target = {0, (real)0.45, 0};
    const camera cam = camera_look_at(eye, target, up, 31, opt->width, opt->height / 2);
    const floor_job job = {solve};
    return render("07-rendering-equation", &cam, look_at_floor, &job, opt);
}

// The second under the first. Frees both.
static image one_above_other(image top, image bottom) {
    image all = image_new(top.width, top.height + bottom.height);
    for (int y = 0; y < all.height; y++)
        for (int x = 0; x < all.width; x++)
            *image_at(&all, x, y) =
                y < top.height ? *image_at(&top, x, y) : *image_at(&bottom, x, y - top.height);
    image_free(&top);
    image_free(&bottom);
    return all;
}

static image show_floor(const options *opt) {
    const image top = draw_floor(opt, by_hemisphere);
    return one_above_other(top, draw_floor(opt, by_light));
}

// ---- several panels in one picture -----------------------------------------------------

// So many columns that `count` square panels in rows become as large as can be.
static int best_columns(int count, int width, int height) {
    int best = 1;
    double largest = 0;
    for (int columns = 1; columns <= count; columns++) {
        const int rows = (count + columns - 1) / columns;
        const double size = fmin((double)width / columns, (double)height / rows);
        if (size > largest) largest = size, best = columns;
    }
    return best;
}

// ---- the hemisphere above a point, as a fish-eye sees it -------------------------------

static const vec3 fish_eye = {(real)-0.5, 0, (real)0.6};

typedef struct {
    bool flat;   // the radius in the picture is sin θ, not θ
    bool cosine; // L_i cos θ
    bool dots;   // the directions of the sum
} fish_panel;

static const fish_panel fish_panels[] = {{.dots = true}, {.cosine = true}, {.flat = true}};

// Near the middle of a cell of the sum? In units of the picture's radius.
static bool on_dot(double theta, double phi, double size) {
    const double d_theta = PI / 2 / RINGS, d_phi = 2 * PI / SECTORS;
    const double off = theta - (floor(theta / d_theta) + 0.5) * d_theta;
    const double turn = phi - (floor(phi / d_phi) + 0.5) * d_phi;
    const double aside = theta * turn / (PI / 2), along = off / (PI / 2);
    return along * along + aside * aside < size * size;
}

// (u, v): in units of the picture's radius, v upwards: away from the camera.
static color fish_color(const fish_panel *p, double u, double v) {
    const double r = sqrt(u * u + v * v), phi = atan2(v, u);
    if (r >= 1) return (color){0, 0, 0};
    const double theta = p->flat ? asin(r) : PI / 2 * r;
    const vec3 w = {(real)(sin(theta) * cos(phi)), (real)cos(theta),
                    (real)(-sin(theta) * sin(phi))};
    const color dark = PAINT(0.025, 0.03, 0.045);
    color L = add(scale(lamp_shown, lamps_seen(fish_eye, w)), dark);
    if (p->cosine) L = scale((real)cos(theta), L);
    return p->dots && on_dot(theta, phi, 0.012) ? (color)PAINT(0.4, 0.4, 0.4) : L;
}

// The mean over `fine` x `fine` points of the pixel.
static color fish_pixel(const fish_panel *p, int x, int y, int size) {
    enum { FINE = 4 };
    color sum = {0, 0, 0};
    for (int k = 0; k < FINE * FINE; k++) {
        const double u = x + (k % FINE + 0.5) / FINE, v = y + (k / FINE + 0.5) / FINE;
        const double radius = 0.48 * size;
        sum = add(sum, fish_color(p, (u - 0.5 * size) / radius, (0.5 * size - v) / radius));
    }
    return scale((real)1 / (FINE * FINE), sum);
}

static image show_hemisphere(const options *opt) {
    const int count = COUNT(fish_panels);
    const int columns = best_columns(count, opt->width, opt->height);
    const int rows = (count + columns - 1) / columns;
    const int wide = opt->width / columns, high = opt->height / rows;
    const int size = wide < high ? wide : high;
    image img = image_new(opt->width, opt->height);
    for (int y = 0; y < rows * size; y++)
        for (int x = 0; x < columns * size; x++) {
            const int k = y / size * columns + x / size;
            if (k < count)
                *image_at(&img, x, y) = fish_pixel(&fish_panels[k], x % size, y % size, size);
        }
    return img;
}

// ---- spheres of two BRDFs, the whole equation solved in each pixel -----------------------

// A hazy sky with the sun behind the haze.
static double from_hazy_sky(const void *nothing, vec3 x, vec3 w) {
    (void)nothing, (void)x;
    const vec3 sun = PAINT(-0.48, 0.64, 0.6);
    return 0.25 + 0.25 * (double)w.y + 5 * exp(40 * ((double)dot(w, sun) - 1));
}

static const double matte_rho = 0.8;
static const gloss polishes[] = {{0.8, 4}, {0.8, 20}, {0.8, 80}};
enum { BALLS = 1 + COUNT(polishes) };

static sphere ball_in_panel(int k, int columns, int rows) {
    const double x = k % columns - (columns - 1) / 2.0, y = (rows - 1) / 2.0 - k / columns;
    return (sphere){{(real)(2.2 * x), (real)(2.2 * y), 0}, 1};
}

typedef struct {
    int columns, rows;
} ball_job;

static color look_at_balls(const void *data, ray r, rng *g) {
    (void)g;
    const ball_job *job = data;
    for (int k = 0; k < BALLS; k++) {
        const sphere S = ball_in_panel(k, job->columns, job->rows);
        const real t = sphere_hit(S, r, 0, NO_HIT);
        if (t == NO_HIT) continue;
        const hit h = sphere_surface(S, r, t);
        const lit_point point = {.x = h.p,
                                 .n = h.n,
                                 .f_r = k == 0 ? brdf_lambert : brdf_own,
                                 .paint = k == 0 ? (const void *)&matte_rho
                                                 : (const void *)&polishes[k - 1],
                                 .L_i = from_hazy_sky};
        const real L_o = (real)outgoing_radiance(&point, neg(normalize(r.d)), 24, 48);
        return scale(L_o, (color)PAINT(1, 0.82, 0.6));
    }
    return (color)PAINT(0.03, 0.04, 0.06);
}

static image show_brdf(const options *opt) {
    camera cam =
        camera_look_at((vec3){0, 0, 10}, (vec3){0, 0, 0}, up, 40, opt->width, opt->height);
    cam.kind = ORTHOGRAPHIC;
    const int columns = best_columns(BALLS, opt->width, opt->height);
    const ball_job job = {columns, (BALLS + columns - 1) / columns};
    const double across = 2.2 * job.columns + 0.1, upright = 2.2 * job.rows + 0.1;
    cam.span = (real)fmax(upright, across * opt->height / opt->width);
    return render("07-rendering-equation", &cam, look_at_balls, &job, opt);
}

// ---- the tables ------------------------------------------------------------------------

static void print_irradiance(const char *what, double sum, double want) {
    printf("  %-44s %14.9f %14.9f %9.1e\n", what, sum / PI, want, fabs(sum / PI / want - 1));
}

// A point at the origin, the normal up; from it E / π is the form factor.
static void print_point_factors(void) {
    const vec3 x = {0, 0, 0};
    const sphere above = {{0, 2, 0}, 1}, cut = {{2, (real)0.5, 0}, 1};
    const disc round = {{{0, 1, 0}, {0, -1, 0}}, 1};
    const rectangle corner = {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}};
    const rectangle upright = {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}};
    printf("Form factors of a point        over 128 x 256 directions:  the sum    closed form"
           "     error\n");
    print_irradiance("the whole sky", irradiance(from_uniform_sky, NULL, x, up, 128, 256), 1);
    print_irradiance("sphere of radius 1, at the height 2",
                     irradiance(from_sphere, &above, x, up, 128, 256), 0.25);
    print_irradiance("the same, 2 to the side and half a radius up",
                     irradiance(from_sphere, &cut, x, up, 128, 256), 0.196801876179 / PI);
    print_irradiance("disc of radius 1, at the height 1",
                     irradiance(from_disc, &round, x, up, 128, 256), 0.5);
    print_irradiance("the same, over the disc, 32 x 64 points",
                     disc_irradiance(round, x, up, 32, 64), 0.5);
    print_irradiance("unit square above, a corner over the point",
                     irradiance(from_rectangle, &corner, x, up, 128, 256), 0.138531605995);
    print_irradiance("the same, over the square, Gauss 8 x 8",
                     rectangle_irradiance_by_area(GAUSS, 8, corner, x, up), 0.138531605995);
    print_irradiance("the same, Lambert's formula", rectangle_irradiance(corner, x, up),
                     0.138531605995);
    print_irradiance("unit square, upright at the distance 1",
                     irradiance(from_rectangle, &upright, x, up, 128, 256), 0.055734197003);
}

static void print_square_factors(void) {
    const rectangle a = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const rectangle opposite = {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}};
    const rectangle beside = {{0, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const double face = 0.199824895698, edge = 0.200043776075;
    printf("Form factors of unit squares (four dimensions; two, with Lambert's formula)\n");
    print_irradiance("face to face, Gauss 8^4", PI * form_factor(GAUSS, 8, a, opposite), face);
    print_irradiance("face to face, Lambert, Gauss 8^2",
                     PI * form_factor_lambert(GAUSS, 8, a, opposite), face);
    print_irradiance("a common edge, upright, Gauss 8^4", PI * form_factor(GAUSS, 8, a, beside),
                     edge);
    print_irradiance("a common edge, upright, Lambert, Gauss 8^2",
                     PI * form_factor_lambert(GAUSS, 8, a, beside), edge);
}

// The largest n with n^dimensions <= budget, but for a trace.
static int points_per_axis(double budget, int dimensions) {
    return (int)floor(pow(budget, 1.0 / dimensions) + 1e-9);
}

// ∏ π/2 sin πx: 1 in any number of dimensions.
static double sines(const void *dimensions, const double *x) {
    double product = 1;
    for (int k = 0; k < *(const int *)dimensions; k++) product *= PI / 2 * sin(PI * x[k]);
    return product;
}

static void print_curse(void) {
    const double budgets[] = {4096, 262144};
    printf("The curse of dimension: the midpoint rule's error with at most 4096 evaluations, "
           "and with 64 times as many\n");
    for (int d = 1; d <= MOST_DIMENSIONS; d++) {
        printf("  %d %s:", d, d == 1 ? "dimension " : "dimensions");
        for (int k = 0; k < COUNT(budgets); k++) {
            const int n = points_per_axis(budgets[k], d);
            printf("  %6d an axis, %8.1e", n,
                   fabs(integrate_cube(MIDPOINT, n, d, sines, &d) - 1));
        }
        printf("\n");
    }
}

static void print_tables(void) {
    print_point_factors();
    print_square_factors();
    print_curse();
}

// ---- the program -------------------------------------------------------------------------

static const choice pictures[] = {
    {"floor", "a floor under three lights: over few directions, and over the lights"},
    {"hemisphere", "fish-eye: L_i and the sum's directions; L_i cos θ; areas as E sees them"},
    {"brdf", "the whole equation on spheres: Lambert's BRDF, and own_brdf, shine 4, 20, 80"},
    {0},
};

int main(int argc, char **argv) {
    const program about = {
        .name = "07-rendering-equation",
        .summary = "Draws what the rendering equation says, its integral solved by sums.",
        .uses = USES_SIZE | USES_SAMPLES | USES_SEED | USES_THREADS | USES_PREVIEW,
        .defaults = {.width = 480,
                     .height = 400,
                     .samples = 1,
                     .seed = 1,
                     .out = "07-rendering-equation.png"},
        .shows = pictures,
    };
    const options opt = options_parse(argc, argv, &about);
    image img = shows(&opt, "hemisphere") ? show_hemisphere(&opt)
                : shows(&opt, "brdf")     ? show_brdf(&opt)
                                          : show_floor(&opt);
    image_write(&img, opt.out);
    image_free(&img);
    if (shows(&opt, "floor")) print_tables();
}
