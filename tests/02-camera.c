// Tests of 02-camera: the four exercises, the look-at, the loop over pixels, and
// light traced forwards against light traced backwards.
#define _POSIX_C_SOURCE 200809L
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "chapters/02-camera/lamp.h"
#include "common/exact3.h"
#include "common/wide3.h"
#include "tests/check-threads.h"
#include "tests/check.h"

#define U (REAL_EPSILON / 2)                           // one rounding, relative
#define BASIS_ERROR (sizeof(real) == 4 ? 3e-7 : 6e-16) // that a good basis reaches
static const char *const as_unit = "unit and perpendicular within rounding";

// ---- generic data ------------------------------------------------------------------

static vec3 unit(vec3 a) {
    return narrow(wide_unit(widen(a)));
}

static vec3 generic_direction(rng *g) {
    for (;;) {
        const vec3 v = in_cube(g);
        if (dot(v, v) > (real)0.01 && dot(v, v) <= 1) return unit(v);
    }
}

// A camera that needs neither camera_look_at nor camera_right.
static camera generic_camera(rng *g) {
    const wide3 f = widen(generic_direction(g));
    const wide3 r = wide_unit(wide_cross(f, widen(generic_direction(g))));
    camera cam = {.eye = scale(5, in_cube(g)),
                  .forward = narrow(f),
                  .right = narrow(r),
                  .up = narrow(wide_cross(r, f))};
    cam.width = 1 + (int)(rng_bits(g) % 2000);
    cam.height = 1 + (int)(rng_bits(g) % 2000);
    cam.focal = (real)cam.height * ((real)0.2 + 3 * rng_real(g));
    cam.span = (real)0.1 + 20 * rng_real(g);
    cam.lens_radius = (real)0.5 * rng_real(g);
    cam.focus = (real)0.5 + 20 * rng_real(g);
    return cam;
}

static void given_camera(const camera *cam, real x, real y) {
    given("%d x %d pixels, focal %.9g; eye = " VEC ", right = " VEC ", up = " VEC
          ", forward = " VEC "; x = %.9g, y = %.9g",
          cam->width, cam->height, (double)cam->focal, ARG(cam->eye), ARG(cam->right),
          ARG(cam->up), ARG(cam->forward), (double)x, (double)y);
}

// a right + b up + c forward, in double.
static wide3 in_basis(const camera *cam, double a, double b, double c) {
    const wide3 zero = {0, 0, 0};
    return wide_along(wide_along(wide_along(zero, a, widen(cam->right)), b, widen(cam->up)), c,
                      widen(cam->forward));
}

static wide3 pinhole_direction(const camera *cam, double x, double y) {
    return in_basis(cam, x - cam->width / 2.0, cam->height / 2.0 - y, (double)cam->focal);
}

// ---- camera_ray -----------------------------------------------------------------------

// 4 x 2 pixels, looking along -z: the numbers can be read off a drawing.
static camera small_camera(void) {
    return (camera){.eye = {1, 2, 3},
                    .right = {1, 0, 0},
                    .up = {0, 1, 0},
                    .forward = {0, 0, -1},
                    .width = 4,
                    .height = 2,
                    .focal = 5};
}

static void by_hand(void) {
    const camera cam = small_camera();
    given_camera(&cam, 0.5f, 0.5f);
    suspect_vec3("the corner of the picture: x = 0.5 already is the pixel's centre",
                 (vec3){-2, 1, -5});
    suspect_vec3("half a pixel was added: x = 0.5 already is the pixel's centre",
                 (vec3){-1, 0, -5});
    suspect_vec3("y grows downwards in the picture", (vec3){-1.5f, -0.5f, -5});
    suspect_vec3("the direction to the point plus the eye: d is a difference",
                 (vec3){-0.5f, 2.5f, -2});
    suspect_vec3("the point is measured from the corner, not from the middle",
                 (vec3){0.5f, -0.5f, -5});
    suspect_vec3("made a unit vector: d reaches to the image plane",
                 normalize((vec3){-1.5f, 0.5f, -5}));
    suspect_vec3("focal is missing: forward has length 1, times focal",
                 (vec3){-1.5f, 0.5f, -1});
    CHECK_VEC3(camera_ray(&cam, 0.5f, 0.5f).d, ((vec3){-1.5f, 0.5f, -5}), exactly());
    given_camera(&cam, 0.5f, 0.5f);
    CHECK_VEC3(camera_ray(&cam, 0.5f, 0.5f).O, cam.eye, exactly());
}

static void corners(void) {
    const camera cam = small_camera();
    const struct {
        real x, y;
        vec3 d;
    } rows[] = {{0, 0, {-2, 1, -5}},
                {4, 0, {2, 1, -5}},
                {0, 2, {-2, -1, -5}},
                {4, 2, {2, -1, -5}},
                {2, 1, {0, 0, -5}}};
    for (int i = 0; i < COUNT(rows); i++) {
        given_camera(&cam, rows[i].x, rows[i].y);
        CHECK_VEC3(camera_ray(&cam, rows[i].x, rows[i].y).d, rows[i].d, exactly());
    }
}

// An odd and an even side: half a pixel added would move both, a lost half only one.
static void odd_size(void) {
    const struct {
        int width, height;
        real x, y;
        const char *lost;
        vec3 without;
    } rows[] = {{5, 2, 2.5f, 1, "width / 2 as whole numbers: 5 / 2 is 2", {0.5f, 0, -5}},
                {4, 3, 2, 1.5f, "height / 2 as whole numbers: 3 / 2 is 1", {0, -0.5f, -5}}};
    for (int i = 0; i < COUNT(rows); i++) {
        camera cam = small_camera();
        cam.width = rows[i].width, cam.height = rows[i].height;
        given_camera(&cam, rows[i].x, rows[i].y);
        suspect_vec3(rows[i].lost, rows[i].without);
        suspect_vec3("half a pixel was added: x and y say where in the pixel already",
                     (vec3){0.5f, -0.5f, -5});
        CHECK_VEC3(camera_ray(&cam, rows[i].x, rows[i].y).d, ((vec3){0, 0, -5}), exactly());
    }
}

static const char *const turned =
    "the camera is turned: right, up and forward are not x, y and -z";

// Along x, with z upwards: what is written for -z shows.
static void turned_camera(void) {
    camera cam = small_camera();
    cam.right = (vec3){0, -1, 0}, cam.up = (vec3){0, 0, 1}, cam.forward = (vec3){1, 0, 0};
    const struct {
        real x, y;
        vec3 d, unturned;
    } rows[] = {{0.5f, 0.5f, {5, 1.5f, 0.5f}, {-1.5f, 0.5f, -5}},
                {4, 2, {5, -2, -1}, {2, -1, -5}},
                {2, 1, {5, 0, 0}, {0, 0, -5}}};
    for (int i = 0; i < COUNT(rows); i++) {
        given_camera(&cam, rows[i].x, rows[i].y);
        suspect_vec3(turned, rows[i].unturned);
        suspect_vec3(turned, mul(rows[i].unturned, (vec3){1, 1, -1}));
        CHECK_VEC3(camera_ray(&cam, rows[i].x, rows[i].y).d, rows[i].d, exactly());
    }
}

static void generic_rays(void) {
    rng g = rng_seed(2, 1);
    for (int i = 0; i < 3000; i++) {
        const camera cam = generic_camera(&g);
        const real x = (real)cam.width * rng_real(&g);
        const real y = (real)cam.height * rng_real(&g);
        const wide3 d = pinhole_direction(&cam, (double)x, (double)y);
        const double sum = fabs((double)x - cam.width / 2.0) +
                           fabs(cam.height / 2.0 - (double)y) + (double)cam.focal;
        given_camera(&cam, x, y);
        suspect_vec3("y grows downwards in the picture",
                     narrow(pinhole_direction(&cam, (double)x, cam.height - (double)y)));
        suspect_vec3("made a unit vector: d reaches to the image plane", narrow(wide_unit(d)));
        suspect_vec3("the camera looks backwards: forward already points away from the eye",
                     narrow(wide_along(d, -2 * (double)cam.focal, widen(cam.forward))));
        suspect_vec3("focal is missing: forward has length 1, times focal",
                     narrow(wide_along(d, 1 - (double)cam.focal, widen(cam.forward))));
        suspect_vec3(turned,
                     (vec3){x - (real)cam.width / 2, (real)cam.height / 2 - y, -cam.focal});
        const ray r = camera_ray(&cam, x, y);
        CHECK_VEC3(r.O, cam.eye, exactly());
        CHECK_VEC3(r.d, narrow(d), absolute_of(6 * U * sum, "three products and their sum"));
    }
}

// Whole and half numbers up to 16384 are floats, so these are exact.
static void canonical_exact(void) {
    camera cam = small_camera();
    cam.width = 16384, cam.height = 12288, cam.focal = (real)7777.5;
    rng g = rng_seed(2, 2);
    for (int i = 0; i < 2000; i++) {
        const int column = (int)(rng_bits(&g) % 16384), row = (int)(rng_bits(&g) % 12288);
        const real x = (real)(column + 0.5), y = (real)(row + 0.5);
        const vec3 d = {(real)(x - 8192), (real)(6144 - y), (real)-7777.5};
        given_camera(&cam, x, y);
        suspect_vec3("half a pixel was added: x and y are a centre already",
                     add(d, (vec3){0.5f, -0.5f, 0}));
        CHECK_VEC3(camera_ray(&cam, x, y).d, d, exactly());
    }
}

// ---- orthographic_ray -------------------------------------------------------------------

static void orthographic_by_hand(void) {
    camera cam = small_camera();
    cam.span = 6;
    given(
        "span = 6 units for 2 rows of pixels, so 3 units a pixel; eye = (1, 2, 3), right = x, "
        "up = y, 4 x 2 pixels; x = 0.5, y = 0.5");
    suspect_vec3("the start is the eye itself: every ray needs its own", cam.eye);
    suspect_vec3("span taken as the width of the picture: it is the height",
                 (vec3){-1.25f, 2.75f, 3});
    suspect_vec3("span given to the width and to the height: pixels are square",
                 (vec3){-1.25f, 3.5f, 3});
    suspect_vec3("y grows downwards in the picture", (vec3){-3.5f, 0.5f, 3});
    suspect_vec3("the eye was forgotten", (vec3){-4.5f, 1.5f, 0});
    CHECK_VEC3(orthographic_ray(&cam, 0.5f, 0.5f).O, ((vec3){-3.5f, 3.5f, 3}), exactly());
    suspect_vec3("the direction of the pinhole's ray: here all are parallel",
                 (vec3){-1.5f, 0.5f, -5});
    CHECK_VEC3(orthographic_ray(&cam, 0.5f, 0.5f).d, cam.forward, exactly());
}

static void orthographic_generic(void) {
    rng g = rng_seed(2, 3);
    for (int i = 0; i < 3000; i++) {
        const camera cam = generic_camera(&g);
        const real x = (real)cam.width * rng_real(&g);
        const real y = (real)cam.height * rng_real(&g);
        const double pixel = (double)cam.span / cam.height;
        const double a = ((double)x - cam.width / 2.0) * pixel;
        const double b = (cam.height / 2.0 - (double)y) * pixel;
        const vec3 O = narrow(wide_along(widen(cam.eye), 1, in_basis(&cam, a, b, 0)));
        given_camera(&cam, x, y);
        const ray r = orthographic_ray(&cam, x, y);
        const double size = (double)cam.span * (1 + (double)cam.width / cam.height) + 10;
        CHECK_VEC3(r.O, O, absolute_of(8 * U * size, "a few roundings of O or of the picture"));
        CHECK_VEC3(r.d, cam.forward, exactly());
    }
}

static void orthographic_square(void) {
    rng g = rng_seed(2, 4);
    for (int i = 0; i < 300; i++) {
        camera cam = generic_camera(&g);
        cam.eye = (vec3){0, 0, 0};
        const real w = (real)cam.width, h = (real)cam.height;
        const vec3 O = orthographic_ray(&cam, 0, 0).O;
        const vec3 wide = sub(orthographic_ray(&cam, w, 0).O, O);
        const vec3 high = sub(orthographic_ray(&cam, 0, h).O, O);
        const double ratio = (double)cam.width / cam.height;
        given_camera(&cam, 0, 0);
        const double slack = 12 * U * (double)cam.span * (1 + ratio);
        CHECK_REAL(length(high), cam.span,
                   absolute_of(slack, "the height of the picture is span"));
        suspect_value("the width of the picture is span: pixels are square", (double)cam.span);
        CHECK_REAL(length(wide), (double)cam.span * ratio, absolute_of(slack, "square pixels"));
    }
}

// ---- thin_lens_ray ------------------------------------------------------------------------

static void given_lens(void) {
    given(
        "4 x 2 pixels, focal 5, lens radius 0.5, focus 10, eye = (1, 2, 3), right = x, up = y, "
        "forward = -z; x = 0.5, y = 0.5, u = 0.5, v = -1");
}

static void lens_by_hand(void) {
    camera cam = small_camera(); // eye (1, 2, 3), along -z, focal 5
    cam.lens_radius = 0.5f, cam.focus = 10;
    // Pixel (0.5, 0.5): d = (-1.5, 0.5, -5); sharp at 2 d from the eye: (-3, 1, -10).
    given_lens();
    suspect_vec3("lens_radius is missing: u and v are in units of it", (vec3){1.5f, 1, 3});
    suspect_vec3("the start is the eye: it should be a point of the lens", cam.eye);
    suspect_vec3("v counts upwards, along up; only the picture's y runs down",
                 (vec3){1.25f, 2.5f, 3});
    suspect_vec3("the eye was forgotten", (vec3){0.25f, -0.5f, 0});
    const ray r = thin_lens_ray(&cam, 0.5f, 0.5f, 0.5f, -1);
    CHECK_VEC3(r.O, ((vec3){1.25f, 1.5f, 3}), exactly());
    const vec3 bent = {-3.25f, 1.5f, -10}, lens = {0.25f, -0.5f, 0};
    const vec3 d = {-1.5f, 0.5f, -5};
    given_lens();
    suspect_vec3("not bent: it runs beside the pinhole ray and never meets it", d);
    suspect_vec3("runs beside the pinhole ray and never meets it", (vec3){-3, 1, -10});
    suspect_vec3(
        "the sharp points lie on a sphere: focus counts along forward, not along the ray",
        sub(scale(10 / length(d), d), lens));
    suspect_vec3("it meets the pinhole ray in the image plane, not in the plane in focus",
                 sub(d, lens));
    suspect_vec3("made a unit vector: t = 1 belongs to the plane in focus", normalize(bent));
    suspect_vec3("not divided by focal: focus counts in units, d in pixels",
                 sub(scale(10, d), lens));
    suspect_vec3("focal / focus: d reaches focal along forward and should reach focus",
                 sub(scale(0.5f, d), lens));
    suspect_vec3("the sharp point itself: subtract the start", (vec3){-2, 3, -7});
    suspect_vec3("the sharp point from the eye, the start from the origin: both from one point",
                 (vec3){-4.25f, -0.5f, -13});
    suspect_vec3(
        "the point of the lens is added: from there to the sharp point it is taken away",
        (vec3){-2.75f, 0.5f, -10});
    suspect_vec3("v counts upwards, along up; only the picture's y runs down",
                 (vec3){-3.25f, 0.5f, -10});
    CHECK_VEC3(r.d, bent, roundings(4, "one quotient"));
}

// All rays of a pixel meet where the pinhole ray meets the plane in focus.
static void lens_focus(void) {
    rng g = rng_seed(2, 5);
    for (int i = 0; i < 3000; i++) {
        const camera cam = generic_camera(&g);
        const real x = (real)cam.width * rng_real(&g);
        const real y = (real)cam.height * rng_real(&g);
        real u, v;
        lens_point(&g, &u, &v);
        const double s = (double)cam.focus / (double)cam.focal;
        const wide3 d = pinhole_direction(&cam, (double)x, (double)y);
        const wide3 sharp = wide_along(widen(cam.eye), s, d);
        const double size = s * sqrt(wide_dot(d, d)) + 10;
        given_camera(&cam, x, y);
        const ray r = thin_lens_ray(&cam, x, y, u, v);
        const double far = size * sqrt(wide_dot(d, d)) / (double)cam.focal;
        CHECK_VEC3(ray_at(r, 1), narrow(sharp), absolute_of(16 * U * far, "a few roundings"));
        const vec3 lens = sub(r.O, cam.eye);
        const double slack = 8 * U * 10;
        CHECK_REAL(dot(lens, cam.right), cam.lens_radius * u, absolute_of(slack, "of the eye"));
        CHECK_REAL(dot(lens, cam.up), cam.lens_radius * v, absolute_of(slack, "of the eye"));
        CHECK_REAL(dot(lens, cam.forward), 0, absolute_of(slack, "the lens is flat"));
    }
}

static void lens_of_radius_0(void) {
    rng g = rng_seed(2, 6);
    for (int i = 0; i < 500; i++) {
        camera cam = generic_camera(&g);
        cam.lens_radius = 0;
        const real x = (real)cam.width * rng_real(&g);
        const real y = (real)cam.height * rng_real(&g);
        given_camera(&cam, x, y);
        const ray r = thin_lens_ray(&cam, x, y, (real)0.6, (real)-0.7);
        const vec3 d = narrow(wide_unit(pinhole_direction(&cam, (double)x, (double)y)));
        CHECK_VEC3(r.O, cam.eye, exactly());
        CHECK_VEC3(unit(r.d), d, absolute_of(20 * U, "the pinhole's line"));
    }
}

// ---- camera_right -----------------------------------------------------------------------------

static double dot_in_double(vec3 a, vec3 b) {
    return wide_dot(widen(a), widen(b));
}

static double exact_length(vec3 a) {
    return sqrt(dot_in_double(a, a));
}

// A unit vector, perpendicular to forward; `which` says what kind of up this is.
static void check_right(vec3 forward, vec3 up, const char *which) {
    given("forward = " VEC ", up = " VEC "%s", ARG(forward), ARG(up), which);
    const vec3 right = camera_right(forward, up);
    given("forward = " VEC ", up = " VEC "%s; right = camera_right(forward, up) = " VEC
          ", its length is %.9g, and right·forward = %.2g",
          ARG(forward), ARG(up), which, ARG(right), exact_length(right),
          dot_in_double(right, forward));
    CHECK_REAL(exact_length(right), 1,
               absolute_of(BASIS_ERROR, "a unit vector, but for roundings"));
    CHECK_REAL(dot_in_double(right, forward), 0,
               absolute_of(BASIS_ERROR, "perpendicular, but for roundings"));
}

static void right_by_hand(void) {
    // forward = (2, -1, -2) / 3, up = y: forward x up = (2, 0, 2) / 3.
    const vec3 forward = unit((vec3){2, -1, -2}), up = {0, 1, 0};
    const vec3 right = {(real)sqrt(0.5), 0, (real)sqrt(0.5)};
    given("forward = (2, -1, -2) / 3, up = (0, 1, 0)");
    suspect_vec3("left: up x forward in place of forward x up", neg(right));
    suspect_vec3("not made a unit vector", (vec3){(real)(2 / 3.0), 0, (real)(2 / 3.0)});
    CHECK_VEC3(camera_right(forward, up), right, absolute_of(BASIS_ERROR, as_unit));
}

static void right_generic(void) {
    rng g = rng_seed(2, 7);
    for (int i = 0; i < 5000; i++) {
        const vec3 f = generic_direction(&g), up = scale(3, in_cube(&g));
        const wide3 across = wide_cross(widen(f), widen(up));
        const double sine = sqrt(wide_dot(across, across) / wide_dot(widen(up), widen(up)));
        if (!(sine > 0.05)) continue;
        const vec3 right = narrow(wide_unit(across));
        given("forward = " VEC ", up = " VEC, ARG(f), ARG(up));
        suspect_vec3("left: up x forward in place of forward x up", neg(right));
        suspect_vec3("not made a unit vector", narrow(across));
        CHECK_VEC3(camera_right(f, up), right,
                   absolute_of(8 * U / sine, "a cross product loses 1 / sine of the angle"));
        check_right(f, up, "");
    }
}

static void right_parallel(void) {
    rng g = rng_seed(2, 8);
    const real factors[] = {1, -1, 4, -0.25f};
    const vec3 axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}, {0, -1, 0}, {-1, 0, 0}};
    for (int i = 0; i < 1000; i++) {
        const vec3 f = i < COUNT(axes) ? axes[i] : generic_direction(&g);
        for (int k = 0; k < COUNT(factors); k++)
            check_right(f, scale(factors[k], f), ", parallel to forward");
    }
}

// From a tenth down to nothing: the angle between up and the view.
static void right_nearly_parallel(void) {
    rng g = rng_seed(2, 9);
    for (int k = 1; k <= 17; k++) {
        for (int i = 0; i < 300; i++) {
            const vec3 f = generic_direction(&g);
            const vec3 up = add(f, scale((real)pow(10, -k), generic_direction(&g)));
            check_right(f, up, ", nearly parallel to forward");
        }
    }
}

// An angle of a thousandth still says which way is up.
static void right_listens(void) {
    rng g = rng_seed(2, 10);
    for (int i = 0; i < 1000; i++) {
        const vec3 f = generic_direction(&g);
        const vec3 up = add(f, scale((real)2e-3, generic_direction(&g)));
        const wide3 across = wide_cross(widen(f), widen(up));
        const double sine = sqrt(wide_dot(across, across));
        if (!(sine > 1e-3)) continue;
        given("forward = " VEC ", up = " VEC ", %.2g from parallel", ARG(f), ARG(up), sine);
        CHECK_VEC3(camera_right(f, up), narrow(wide_unit(across)),
                   absolute_of(8 * U / sine, "a cross product loses 1 / sine of the angle"));
    }
}

static void right_any_length(void) {
    rng g = rng_seed(2, 11);
    for (int k = -36; k <= 36; k += 6) {
        for (int i = 0; i < 200; i++) {
            const vec3 f = generic_direction(&g), up = generic_direction(&g);
            const vec3 scaled = scale((real)pow(10, k), up);
            const wide3 across = wide_cross(widen(f), widen(up));
            const double sine = sqrt(wide_dot(across, across));
            if (!(sine > 0.05)) continue;
            given("forward = " VEC ", up = " VEC, ARG(f), ARG(scaled));
            CHECK_VEC3(camera_right(f, scaled), narrow(wide_unit(across)),
                       absolute_of(12 * U / sine, "the length of up does not matter"));
        }
    }
}

static void right_without_up(void) {
    const vec3 f = unit((vec3){3, -5, 2});
    const vec3 ups[] = {{0, 0, 0}, {(real)NAN, 1, 0}, {0, (real)INFINITY, 0}};
    for (int i = 0; i < COUNT(ups); i++) check_right(f, ups[i], ", which has no direction");
}

// ---- camera_look_at -----------------------------------------------------------------------

static void check_basis(const camera *cam) {
    const wide3 r = widen(cam->right), u = widen(cam->up), f = widen(cam->forward);
    const wide3 rows[] = {r, u, f};
    for (int i = 0; i < 3; i++)
        for (int k = 0; k <= i; k++)
            CHECK_REAL(wide_dot(rows[i], rows[k]), i == k,
                       absolute_of(i == k ? 2 * BASIS_ERROR : BASIS_ERROR, as_unit));
    CHECK_REAL(wide_dot(wide_cross(r, u), f), -1, absolute_of(4 * BASIS_ERROR, "right-handed"));
}

static void look_at_basis(void) {
    rng g = rng_seed(2, 12);
    for (int i = 0; i < 4000; i++) {
        const vec3 eye = scale(10, in_cube(&g)), target = scale(10, in_cube(&g));
        const vec3 view = sub(target, eye), any = in_cube(&g);
        const real tilt = (real)pow(10, -(i % 12)); // some ups are nearly the view
        const vec3 up =
            i % 5 == 0 ? scale(i % 2 ? 1 : -1, view)
                       : scale((real)pow(10, i % 61 - 30), add(unit(view), scale(tilt, any)));
        const camera cam = camera_look_at(eye, target, up, 50, 640, 480);
        given("eye = " VEC ", target = " VEC ", up = " VEC, ARG(eye), ARG(target), ARG(up));
        CHECK_VEC3(cam.forward, unit(view), absolute_of(6 * U, "towards the target"));
        check_basis(&cam);
    }
}

static void look_at_sizes(void) {
    rng g = rng_seed(2, 13);
    for (int k = -36; k <= 36; k += 4) {
        const vec3 v = generic_direction(&g), up = {0, 1, 0};
        const camera cam =
            camera_look_at((vec3){0, 0, 0}, scale((real)pow(10, k), v), up, 50, 640, 480);
        given("a target at 1e%d times " VEC, k, ARG(v));
        CHECK_VEC3(cam.forward, v, absolute_of(6 * U, "whatever the distance"));
        check_basis(&cam);
    }
}

// A point beside the target, half_width away, lies on the picture's border.
static void across_fits(void) {
    const int sizes[][2] = {{640, 480}, {300, 700}, {1, 1}};
    rng g = check_rng(40);
    for (int i = 0; i < 60; i++) {
        const int *size = sizes[i % 3];
        const vec3 eye = scale(9, in_cube(&g)), target = in_cube(&g);
        const real half = (real)0.1 + 3 * rng_real(&g);
        const camera cam = camera_across(eye, target, half, size[0], size[1]);
        const vec3 side = add(sub(target, eye), scale(half, cam.right));
        given("eye " VEC ", target " VEC ", half_width %g, %d x %d", ARG(eye), ARG(target),
              (double)half, size[0], size[1]);
        const real x_of_side = dot(side, cam.right) / dot(side, cam.forward) * cam.focal;
        const double magnified = 1 + (double)(length(sub(target, eye)) / half);
        CHECK_REAL(x_of_side, size[0] / 2.0,
                   roundings(16 * magnified,
                             "forward and right are rounded; the way to the "
                             "target makes as much more of it as it is longer"));
    }
}

static void look_at_focal(void) {
    const struct {
        double fov, focal;
    } rows[] = {{90, 240},
                {60, 240 * sqrt(3.0)},
                {120, 240 / sqrt(3.0)},
                {1e-3, 27501974.1655813823}, // 240 / tan(0.0005°)
                {179, 2.0944482697821094}};  // 240 / tan(89.5°)
    for (int i = 0; i < COUNT(rows); i++) {
        const real fov = (real)rows[i].fov;
        const camera cam =
            camera_look_at((vec3){1, 2, 3}, (vec3){0, 0, 0}, (vec3){0, 1, 0}, fov, 640, 480);
        given("a field of view of %g degrees, 480 rows", rows[i].fov);
        // tan(x) magnifies the rounding of x by x / (sin x cos x), here with 2x = fov.
        const double angle = rows[i].fov * PI / 180, magnified = fabs(angle / sin(angle));
        CHECK_REAL(cam.focal, rows[i].focal,
                   roundings(4 + 2 * magnified, "the angle is rounded too"));
    }
}

// The picture follows when the world is shifted, or turned by (x, y, z) -> (y, z, x).
static void look_at_moves(void) {
    rng g = rng_seed(2, 14);
    const vec3 there = {32, -64, 128};
    for (int i = 0; i < 1000; i++) {
        const vec3 eye = {(real)(rng_bits(&g) % 64), (real)(rng_bits(&g) % 64), 1};
        const vec3 target = {(real)(rng_bits(&g) % 64), -3, (real)(rng_bits(&g) % 64)};
        const vec3 up = in_cube(&g);
        const camera a = camera_look_at(eye, target, up, 40, 320, 200);
        const camera b = camera_look_at(add(eye, there), add(target, there), up, 40, 320, 200);
        given("eye = " VEC ", target = " VEC ", up = " VEC ", and all shifted by " VEC,
              ARG(eye), ARG(target), ARG(up), ARG(there));
        CHECK_VEC3(b.forward, a.forward, exactly());
        CHECK_VEC3(b.right, a.right, exactly());
        const camera c =
            camera_look_at((vec3){eye.y, eye.z, eye.x}, (vec3){target.y, target.z, target.x},
                           (vec3){up.y, up.z, up.x}, 40, 320, 200);
        given("eye = " VEC ", target = " VEC ", up = " VEC ", and all axes renamed", ARG(eye),
              ARG(target), ARG(up));
        const vec3 cross_up = cross(a.forward, unit(up));
        const double sine = fmax((double)length(cross_up), 1e-3);
        CHECK_VEC3(c.right, ((vec3){a.right.y, a.right.z, a.right.x}),
                   absolute_of(8 * U / sine, "sums in another order"));
    }
}

// camera_look_at in a process of its own: the status that it exits with.
static int status_of(vec3 eye, vec3 target, double fov) {
    fflush(NULL);
    const pid_t child = fork();
    if (child == 0) {
        camera_look_at(eye, target, (vec3){0, 1, 0}, (real)fov, 640, 480);
        _exit(0);
    }
    int status = -1;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

static void look_at_refuses(void) {
    const vec3 eye = {1, 2, 3}, target = {4, 6, 5}, nowhere = {0, (real)INFINITY, 0};
    const double refused[] = {0,   -10,      180, 181,
                              1e9, INFINITY, NAN, sizeof(real) == 4 ? 1e-38 : 0};
    for (int i = 0; i < COUNT(refused); i++) {
        given("a field of view of %g degrees", refused[i]);
        CHECK_INT(status_of(eye, target, refused[i]), 1);
    }
    given("fields of view of 1e-3 and 179.9 degrees");
    CHECK_INT(status_of(eye, target, 1e-3), 0);
    CHECK_INT(status_of(eye, target, 179.9), 0);
    given("eye and target in the same point");
    CHECK_INT(status_of(eye, eye, 50), 1);
    given("a target that is infinitely far or not a number");
    CHECK_INT(status_of(eye, nowhere, 50), 1);
    CHECK_INT(status_of(eye, (vec3){(real)NAN, 0, 0}, 50), 1);
}

// ---- the loop over pixels ------------------------------------------------------------------

static camera narrow_camera(int width, int height) {
    return (camera){.eye = {0.5f, -1, 2},
                    .right = {(real)0.6, 0, (real)0.8},
                    .up = {0, 1, 0},
                    .forward = {(real)0.8, 0, (real)-0.6},
                    .width = width,
                    .height = height,
                    .focal = (real)height};
}

// 1 where d points upwards: y < height / 2 in these cameras.
static color upwards(const void *scene, ray r, rng *g) {
    (void)scene, (void)g;
    const real bright = r.d.y > 0;
    return (color){bright, bright, bright};
}

static void render_half(void) {
    const camera cam = narrow_camera(40, 31);
    const options opt = {.samples = 400, .seed = 7};
    image img = render("test", &cam, upwards, NULL, &opt);
    double sum = 0;
    for (int x = 0; x < 40; x++) {
        given("f = 1 where d points upwards; the row below and above the middle of 31 rows");
        CHECK_REAL(image_at(&img, x, 14)->x, 1, exactly());
        CHECK_REAL(image_at(&img, x, 16)->x, 0, exactly());
        sum += (double)image_at(&img, x, 15)->x / 40;
    }
    given("f = 1 where d points upwards; the middle row is cut in half");
    CHECK_REAL(sum, 0.5, standard_errors(5, 0.5 / sqrt(40 * 400.0)));
    image_free(&img);
}

// Where in its pixel the sample lay, from d itself: x, y, and their product.
static color inside_pixel(const void *scene, ray r, rng *g) {
    (void)g;
    const camera *cam = scene;
    const double x = (double)dot(r.d, cam->right) + cam->width / 2.0;
    const double y = cam->height / 2.0 - (double)dot(r.d, cam->up);
    const double a = x - floor(x), b = y - floor(y);
    return (color){(real)a, (real)b, (real)(a * b)};
}

static void render_uniform(void) {
    const camera cam = narrow_camera(8, 8);
    const options opt = {.samples = 4000, .seed = 3};
    image img = render("test", &cam, inside_pixel, &cam, &opt);
    running x = {0}, y = {0}, xy = {0};
    for (int i = 0; i < 64; i++) {
        running_add(&x, (double)img.pixels[i].x);
        running_add(&y, (double)img.pixels[i].y);
        running_add(&xy, (double)img.pixels[i].z);
    }
    given("many samples a pixel: uniform over the pixel, x and y independent");
    const double n = sqrt(64 * 4000.0);
    CHECK_REAL(x.mean, 0.5, standard_errors(5, sqrt(1 / 12.0) / n));
    CHECK_REAL(y.mean, 0.5, standard_errors(5, sqrt(1 / 12.0) / n));
    CHECK_REAL(xy.mean, 0.25, standard_errors(5, sqrt(1 / 9.0 - 1 / 16.0) / n));
    image_free(&img);
}

static void render_centre(void) {
    const camera cam = narrow_camera(9, 6);
    const options opt = {.samples = 1, .seed = 3};
    image img = render("test", &cam, inside_pixel, &cam, &opt);
    for (int i = 0; i < 9 * 6; i++) {
        given("one sample a pixel: through its centre; pixel %d", i);
        CHECK_VEC3(img.pixels[i], ((vec3){0.5f, 0.5f, 0.25f}),
                   absolute_of(100 * U, "roundings of d"));
    }
    image_free(&img);
}

static color noise(const void *scene, ray r, rng *g) {
    (void)scene;
    const real a = rng_real(g);
    const real b = rng_real(g);
    return (color){a, b, fabs(r.d.x)};
}

static void render_threads(void) {
    camera cam = narrow_camera(67, 43);
    cam.kind = THIN_LENS, cam.lens_radius = 0.25f, cam.focus = 3;
    const options opt = {.samples = 5, .seed = 11}, other = {.samples = 5, .seed = 12};
    threads(1);
    image one = render("test", &cam, noise, NULL, &opt);
    for (int n = 2; n <= 4; n++) {
        threads(n);
        image several = render("test", &cam, noise, NULL, &opt);
        given("the same picture with 1 and with %d threads", n);
        CHECK(same_pixels(one, several), "the same picture, bit for bit");
        image_free(&several);
    }
    image another = render("test", &cam, noise, NULL, &other);
    CHECK(!same_pixels(one, another), "another seed draws other random numbers");
    image_free(&one);
    image_free(&another);
}

// Not a number, infinite and negative: one pixel in the first row each.
static color broken(const void *scene, ray r, rng *g) {
    (void)g;
    const camera *cam = scene;
    const int x = (int)floor((double)dot(r.d, cam->right) + cam->width / 2.0);
    const int y = (int)floor(cam->height / 2.0 - (double)dot(r.d, cam->up));
    const real values[] = {(real)NAN, (real)INFINITY, -1, 1};
    return y == 0 && x < 4 ? (color){1, values[x], 1} : (color){1, 1, 1};
}

static void render_reports(void) {
    char path[] = "/tmp/render-XXXXXX", said[4096] = "";
    const int file = mkstemp(path), keep_stderr = dup(STDERR_FILENO);
    CHECK(file >= 0 && keep_stderr >= 0, "the test itself: a temporary file");
    dup2(file, STDERR_FILENO);
    const camera cam = narrow_camera(8, 8);
    const options opt = {.samples = 2, .seed = 5};
    image img = render("test", &cam, broken, &cam, &opt);
    fflush(stderr);
    dup2(keep_stderr, STDERR_FILENO);
    lseek(file, 0, SEEK_SET);
    const ssize_t size = read(file, said, sizeof said - 1);
    unlink(path);
    given(
        "samples that are NaN, infinite and negative, 2 in each of 3 pixels of 64; stderr: %s",
        said);
    CHECK(size > 0 && strstr(said, "6 of 128 samples"), "they are counted on stderr");
    CHECK(isnan(img.pixels[0].y), "NaN stays in the picture");
    CHECK(isinf(img.pixels[1].y), "infinity stays in the picture");
    CHECK_REAL(img.pixels[2].y, -1, exactly());
    CHECK_VEC3(img.pixels[3], ((vec3){1, 1, 1}), exactly());
    image_free(&img);
}

// Which kind of ray camera_sample makes, and what it draws.
static void sample_kinds(void) {
    rng g = rng_seed(2, 15);
    camera cam = generic_camera(&g);
    for (camera_kind kind = PINHOLE; kind <= THIN_LENS; kind++) {
        cam.kind = kind;
        rng drawn = g, same = g;
        const ray r = camera_sample(&cam, 3, 4, &drawn);
        ray want = kind == ORTHOGRAPHIC ? orthographic_ray(&cam, 3, 4) : camera_ray(&cam, 3, 4);
        if (kind == THIN_LENS) {
            real u, v;
            lens_point(&same, &u, &v);
            want = thin_lens_ray(&cam, 3, 4, u, v);
        }
        given("camera kind %d (0 pinhole, 1 orthographic, 2 thin lens)", (int)kind);
        CHECK_VEC3(r.O, want.O, exactly());
        CHECK_VEC3(r.d, want.d, exactly());
        CHECK(drawn.state == same.state, "random numbers are drawn for a lens only");
    }
}

// Rings and sectors of equal area must hold equally many points.
static void lens_uniform(void) {
    enum { RINGS = 8, SECTORS = 8, POINTS = 200000 };
    long counts[RINGS * SECTORS] = {0};
    rng g = rng_seed(2, 16);
    for (int i = 0; i < POINTS; i++) {
        real u, v;
        lens_point(&g, &u, &v);
        const double square = (double)u * u + (double)v * v;
        const double turn = atan2((double)v, (double)u) / (2 * PI) + 0.5;
        const int ring = (int)fmin(square * RINGS, RINGS - 1);
        counts[ring * SECTORS + (int)fmin(turn * SECTORS, SECTORS - 1)]++;
    }
    double chi2 = 0;
    const double expected = POINTS / (double)(RINGS * SECTORS);
    for (int i = 0; i < RINGS * SECTORS; i++)
        chi2 += (counts[i] - expected) * (counts[i] - expected) / expected;
    given("200000 points of the lens in 64 cells of equal area: chi²");
    CHECK_AT_MOST(chi2, chi2_limit(RINGS * SECTORS - 1, 1e-6), "false alarm 1e-6");
}

// ---- forwards and backwards -----------------------------------------------------------------

enum { ACROSS = 6, DOWN = 4, BLOCK = 8, REPEATS = 24 };

static double block_mean(image img, int column, int row) {
    double sum = 0;
    for (int y = row * BLOCK; y < (row + 1) * BLOCK; y++)
        for (int x = column * BLOCK; x < (column + 1) * BLOCK; x++) {
            const color c = *image_at(&img, x, y);
            sum += (double)c.x + (double)c.y + (double)c.z;
        }
    return sum / (3 * BLOCK * BLOCK);
}

static void add_blocks(image img, running blocks[DOWN][ACROSS]) {
    for (int row = 0; row < DOWN; row++)
        for (int column = 0; column < ACROSS; column++)
            running_add(&blocks[row][column], block_mean(img, column, row));
}

// Both directions see the same brightness. Repeats with their own seeds tell the
// standard error of each block; with a wide lens enough rays get through.
static void same_brightness(real lens_radius) {
    const camera cam = lamp_camera(ACROSS * BLOCK, DOWN * BLOCK, lens_radius);
    static running forwards[DOWN][ACROSS], backwards[DOWN][ACROSS];
    for (int i = 0; i < REPEATS; i++) {
        long reached;
        image f = lamp_forwards("test", &cam, &demo_lamp, 150000, 100 + (uint64_t)i, &reached);
        add_blocks(f, forwards);
        const options opt = {.samples = 4, .seed = 500 + (uint64_t)i};
        image b = render("test", &cam, lamp_backwards, &demo_lamp, &opt);
        add_blocks(b, backwards);
        image_free(&f);
        image_free(&b);
    }
    running all = {0};
    double f_sum = 0, b_sum = 0, variance = 0;
    for (int i = 0; i < ACROSS * DOWN; i++) {
        const running *f = &forwards[i / ACROSS][i % ACROSS];
        const running *b = &backwards[i / ACROSS][i % ACROSS];
        const double se = hypot(running_standard_error(f), running_standard_error(b));
        running_add(&all, (f->mean - b->mean) / se);
        f_sum += f->mean, b_sum += b->mean, variance += se * se;
        given("lens radius %g, block %d of %d x %d", (double)lens_radius, i, ACROSS, DOWN);
        // 24 repeats estimate the error itself: Student's t with 23 degrees exceeds
        // 7 about once in 2 million.
        CHECK_REAL(f->mean, b->mean, standard_errors(7, se));
    }
    given("lens radius %g, the whole picture", (double)lens_radius);
    CHECK_REAL(f_sum, b_sum, standard_errors(5, sqrt(variance)));
    // With 23 degrees of freedom Student's t has the variance 23 / 21.
    CHECK_AT_MOST(running_variance(&all) * 23, chi2_limit(23, 1e-6) * 23 / 21,
                  "the blocks scatter as their errors say (chi², false alarm 1e-6)");
}

static void narrow_lens(void) {
    same_brightness((real)0.3);
}

static void wide_lens(void) {
    same_brightness((real)0.7);
}

// Closed form: under a small lamp the floor sends back (albedo / π) L A h² / r⁴.
static void lamp_closed_form(void) {
    const lamp small = {.centre = {0.25f, 2, -1}, .side = (real)1e-3, .radiance = 1e6f};
    const vec3 p = {0.75f, 0, 0.75f}; // row and column 1: a light square
    const double r2 = 0.5 * 0.5 + 2 * 2 + 1.75 * 1.75;
    rng g = rng_seed(2, 17);
    const ray r = {{0.75f, 3, 4.75f}, {0, -3, -4}};
    given("a small lamp of radiance 1e6 and area 1e-6, 2 above the floor; a ray to " VEC,
          ARG(p));
    suspect_factor("the 1 / π of a matte surface is missing", PI);
    suspect_factor("one cosine of two", sqrt(r2) / 2);
    CHECK_REAL(lamp_backwards(&small, r, &g).x, 0.85 * 4 / (PI * r2 * r2),
               relative_to(2e-3, "the lamp is not quite a point"));
    given("a ray that never meets the floor");
    CHECK_VEC3(lamp_backwards(&small, (ray){{0, 1, 0}, {0, 1, -1}}, &g), ((vec3){0, 0, 0}),
               exactly());
    CHECK_VEC3(lamp_backwards(&small, (ray){{0, 1, 0}, {1, 0, -1}}, &g), ((vec3){0, 0, 0}),
               exactly());
}

static void forwards_threads(void) {
    const camera cam = lamp_camera(48, 30, (real)0.5);
    long reached, again;
    threads(1);
    image one = lamp_forwards("test", &cam, &demo_lamp, 700001, 9, &reached);
    for (int n = 2; n <= 4; n++) {
        threads(n);
        image several = lamp_forwards("test", &cam, &demo_lamp, 700001, 9, &again);
        given("700001 rays forwards with 1 and with %d threads", n);
        CHECK(same_pixels(one, several), "the same picture, bit for bit");
        CHECK_INT(again, reached);
        image_free(&several);
    }
    CHECK(reached > 500, "the test itself: some rays arrive");
    image_free(&one);
}

// The share that arrives grows with the area of the lens; nothing passes no area.
static void forwards_area(void) {
    long none, narrow_one, wide_one;
    const long rays = 2000000;
    const camera cams[] = {lamp_camera(48, 30, 0), lamp_camera(48, 30, (real)0.1),
                           lamp_camera(48, 30, (real)0.2)};
    image a = lamp_forwards("test", &cams[0], &demo_lamp, rays, 1, &none);
    image b = lamp_forwards("test", &cams[1], &demo_lamp, rays, 2, &narrow_one);
    image c = lamp_forwards("test", &cams[2], &demo_lamp, rays, 3, &wide_one);
    given("2000000 rays through a pinhole without area");
    CHECK_INT(none, 0);
    CHECK_VEC3(*image_at(&a, 24, 15), ((vec3){0, 0, 0}), exactly());
    given("lenses of radius 0.1 and 0.2, %ld and %ld rays", narrow_one, wide_one);
    const double expected = 4.0 * (double)narrow_one; // four times the area
    CHECK_REAL((double)wide_one, expected,
               standard_errors(5, sqrt(16.0 * (double)narrow_one + (double)wide_one)));
    image_free(&a), image_free(&b), image_free(&c);
}

int main(void) {
    static const char *const draw =
        "O is the eye, d the way from there to (x, y): how far right of the middle is that, "
        "how far above (y runs down), how far ahead?";
    static const char *const parallel =
        "Orthographic: where does each ray start, and in which direction do all go?";
    static const char *const meet =
        "From a point of the lens to where the pinhole ray meets the plane in focus: where do "
        "both lie, seen from the eye? This rests on camera_ray: is that right? "
        "make test-02 T=thin_lens_ray judges this one alone.";
    static const char *const nothing =
        "Parallel vectors have the cross product zero, and no length makes that a unit vector: "
        "take another axis then, one that is not parallel to forward either, and make the "
        "product a unit vector.";
    static const char *const no_up =
        "Ask whether up is zero or not finite before you use it: every comparison with NaN is "
        "false, so none that you make later stops it. Then any unit vector perpendicular to "
        "forward will do.";
    static const char *const noise_left =
        "Of length 1 and perpendicular, always. Near parallel, rounding leaves a part along "
        "forward: measure it and take it away.";
    static const char *const physics = "Radiance, solid angle and area on both sides.";
    static const char *const look = "See the contract in camera.h.";
    static const char *const loop =
        "The loop over pixels must not depend on threads or hide a sample.";
    static const test tests[] = {
        {"camera_ray: the first pixel of a small picture", by_hand, draw},
        {"camera_ray: corners and middle", corners, draw},
        {"camera_ray: an odd number of pixels", odd_size,
         "In the middle of the picture d is focal forward and nothing else: what does each "
         "term "
         "give there?"},
        {"camera_ray: a turned camera", turned_camera, draw},
        {"camera_ray: 3000 generic cameras", generic_rays, draw},
        {"camera_ray: exact along -z up to 16384 pixels", canonical_exact,
         "With these axes d is (x - w/2, h/2 - y, -focal), and no step to it rounds: what else "
         "is done to it?"},
        {"orthographic_ray: the first pixel of a small picture", orthographic_by_hand,
         parallel},
        {"orthographic_ray: 3000 generic cameras", orthographic_generic, parallel},
        {"orthographic_ray: square pixels", orthographic_square,
         "How many units is one pixel? The same across and down."},
        {"thin_lens_ray: the first pixel of a small picture", lens_by_hand, meet},
        {"thin_lens_ray: sharp in the plane of focus", lens_focus, meet},
        {"thin_lens_ray: radius 0 is a pinhole", lens_of_radius_0, meet},
        {"camera_right: worked out by hand", right_by_hand,
         "Perpendicular to forward and up, of length 1, and on the right: which product?"},
        {"camera_right: generic views", right_generic,
         "Perpendicular to forward and up, of length 1, and on the right: which product?"},
        {"camera_right: up parallel to the view", right_parallel, nothing},
        {"camera_right: up nearly parallel to the view", right_nearly_parallel, noise_left},
        {"camera_right: a thousandth is not parallel", right_listens,
         "Only what is parallel within rounding says nothing. Anything else is forward x up, "
         "made a unit vector."},
        {"camera_right: up of any length", right_any_length,
         "The same right for every length of up: bring up to size first. (In float the square "
         "of 1e-30 vanishes and that of 1e30 overflows.)"},
        {"camera_right: up is zero or not finite", right_without_up, no_up},
        {"camera_look_at: an orthonormal, right-handed basis", look_at_basis, noise_left},
        {"camera_look_at: near and far targets", look_at_sizes, look},
        {"camera_look_at: focal from the field of view", look_at_focal, look},
        {"camera_look_at: camera_across shows as much as it says", across_fits, look},
        {"camera_look_at: shifted and turned", look_at_moves, look},
        {"camera_look_at: what it refuses", look_at_refuses, look},
        {"camera_sample: by the camera's kind", sample_kinds, look},
        {"lens_point: uniform over the disc", lens_uniform, look},
        {"render: half the picture", render_half, loop},
        {"render: uniform over the pixel", render_uniform, loop},
        {"render: one sample through the centre", render_centre, loop},
        {"render: any number of threads", render_threads, loop},
        {"render: nothing wrong is hidden", render_reports, loop},
        {"lamp: radiance of the floor, closed form", lamp_closed_form, physics},
        {"lamp: forwards equals backwards, narrow lens", narrow_lens, physics},
        {"lamp: forwards equals backwards, wide lens", wide_lens, physics},
        {"lamp: forwards with any number of threads", forwards_threads, physics},
        {"lamp: rays that arrive grow with the lens's area", forwards_area, physics},
    };
    return run_tests("02-camera", tests, COUNT(tests));
}
