// Tests of 01-rasterize: edge_function, owns_edge, depth_at, and what the module
// makes of them: projection, coverage, the z-buffer, the scene.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#ifdef _OPENMP
#include <omp.h>
#endif

#include "chapters/01-rasterize/rasterize.h"
#include "common/measure.h"
#include "common/rng.h"
#include "tests/check.h"

enum { W = 48, H = 32 }; // the screen of most tests

#define POINT "(%.17g, %.17g)" // enough to work out the expected value by hand
#define AT(p) (p).x, (p).y

static double uniform(rng *g, double low, double high) {
    return low + (high - low) * rng_double(g);
}

static raster_point on_screen(rng *g, double size) {
    const double x = uniform(g, -0.2, 1.2) * size, y = uniform(g, -0.2, 1.2) * size;
    return (raster_point){x, y, uniform(g, 1, 5)};
}

static exact exact_edge(raster_point a, raster_point b, double x, double y) {
    return ((exact)b.y - a.y) * ((exact)x - a.x) - ((exact)b.x - a.x) * ((exact)y - a.y);
}

// ---- edge_function -------------------------------------------------------------------

// The textbook's a x b with y up, a corner mistaken, another product.
static void suspect_edge(raster_point a, raster_point b, double x, double y) {
    const double dx = b.x - a.x, dy = b.y - a.y;
    const double mirrored = dx * (y - a.y) - dy * (x - a.x);
    if (mirrored > 0)
        suspect_value("positive on the right: y points down on the screen (or fabs: is it "
                      "never negative?)",
                      mirrored);
    else
        suspect_value("positive on the right: y points down on the screen", mirrored);
    suspect_value("b in place of a in the way along x", dy * (x - b.x) - dx * (y - a.y));
    suspect_value("b in place of a in the way along y", dy * (x - a.x) - dx * (y - b.y));
    suspect_value("a dot product: it is zero straight across the edge",
                  dx * (x - a.x) + dy * (y - a.y));
    suspect_value("the area, not twice the area", (double)exact_edge(a, b, x, y) / 2);
}

static void edge_by_hand(void) {
    // From a = (2, 7) to b = (8, 4), up to the right. (3, 1) is above the edge: on
    // the left. Corners (2,7), (8,4), (3,1): the area is 33/2.
    const raster_point a = {2, 7, 1}, b = {8, 4, 1};
    given("a = (2, 7), b = (8, 4), the point (3, 1): left of the way from a to b");
    suspect_edge(a, b, 3, 1);
    CHECK_REAL(edge_function(a, b, 3, 1), 33, exactly());
    given("a = (2, 7), b = (8, 4), the point (9, 9): right of the way from a to b");
    suspect_value("never negative: fabs?", 33); // the sign on the left was right
    suspect_edge(a, b, 9, 9);
    CHECK_REAL(edge_function(a, b, 9, 9), -33, exactly());
    given("a = (2, 7), b = (8, 4), the point (12, 2), on the line through both");
    CHECK_REAL(edge_function(a, b, 12, 2), 0, exactly());
}

static void check_edge(raster_point a, raster_point b, double x, double y) {
    given("a = " POINT ", b = " POINT ", the point " POINT, AT(a), AT(b), x, y);
    suspect_edge(a, b, x, y);
    // Any correct arrangement of the differences rounds within this.
    const double sides =
        (fabs(b.x - a.x) + fabs(b.y - a.y) + fabs(x - a.x) + fabs(y - a.y)) / 2;
    CHECK_REAL(
        edge_function(a, b, x, y), exact_edge(a, b, x, y),
        absolute_of(16 * sides * sides * DBL_EPSILON, "two products of differences in double"));
}

static void edge_generic(void) {
    rng g = rng_seed(1, 1);
    for (int i = 0; i < 3000; i++) {
        const raster_point a = on_screen(&g, 640), b = on_screen(&g, 640);
        check_edge(a, b, floor(uniform(&g, 0, 640)) + 0.5, floor(uniform(&g, 0, 640)) + 0.5);
    }
}

static void edge_scales(void) {
    rng g = rng_seed(1, 2);
    for (int k = -9; k <= 12; k += 3) {
        for (int i = 0; i < 300; i++) {
            const raster_point a = on_screen(&g, pow(10, k)), b = on_screen(&g, pow(10, k));
            const raster_point p = on_screen(&g, pow(10, k));
            check_edge(a, b, p.x, p.y);
        }
    }
}

// A multiple of 1/128 below 1e10 has at most 17 digits: given() prints it exactly.
static raster_point far_point(rng *g, double x, double y) {
    const raster_point p = on_screen(g, 10);
    return (raster_point){floor((p.x + x) * 128) / 128, floor((p.y + y) * 128) / 128, p.depth};
}

// Far away, and near each other: the coordinates must be subtracted first.
static void edge_far_away(void) {
    rng g = rng_seed(1, 3);
    for (int i = 0; i < 1000; i++) {
        const double x = uniform(&g, -1e9, 1e9), y = uniform(&g, -1e9, 1e9);
        const raster_point a = far_point(&g, x, y), b = far_point(&g, x, y);
        const raster_point p = far_point(&g, x, y);
        check_edge(a, b, p.x, p.y);
    }
}

static void check_exactly(const char *what, raster_point a, raster_point b, double x,
                          double y) {
    given("%s: a = " POINT ", b = " POINT ", the point " POINT, what, AT(a), AT(b), x, y);
    suspect_edge(a, b, x, y);
    CHECK_REAL(edge_function(a, b, x, y), exact_edge(a, b, x, y), exactly());
}

// Multiples of 1/16 pixel: any correct formula is exact.
static raster_point on_sixteenths(rng *g) {
    const double x = floor(uniform(g, 0, 8000)) / 16, y = floor(uniform(g, 0, 8000)) / 16;
    return (raster_point){x, y, 1};
}

static void edge_properties(void) {
    rng g = rng_seed(1, 4);
    for (int i = 0; i < 1000; i++) {
        const raster_point a = on_sixteenths(&g), b = on_sixteenths(&g), c = on_sixteenths(&g);
        const raster_point a1 = {a.x + 100, a.y - 77, 1}, b1 = {b.x + 100, b.y - 77, 1};
        check_exactly("a triangle", a, b, c.x, c.y);
        check_exactly("the same triangle, a and b exchanged", b, a, c.x, c.y);
        check_exactly("the same triangle, seen from its next corner", b, c, a.x, a.y);
        check_exactly("the same triangle, moved", a1, b1, c.x + 100, c.y - 77);
        check_exactly("the point is a", a, b, a.x, a.y);
        check_exactly("the point is b", a, b, b.x, b.y);
    }
}

// ---- owns_edge ------------------------------------------------------------------------

static void owns_directions(void) {
    static const struct {
        double x, y; // from a to b
        bool owned;
        const char *what;
    } rows[] = {
        {0, 5, true, "straight down: a left edge"},
        {3, 5, true, "down to the right: a left edge"},
        {-7, 2, true, "down to the left: a left edge"},
        {0, -5, false, "straight up: a right edge"},
        {3, -5, false, "up to the right: a right edge"},
        {-7, -2, false, "up to the left: a right edge"},
        {-6, 0, true, "horizontal, to the left: a top edge"},
        {6, 0, false, "horizontal, to the right: a bottom edge"},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        const raster_point a = {11.25, 3.5, 1};
        const raster_point b = {a.x + rows[i].x, a.y + rows[i].y, 1};
        given("the edge from " POINT " to " POINT ", %s", AT(a), AT(b), rows[i].what);
        CHECK_BOOL(owns_edge(a, b), rows[i].owned);
    }
}

static void owns_one_of_two(void) {
    rng g = rng_seed(1, 5);
    for (int i = 0; i < 2000; i++) {
        const raster_point a = on_screen(&g, 100);
        raster_point b = on_screen(&g, 100);
        if (i % 4 == 1) b.x = a.x;
        if (i % 4 == 2) b.y = a.y;
        given("an edge that two triangles share: one walks it from " POINT " to " POINT
              ", the other back",
              AT(a), AT(b));
        CHECK_INT(owns_edge(a, b) + owns_edge(b, a), 1);
    }
}

// ---- depth_at -------------------------------------------------------------------------

// 1/depth is linear on the screen.
static exact exact_depth(const raster_point p[3], double x, double y) {
    const exact w0 = exact_edge(p[1], p[2], x, y), w1 = exact_edge(p[2], p[0], x, y);
    const exact w2 = exact_edge(p[0], p[1], x, y);
    return (w0 + w1 + w2) / (w0 / p[0].depth + w1 / p[1].depth + w2 / p[2].depth);
}

// One weight with the wrong sign, and the sum of the three or the triangle's area
// beneath.
static void suspect_turned(double w0, double d0, double w1, double d1, double w2, double d2) {
    const double guesses[] = {(-w0 + w1 + w2) / (-w0 / d0 + w1 / d1 + w2 / d2),
                              (w0 + w1 + w2) / (-w0 / d0 + w1 / d1 + w2 / d2)};
    for (int i = 0; i < COUNT(guesses); i++)
        if (isfinite(guesses[i]) && guesses[i] != 0)
            suspect_value("one edge is turned: walk round the triangle one way, p[1] to p[2], "
                          "p[2] to p[0], p[0] to p[1]",
                          guesses[i]);
}

static void suspect_depth(const raster_point p[3], double x, double y) {
    const double w0 = edge_function(p[1], p[2], x, y), w1 = edge_function(p[2], p[0], x, y);
    const double w2 = edge_function(p[0], p[1], x, y), area = w0 + w1 + w2;
    const double linear = (w0 * p[0].depth + w1 * p[1].depth + w2 * p[2].depth) / area;
    const double inverse = (w0 / p[0].depth + w1 / p[1].depth + w2 / p[2].depth) / area;
    suspect_value("depth taken as linear on the screen: 1/depth is", linear);
    suspect_value("1/depth, not depth: the sum was not inverted", inverse);
    suspect_value("the sum was neither divided by the whole area nor inverted", inverse * area);
    suspect_value("the weights do not add up to 1: divide by the whole area",
                  1 / (inverse * area));
    suspect_value("the weights belong to other corners: each to the one opposite its edge",
                  area / (w0 / p[2].depth + w1 / p[0].depth + w2 / p[1].depth));
    suspect_value("the weights belong to other corners: each to the one opposite its edge",
                  area / (w0 / p[1].depth + w1 / p[2].depth + w2 / p[0].depth));
    suspect_turned(w0, p[0].depth, w1, p[1].depth, w2, p[2].depth);
    suspect_turned(w1, p[1].depth, w2, p[2].depth, w0, p[0].depth);
    suspect_turned(w2, p[2].depth, w0, p[0].depth, w1, p[1].depth);
}

static void given_corners(const raster_point p[3], double x, double y) {
    given("corners " POINT " depth %.17g, " POINT " depth %.17g, " POINT
          " depth %.17g; the point " POINT,
          AT(p[0]), p[0].depth, AT(p[1]), p[1].depth, AT(p[2]), p[2].depth, x, y);
    suspect_depth(p, x, y);
}

static void depth_by_hand(void) {
    // A floor one unit below the eye, focal length 12: a point X to the side at
    // depth D stands at (12 X/D, 12/D). So y = 7.5 is at depth 12/7.5, and halfway
    // from depth 1 to depth 3 on the screen 1/depth = (1 + 1/3)/2.
    const raster_point p[] = {{0, 12, 1}, {12, 4, 3}, {-20, 4, 3}};
    given_corners(p, -1.25, 7.5);
    CHECK_REAL(depth_at(p, -1.25, 7.5), 1.6, absolute_of(1e-14, "a few roundings in double"));
    given_corners(p, 6, 8);
    CHECK_REAL(depth_at(p, 6, 8), 1.5, absolute_of(1e-14, "a few roundings in double"));
}

static void depth_of_corners(void) {
    rng g = rng_seed(1, 6);
    for (int i = 0; i < 500; i++) {
        const raster_point p[] = {on_screen(&g, 600), on_screen(&g, 600), on_screen(&g, 600)};
        for (int k = 0; k < 3; k++) {
            const double x = p[k].x, y = p[k].y;
            given_corners(p, x, y);
            CHECK_REAL(depth_at(p, x, y), p[k].depth,
                       relative_to(1e-11, "roundings in double; some triangles are thin"));
        }
    }
}

// The plane X·n = D is met by the ray through (x, y) at the depth D f / (d·n).
static exact plane_depth(projection P, vec3 n, double D, double x, double y) {
    const exact dx = (exact)x - P.width / 2.0, dy = P.height / 2.0 - (exact)y;
    return (exact)D * P.focal / (dx * n.x + dy * n.y - (exact)P.focal * n.z);
}

// Where the screen's point (x, y) lies on the plane.
static raster_point plane_corner(projection P, vec3 n, double D, double x, double y) {
    return (raster_point){x, y, (double)plane_depth(P, n, D, x, y)};
}

static void depth_of_planes(void) {
    rng g = rng_seed(1, 7);
    const projection P = {640, 480, 500};
    for (int i = 0; i < 3000; i++) {
        const vec3 n = {(real)uniform(&g, -1, 1), (real)uniform(&g, -1, 1), -1};
        const double D = pow(10, uniform(&g, -6, 9));
        raster_point p[3];
        for (int k = 0; k < 3; k++)
            p[k] = plane_corner(P, n, D, uniform(&g, 200, 440), uniform(&g, 100, 380));
        const double x = uniform(&g, 200, 440), y = uniform(&g, 100, 380);
        const double area = (double)exact_edge(p[0], p[1], p[2].x, p[2].y);
        if (fabs(area) < 2000) continue; // thin: the corners say little about the plane
        given_corners(p, x, y);
        CHECK_REAL(depth_at(p, x, y), plane_depth(P, n, D, x, y),
                   relative_to(1e-11, "roundings in double"));
    }
}

static void depth_order(void) {
    rng g = rng_seed(1, 8);
    for (int i = 0; i < 1000; i++) {
        const raster_point a = on_screen(&g, 600), b = on_screen(&g, 600),
                           c = on_screen(&g, 600);
        const raster_point orders[][3] = {{a, b, c}, {b, c, a}, {a, c, b}};
        if (fabs((double)exact_edge(a, b, c.x, c.y)) < 100) continue;
        const double x = (a.x + b.x + 2 * c.x) / 4, y = (a.y + b.y + 2 * c.y) / 4;
        for (int k = 0; k < COUNT(orders); k++) {
            const raster_point *p = orders[k];
            given_corners(p, x, y);
            CHECK_REAL(depth_at(p, x, y), exact_depth(p, x, y),
                       relative_to(1e-10, "roundings in double; thin triangles"));
        }
    }
}

// A triangle from before the eye to the horizon, and one of 1e-6 pixels.
static void depth_extremes(void) {
    const raster_point far[] = {{10, 90, 1}, {200, 20, 1e9}, {-180, 30, 1e6}};
    given_corners(far, 20, 40);
    CHECK_REAL(depth_at(far, 20, 40), exact_depth(far, 20, 40),
               relative_to(1e-13, "roundings in double"));
    const double s = 1.0 / (1 << 20);
    const raster_point tiny[] = {
        {300.5, 200.5, 2}, {300.5, 200.5 + s, 4}, {300.5 + s, 200.5, 4}};
    given_corners(tiny, 300.5 + s / 4, 200.5 + s / 4);
    CHECK_REAL(depth_at(tiny, 300.5 + s / 4, 200.5 + s / 4), 8.0 / 3,
               relative_to(1e-13, "roundings in double"));
}

// ---- coverage ---------------------------------------------------------------------------

// The world's triangle that appears at these places of the screen: with a focal
// length of 1 pixel and depth 1 a unit is a pixel, and nothing is rounded.
static const projection flat_screen = {W, H, 1};

static vec3 flat_corner(double x, double y) {
    return (vec3){(real)(x - W / 2.0), (real)(H / 2.0 - y), -1};
}

static triangle flat_triangle(raster_point a, raster_point b, raster_point c) {
    return (triangle){flat_corner(a.x, a.y), flat_corner(b.x, b.y), flat_corner(c.x, c.y)};
}

typedef struct {
    unsigned char times[H][W]; // how often each pixel was drawn
} counts;

static void count_drawn(counts *c, projection P, triangle t) {
    framebuffer fb = framebuffer_new(W, H, (color){0, 0, 0});
    rasterize(&fb, P, (painted){t, {1, 1, 1}});
    for (int y = 0; y < H; y++)
        for (int x = 0; x < W; x++) c->times[y][x] += image_at(&fb.img, x, y)->x == 1;
    framebuffer_free(&fb);
}

static int pixels_drawn(projection P, triangle t) {
    counts c = {0};
    count_drawn(&c, P, t);
    int sum = 0;
    for (int i = 0; i < W * H; i++) sum += c.times[i / W][i % W];
    return sum;
}

// `what`: what was drawn, and where `want` comes from.
static void check_same(const char *what, const counts *got, const counts *want) {
    for (int y = 0; y < H; y++)
        for (int x = 0; x < W; x++)
            if (got->times[y][x] != want->times[y][x]) {
                const int times_drawn = got->times[y][x]; // the message shows this name
                given("%s; the pixel (%d, %d), centre (%.1f, %.1f)", what, x, y, x + 0.5,
                      y + 0.5);
                CHECK_INT(times_drawn, want->times[y][x]);
            }
}

typedef struct {
    char chars[512];
} words;

static words triangle_words(triangle t, const char *more) {
    words w;
    snprintf(w.chars, sizeof w.chars, "triangle " VEC ", " VEC ", " VEC "%s", ARG(t.p1),
             ARG(t.p2), ARG(t.p3), more);
    return w;
}

static void given_triangle(triangle t) {
    given("%s", triangle_words(t, "").chars);
}

typedef struct {
    exact x, y;
} exact_point;

static exact_point exact_project(projection P, vec3 p) {
    return (exact_point){P.width / (exact)2 + (exact)P.focal * p.x / -p.z,
                         P.height / (exact)2 - (exact)P.focal * p.y / -p.z};
}

// 1: (x, y) is left of the way from a to b; 0: on the line; -1: right of it.
static int exact_side(exact_point a, exact_point b, double x, double y) {
    const exact e = (b.y - a.y) * (x - a.x) - (b.x - a.x) * (y - a.y);
    return (e > 0) - (e < 0);
}

// Inside, by exact arithmetic and for either orientation. For generic positions:
// no centre on an edge.
static bool exact_covers(projection P, triangle t, double x, double y) {
    const exact_point a = exact_project(P, t.p1), b = exact_project(P, t.p2),
                      c = exact_project(P, t.p3);
    const int s = exact_side(a, b, x, y);
    return s != 0 && s == exact_side(b, c, x, y) && s == exact_side(c, a, x, y);
}

static vec3 in_view(rng *g, double size) {
    const double depth = uniform(g, 1, 6), x = uniform(g, -1, 1), y = uniform(g, -1, 1);
    return (vec3){(real)(size * x * depth), (real)(size * y * depth), (real)-depth};
}

static triangle random_triangle(rng *g, double size) {
    const vec3 p1 = in_view(g, size), p2 = in_view(g, size), p3 = in_view(g, size);
    return (triangle){p1, p2, p3};
}

static void check_coverage(projection P, triangle t) {
    counts got = {0}, want = {0};
    count_drawn(&got, P, t);
    for (int y = 0; y < H; y++)
        for (int x = 0; x < W; x++) want.times[y][x] = exact_covers(P, t, x + 0.5, y + 0.5);
    check_same(triangle_words(t, "").chars, &got, &want);
}

// Some of them reach far outside the screen.
static void coverage_counted(void) {
    const projection P = {W, H, 30};
    rng g = rng_seed(1, 9);
    for (int i = 0; i < 400; i++) check_coverage(P, random_triangle(&g, i % 2 ? 0.7 : 3));
}

// Corners a thousand million pixels away; one pixel of the screen decides.
static void coverage_huge(void) {
    const projection P = {W, H, 30};
    rng g = rng_seed(1, 10);
    for (int i = 0; i < 100; i++) check_coverage(P, random_triangle(&g, 1e8 / 3));
    const triangle all = {{-3e9f, -2e9f, -1}, {4e9f, -2e9f, -1}, {1e8f, 5e9f, -1}};
    given_triangle(all);
    CHECK_INT(pixels_drawn(P, all), W * H);
    const triangle beyond = {{1e9f, 1e9f, -1}, {4e9f, 2e9f, -1}, {1e9f, 5e9f, -1}};
    given_triangle(beyond);
    CHECK_INT(pixels_drawn(P, beyond), 0);
}

static void either_orientation(void) {
    const projection P = {W, H, 30};
    rng g = rng_seed(1, 11);
    for (int i = 0; i < 100; i++) {
        const triangle t = random_triangle(&g, 0.7), turned = {t.p1, t.p3, t.p2};
        counts one = {0}, other = {0};
        count_drawn(&one, P, t);
        count_drawn(&other, P, turned);
        check_same(
            triangle_words(turned, " (expected: as often as with two corners exchanged)").chars,
            &other, &one);
    }
}

// Multiples of 1/16 pixel, moved by whole pixels: the pixels move along.
static void translated(void) {
    rng g = rng_seed(1, 12);
    for (int i = 0; i < 100; i++) {
        raster_point p[3], q[3];
        for (int k = 0; k < 3; k++) {
            p[k] = (raster_point){floor(uniform(&g, 32, 512)) / 16,
                                  floor(uniform(&g, 32, 352)) / 16, 1};
            q[k] = (raster_point){p[k].x + 11, p[k].y + 7, 1};
        }
        counts here = {0}, there = {0}, moved = {0};
        count_drawn(&here, flat_screen, flat_triangle(p[0], p[1], p[2]));
        const triangle t = flat_triangle(q[0], q[1], q[2]);
        count_drawn(&there, flat_screen, t);
        for (int y = 7; y < H; y++)
            for (int x = 11; x < W; x++) moved.times[y][x] = here.times[y - 7][x - 11];
        check_same(triangle_words(t, " (expected: as before it was moved)").chars, &there,
                   &moved);
    }
}

static triangle scaled(triangle t, double s) {
    return (triangle){scale((real)s, t.p1), scale((real)s, t.p2), scale((real)s, t.p3)};
}

// Only directions count: the world may be a thousand million times as large.
static void scaled_world(void) {
    const projection P = {W, H, 30};
    rng g = rng_seed(1, 13);
    for (int k = -30; k <= 30; k += 6) {
        for (int i = 0; i < 20; i++) {
            const triangle t = random_triangle(&g, 0.7);
            const triangle other = scaled(t, ldexp(1.0, k)); // a power of two does not round
            counts here = {0}, there = {0};
            count_drawn(&here, P, t);
            count_drawn(&there, P, other);
            check_same(triangle_words(other, " (expected: as before it was scaled)").chars,
                       &there, &here);
            check_coverage(P, scaled(t, pow(10, k / 3.0)));
        }
    }
}

static void nothing_to_fill(void) {
    const projection P = {W, H, 30};
    rng g = rng_seed(1, 14);
    for (int i = 0; i < 200; i++) {
        const vec3 a = in_view(&g, 0.7), b = in_view(&g, 0.7);
        const triangle rows[] = {{a, a, b}, {a, b, b}, {b, a, b}, {a, a, a}};
        for (int k = 0; k < COUNT(rows); k++) {
            given_triangle(rows[k]);
            CHECK_INT(pixels_drawn(P, rows[k]), 0);
        }
    }
    const raster_point a = {3.5, 2.5, 1}, b = {13.5, 7.5, 1}, c = {33.5, 17.5, 1};
    given("three corners on one line, through pixel centres");
    CHECK_INT(pixels_drawn(flat_screen, flat_triangle(a, b, c)), 0);
    CHECK_INT(pixels_drawn(flat_screen, flat_triangle(c, a, b)), 0);
}

static void not_numbers(void) {
    const projection P = {W, H, 30};
    const real bad[] = {(real)NAN, (real)INFINITY, (real)-INFINITY};
    for (int i = 0; i < 27; i++) {
        triangle t = {{-1, -1, -2}, {2, -1, -3}, {0, 2, -2}};
        vec3 *corner = i % 3 == 0 ? &t.p1 : i % 3 == 1 ? &t.p2 : &t.p3;
        const real value = bad[i / 9];
        if (i / 3 % 3 == 0) corner->x = value;
        if (i / 3 % 3 == 1) corner->y = value;
        if (i / 3 % 3 == 2) corner->z = value;
        given_triangle(t);
        const int pixels_covered = pixels_drawn(P, t); // infinite: must only not crash
        if (isnan(value)) CHECK_INT(pixels_covered, 0);
    }
}

static void behind_the_eye(void) {
    const projection P = {W, H, 30};
    const triangle rows[] = {{{-1, -1, -2}, {2, -1, -3}, {0, 2, 1}},
                             {{-1, -1, -2}, {2, -1, 0}, {0, 2, -1}},
                             {{-1, -1, 2}, {2, -1, 3}, {0, 2, 2}},
                             {{-1, -1, (real)NAN}, {2, -1, -3}, {0, 2, -2}}};
    framebuffer fb = framebuffer_new(W, H, (color){0, 0, 0});
    painted four[COUNT(rows)];
    for (int i = 0; i < COUNT(rows); i++) {
        four[i] = (painted){rows[i], {1, 1, 1}};
        given_triangle(rows[i]);
        CHECK_BOOL(rasterize(&fb, P, four[i]), false);
    }
    CHECK_INT(rasterize_all(&fb, P, four, COUNT(four)), COUNT(rows));
    bool picture_is_empty = true;
    for (int i = 0; i < W * H; i++)
        picture_is_empty = picture_is_empty && fb.depth[i] == (double)INFINITY;
    given("the same four triangles");
    CHECK(picture_is_empty, "a triangle that is refused draws nothing");
    const triangle ahead = {{-1, -1, -2}, {2, -1, -3}, {0, 2, -2}};
    given_triangle(ahead);
    CHECK_BOOL(rasterize(&fb, P, (painted){ahead, {1, 1, 1}}), true);
    framebuffer_free(&fb);
}

// ---- shared edges ---------------------------------------------------------------------

static void rectangle(void) {
    // Two triangles, corners in pixel centres: x from 4.5 to 20.5, y from 3.5 to 11.5.
    const raster_point a = {4.5, 3.5, 1}, b = {4.5, 11.5, 1}, c = {20.5, 11.5, 1},
                       d = {20.5, 3.5, 1};
    counts got = {0}, want = {0};
    count_drawn(&got, flat_screen, flat_triangle(a, b, c));
    count_drawn(&got, flat_screen, flat_triangle(c, d, a));
    for (int y = 3; y < 11; y++)
        for (int x = 4; x < 20; x++) want.times[y][x] = 1;
    check_same("a rectangle of two triangles, corners in pixel centres", &got, &want);
}

// Around one pixel's centre, in steps that hit many centres; a corner of all.
static void fan(void) {
    static const int rim[][2] = {{12, 0},  {12, 3},   {12, 6},   {12, 12},   {6, 12},
                                 {3, 12},  {0, 12},   {-4, 12},  {-12, 12},  {-12, 8},
                                 {-12, 4}, {-12, 0},  {-12, -1}, {-12, -12}, {-6, -12},
                                 {0, -12}, {12, -12}, {12, -6}};
    const raster_point middle = {20.5, 15.5, 1};
    counts got = {0}, want = {0};
    for (int i = 0; i < COUNT(rim); i++) {
        const int *p = rim[i], *q = rim[(i + 1) % COUNT(rim)];
        const raster_point a = {20.5 + p[0], 15.5 + p[1], 1}, b = {20.5 + q[0], 15.5 + q[1], 1};
        count_drawn(&got, flat_screen,
                    i % 2 ? flat_triangle(middle, a, b) : flat_triangle(b, a, middle));
    }
    for (int y = 3; y < 27; y++)
        for (int x = 8; x < 32; x++) want.times[y][x] = 1;
    check_same("a fan of triangles around the pixel (20, 15), corners in pixel centres", &got,
               &want);
}

enum { COLUMNS = 7, ROWS = 4, CELL = 6 };

// A grid of corners, those within moved by halves of a pixel.
static void random_grid(rng *g, raster_point p[ROWS + 1][COLUMNS + 1]) {
    for (int j = 0; j <= ROWS; j++)
        for (int i = 0; i <= COLUMNS; i++) {
            const double dx = floor(uniform(g, -2, 3)) / 2, dy = floor(uniform(g, -2, 3)) / 2;
            const bool moves_x = i > 0 && i<COLUMNS, moves_y = j> 0 && j < ROWS;
            p[j][i] = (raster_point){2.5 + CELL * i + (moves_x ? dx : 0),
                                     3.5 + CELL * j + (moves_y ? dy : 0), 1};
        }
}

static void random_meshes(void) {
    rng g = rng_seed(1, 15);
    counts want = {0};
    for (int y = 3; y < 3 + CELL * ROWS; y++)
        for (int x = 2; x < 2 + CELL * COLUMNS; x++) want.times[y][x] = 1;
    for (int n = 0; n < 40; n++) {
        raster_point p[ROWS + 1][COLUMNS + 1];
        random_grid(&g, p);
        counts got = {0};
        for (int j = 0; j < ROWS; j++)
            for (int i = 0; i < COLUMNS; i++) {
                const raster_point a = p[j][i], b = p[j + 1][i], c = p[j + 1][i + 1],
                                   d = p[j][i + 1];
                const bool other = rng_bits(&g) & 1; // which diagonal
                count_drawn(&got, flat_screen, flat_triangle(a, b, other ? d : c));
                count_drawn(&got, flat_screen, flat_triangle(c, other ? b : a, d));
            }
        check_same("a mesh of triangles, corners on half pixels", &got, &want);
    }
}

// Through the middle of the screen, and so long that the edge function itself is
// off by some hundredths of a pixel: still one owner each.
static void endless_edges(void) {
    rng g = rng_seed(1, 16);
    counts want;
    memset(&want, 1, sizeof want);
    for (int i = 0; i < 300; i++) {
        const double angle = uniform(&g, 0, 2 * PI);
        const vec3 a = {(real)(1e15 * cos(angle)), (real)(1e15 * sin(angle)), -1};
        const vec3 b = {-a.x / 8, -a.y / 8, -1}; // exact: on the line through a and the middle
        const vec3 left = {-a.y, a.x, -1}, right = {a.y, -a.x, -1};
        words about;
        snprintf(about.chars, sizeof about.chars,
                 "two triangles on either side of the edge from " VEC " to " VEC, ARG(a),
                 ARG(b));
        counts got = {0};
        count_drawn(&got, flat_screen, (triangle){a, b, left});
        count_drawn(&got, flat_screen, (triangle){a, b, right});
        check_same(about.chars, &got, &want);
    }
}

// ---- z-buffer ---------------------------------------------------------------------------

enum { SOME = 12 };

static void depth_in_buffer(void) {
    const projection P = {W, H, 30};
    const vec3 n = {(real)0.375, (real)-0.5, -1};
    const double D = 3;
    // The corners lie on X·n = D, exactly: x and y are chosen, z follows.
    const vec3 p[] = {{-2, -1, (real)-3.25}, {2, (real)-1.5, (real)-1.5}, {0, 1, (real)-3.5}};
    const painted tri = {{p[0], p[1], p[2]}, {1, 1, 1}};
    framebuffer fb = framebuffer_new(W, H, (color){0, 0, 0});
    rasterize(&fb, P, tri);
    int pixels_covered = 0;
    for (int y = 0; y < H; y++)
        for (int x = 0; x < W; x++) {
            const double depth_in_z_buffer = fb.depth[y * W + x];
            if (depth_in_z_buffer == (double)INFINITY) continue;
            pixels_covered++;
            given("a triangle in the plane X·n = 3, n = " VEC ", at the pixel (%d, %d)", ARG(n),
                  x, y);
            CHECK_REAL(depth_in_z_buffer, plane_depth(P, n, D, x + 0.5, y + 0.5),
                       relative_to(1e-13, "roundings in double"));
        }
    CHECK(pixels_covered > 300, "the test itself: enough pixels are covered");
    framebuffer_free(&fb);
}

static exact triangle_depth(projection P, triangle t, double x, double y) {
    const exact_point a = exact_project(P, t.p1), b = exact_project(P, t.p2),
                      c = exact_project(P, t.p3);
    const exact w1 = (c.y - b.y) * (x - b.x) - (c.x - b.x) * (y - b.y);
    const exact w2 = (a.y - c.y) * (x - c.x) - (a.x - c.x) * (y - c.y);
    const exact w3 = (b.y - a.y) * (x - a.x) - (b.x - a.x) * (y - a.y);
    return (w1 + w2 + w3) / (w1 / -t.p1.z + w2 / -t.p2.z + w3 / -t.p3.z);
}

// Triangles that pierce each other, against the nearest in exact arithmetic.
static void nearest_wins(void) {
    const projection P = {W, H, 30};
    rng g = rng_seed(1, 17);
    for (int n = 0; n < 20; n++) {
        painted tris[SOME];
        framebuffer fb = framebuffer_new(W, H, (color){0, 0, 0});
        for (int i = 0; i < SOME; i++) {
            tris[i] = (painted){random_triangle(&g, 0.7), {(real)(i + 1), 0, 0}};
            rasterize(&fb, P, tris[i]);
        }
        for (int k = 0; k < W * H; k++) {
            const double x = k % W + 0.5, y = k / W + 0.5;
            int nearest = 0;
            exact least = 1e30;
            for (int i = 0; i < SOME; i++) {
                if (!exact_covers(P, tris[i].t, x, y)) continue;
                const exact depth = triangle_depth(P, tris[i].t, x, y);
                if (depth < least) nearest = i + 1, least = depth;
            }
            const int triangle_seen = (int)image_at(&fb.img, k % W, k / W)->x;
            given("triangles 1 to %d that pierce each other: which is seen in the pixel "
                  "(%d, %d)? 0: none",
                  SOME, k % W, k / W);
            CHECK_INT(triangle_seen, nearest);
        }
        framebuffer_free(&fb);
    }
}

static bool same_picture(const framebuffer *a, const framebuffer *b) {
    const size_t count = (size_t)a->img.width * (size_t)a->img.height;
    return memcmp(a->img.pixels, b->img.pixels, count * sizeof *a->img.pixels) == 0 &&
           memcmp(a->depth, b->depth, count * sizeof *a->depth) == 0;
}

static projection demo_view(int width, int height) {
    return (projection){width, height, focal_length(height, DEMO_FOV)};
}

static framebuffer draw_demo(const painted *triangles) {
    const projection P = demo_view(240, 150);
    framebuffer fb = framebuffer_new(P.width, P.height, demo_background);
    for (int i = 0; i < demo_triangle_count; i++) rasterize(&fb, P, triangles[i]);
    return fb;
}

static void any_order(void) {
    painted *mixed = malloc((size_t)demo_triangle_count * sizeof *mixed);
    for (int i = 0; i < demo_triangle_count; i++) mixed[i] = demo_triangles[i];
    framebuffer want = draw_demo(demo_triangles);
    rng g = rng_seed(1, 18);
    for (int n = 0; n < 10; n++) {
        for (int i = demo_triangle_count - 1; i > 0; i--) {
            const int k = (int)(rng_double(&g) * (i + 1));
            const painted swapped = mixed[i];
            mixed[i] = mixed[k];
            mixed[k] = swapped;
        }
        framebuffer got = draw_demo(mixed);
        given("the scene's triangles in random order, shuffle %d", n + 1);
        CHECK(same_picture(&got, &want), "the picture does not depend on the order of drawing");
        framebuffer_free(&got);
    }
    framebuffer_free(&want);
    free(mixed);
}

static void first_stays(void) {
    const triangle t = {{-5, -4, -4}, {6, -4, -4}, {0, 5, -4}}, turned = {t.p1, t.p3, t.p2};
    const projection P = {W, H, 10};
    framebuffer fb = framebuffer_new(W, H, (color){0, 0, 0});
    rasterize(&fb, P, (painted){t, {1, 0, 0}});
    rasterize(&fb, P, (painted){t, {2, 0, 0}});
    rasterize(&fb, P, (painted){turned, {3, 0, 0}});
    const int paint_seen = (int)image_at(&fb.img, W / 2, H / 2)->x;
    given("three triangles in the same place, painted 1, 2, 3 in this order");
    suspect_value("the last one drawn: depth <= nearest in place of <", 3);
    CHECK_INT(paint_seen, 1);
    framebuffer_free(&fb);
}

// ---- the rest of the module -----------------------------------------------------------------

static void projected(void) {
    CHECK_REAL(focal_length(480, 90), 240, roundings(2, "one tangent"));
    CHECK_REAL(focal_length(300, 60), 150 * sqrt(3.0), roundings(2, "one tangent"));
    // 30 pixels before the eye, so (2, 1, -4) stands 15 to the right, 7.5 up.
    const projection P = {W, H, 30};
    const raster_point p = project(P, (vec3){2, 1, -4});
    given("an image of 48 x 32, focal length 30 pixels, the point (2, 1, -4)");
    CHECK_REAL(p.x, 24 + 15, exactly());
    CHECK_REAL(p.y, 16 - 7.5, exactly());
    CHECK_REAL(p.depth, 4, exactly());
}

static void bands(void) {
    const projection P = demo_view(240, 150);
    framebuffer want = draw_demo(demo_triangles);
    for (int threads = 1; threads <= 5; threads++) {
#ifdef _OPENMP
        omp_set_num_threads(threads);
#endif
        framebuffer got = framebuffer_new(P.width, P.height, demo_background);
        CHECK_INT(rasterize_all(&got, P, demo_triangles, demo_triangle_count), 0);
        given("rasterize_all with %d threads, against rasterize one by one", threads);
        CHECK(same_picture(&got, &want),
              "threads share the rows, not the pixels: no difference");
        framebuffer_free(&got);
    }
    framebuffer_free(&want);
}

// Paint is a colour times 0.25 + 0.75 max(0, cos θ), as scene.c says; red beside
// green tells the colour, so only its largest part is compared within a solid.
static void scene_is_generic(void) {
    const int sizes[][2] = {{640, 400}, {480, 300}, {480, 320}, {640, 480}, {320, 240}};
    for (int s = 0; s < COUNT(sizes); s++) {
        const projection P = demo_view(sizes[s][0], sizes[s][1]);
        double least = INFINITY;
        for (int i = 0; i < demo_triangle_count; i++) {
            const triangle t = demo_triangles[i].t;
            const raster_point a = project(P, t.p1), b = project(P, t.p2), c = project(P, t.p3);
            const raster_point ends[][2] = {{a, b}, {b, c}, {c, a}};
            for (int k = 0; k < 3; k++)
                for (int y = 0; y < P.height; y++) {
                    const raster_point p = ends[k][0], q = ends[k][1];
                    const double at = p.x + (y + 0.5 - p.y) * (q.x - p.x) / (q.y - p.y);
                    least = fmin(least, fabs(at - 0.5 - nearbyint(at - 0.5)));
                }
        }
        given("the scene at %d x %d pixels", P.width, P.height);
        CHECK(least > 1e-9, "no edge passes a pixel's centre within 1e-9 pixels");
    }
}

static void scene_light(void) {
    const double l[] = {0.45, 0.8, 0.55};
    for (int i = 0; i < demo_triangle_count; i++) {
        const triangle t = demo_triangles[i].t;
        CHECK(t.p1.z < 0 && t.p2.z < 0 && t.p3.z < 0, "the scene lies in front of the eye");
        const vec3 n = cross(sub(t.p2, t.p1), sub(t.p3, t.p1));
        const double along = n.x * l[0] + n.y * l[1] + n.z * l[2];
        const double size = (double)length(n) * sqrt(l[0] * l[0] + l[1] * l[1] + l[2] * l[2]);
        const double k = 0.25 + 0.75 * fmax(along / size, 0);
        const color paint = demo_triangles[i].paint;
        const double brightest = fmax(fmax((double)paint.x, (double)paint.y), (double)paint.z);
        // The paints' largest parts: scene.c.
        static const double paints[] = {0.50, 0.33, 1.00, 0.85, 0.55, 0.90, 0.58, 0.65};
        double off = 1;
        for (int c = 0; c < COUNT(paints); c++)
            off = fmin(off, fabs(brightest / paints[c] - k));
        given("triangle %d of the scene, k = %.4f", i, k);
        CHECK_AT_MOST(off, 0.006, "k is written with two decimals");
    }
}

int main(void) {
    static const char *const by_pencil = "Draw the three points with y downwards: is (x, y) on "
                                         "your left on the way from a to b?";
    static const char *const sign_then_digits =
        "First the sign: draw the points with y downwards; on the left of the way from a to b "
        "it is positive. If only digits differ: double from beginning to end, and subtract "
        "corners before you multiply.";
    static const char *const covered =
        "A pixel belongs to the triangle when its centre is left of all three edges. Beside an "
        "edge the last digits decide: double from beginning to end.";
    static const char *const one_owner =
        "Of the two triangles at an edge exactly one owns it: left edges and top edges.";
    static const char *const reciprocal =
        "First the formula: what is linear on the screen, depth or 1/depth? Do the weights add "
        "up to 1? If only digits differ: double from beginning to end.";
    static const char *const corner =
        "At a corner only that corner counts: which edge function is not zero there? If only "
        "digits differ: double from beginning to end.";
    static const char *const either_way =
        "The corners may turn either way round: all three areas then change sign, and so does "
        "their sum. If only digits differ: double from beginning to end.";
    static const char *const module =
        "This judges rasterize.c, once the three exercises are right.";
    static const test tests[] = {
        {"edge_function: worked out by hand", edge_by_hand, by_pencil},
        {"edge_function: 3000 generic edges", edge_generic, sign_then_digits},
        {"edge_function: from 1e-9 to 1e12 pixels", edge_scales, sign_then_digits},
        {"edge_function: 1e9 pixels away", edge_far_away, sign_then_digits},
        {"edge_function: turned, rotated, moved", edge_properties, sign_then_digits},
        {"edge_function: coverage, against exact arithmetic", coverage_counted, covered},
        {"edge_function: coverage by huge triangles", coverage_huge, covered},
        {"owns_edge: eight directions", owns_directions,
         "Which side of the triangle is the edge? Walk round it counter-clockwise."},
        {"owns_edge: one owner for each edge", owns_one_of_two, one_owner},
        {"owns_edge: a rectangle of two triangles", rectangle, one_owner},
        {"owns_edge: a fan around a pixel", fan, one_owner},
        {"owns_edge: random meshes, each pixel drawn once", random_meshes, one_owner},
        {"depth_at: worked out by hand", depth_by_hand, reciprocal},
        {"depth_at: at the corners", depth_of_corners, corner},
        {"depth_at: 3000 planes, 1e-6 to 1e9 away", depth_of_planes, reciprocal},
        {"depth_at: the order of the corners", depth_order, either_way},
        {"depth_at: to the horizon, and 1e-6 pixels wide", depth_extremes, reciprocal},
        {"depth_at: in the z-buffer", depth_in_buffer, reciprocal},
        {"depth_at: the nearest of 12 triangles", nearest_wins, reciprocal},
        {"depth_at: any order of drawing", any_order, reciprocal},
        {"rasterize: projection", projected, module},
        {"rasterize: either orientation", either_orientation, module},
        {"rasterize: moved by whole pixels", translated, module},
        {"rasterize: the world scaled, 2^±30 and 1e±10", scaled_world, module},
        {"rasterize: zero area", nothing_to_fill, module},
        {"rasterize: NaN and infinity", not_numbers, module},
        {"rasterize: behind the eye", behind_the_eye, module},
        {"rasterize: a shared edge of 1e15 pixels", endless_edges, module},
        {"rasterize: of equal depths the first stays", first_stays, module},
        {"rasterize_all: any number of threads", bands, module},
        {"scene: no pixel's centre on an edge", scene_is_generic, module},
        {"scene: the light in the paint", scene_light, module},
    };
    return run_tests("01-rasterize", tests, COUNT(tests));
}
