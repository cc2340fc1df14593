// measure.c: which pixels does a triangle cover, and how far away is it there?
// Ways to work that out, their error and their cost.
#include "common/measure.h"

#include <stdlib.h>
#include <string.h>
#ifdef _OPENMP
#include <omp.h>
#endif

#include "chapters/01-rasterize/rasterize.h"
#include "common/rng.h"

enum { CASES = 50000, ROUNDS = 9, WIDTH = 1920, HEIGHT = 1080 };

// Variants that do not use real are the same in both builds: told once.
static bool is_told(bool uses_real) {
    return uses_real || sizeof(real) == sizeof(float);
}

static double uniform(rng *g, double low, double high) {
    return low + (high - low) * rng_double(g);
}

// ---- the sign of the edge function --------------------------------------------------

typedef struct {
    raster_point a, b;
    double x, y; // a pixel's centre
} edge_case;

static exact exact_edge(raster_point a, raster_point b, double x, double y) {
    return ((exact)b.y - a.y) * ((exact)x - a.x) - ((exact)b.x - a.x) * ((exact)y - a.y);
}

// The corners, too, are rounded to real.
static double edge_real(raster_point a, raster_point b, double x, double y) {
    const real ax = (real)a.x, ay = (real)a.y, bx = (real)b.x, by = (real)b.y;
    return (by - ay) * ((real)x - ax) - (bx - ax) * ((real)y - ay);
}

static double edge_mixed(raster_point a, raster_point b, double x, double y) {
    const double ax = (real)a.x, ay = (real)a.y, bx = (real)b.x, by = (real)b.y;
    return (by - ay) * (x - ax) - (bx - ax) * (y - ay);
}

// Whole multiples of 1/grid pixel, kept within 2^30 so that no product overflows.
static int64_t snap(double x, int grid) {
    const double limit = 1 << 30;
    return (int64_t)nearbyint(fmin(fmax(x * grid, -limit), limit));
}

static double edge_fixed(raster_point a, raster_point b, double x, double y, int grid) {
    const int64_t ax = snap(a.x, grid), ay = snap(a.y, grid);
    const int64_t bx = snap(b.x, grid), by = snap(b.y, grid);
    return (double)((by - ay) * (snap(x, grid) - ax) - (bx - ax) * (snap(y, grid) - ay));
}

static double edge_16(raster_point a, raster_point b, double x, double y) {
    return edge_fixed(a, b, x, y, 16);
}

static double edge_256(raster_point a, raster_point b, double x, double y) {
    return edge_fixed(a, b, x, y, 256);
}

typedef struct {
    const char *name;
    double (*edge)(raster_point a, raster_point b, double x, double y);
    bool uses_real;
} edge_variant;

static const edge_variant edge_variants[] = {
    {"all in real", edge_real, true},
    {"corners in real, products in double", edge_mixed, false},
    {"corners in whole 1/16 pixels", edge_16, false},
    {"corners in whole 1/256 pixels", edge_256, false},
    {"edge_function (all in double)", edge_function, false},
};

// A vector of unit length, all directions alike.
static void direction(rng *g, double *x, double *y) {
    double length2;
    do {
        *x = uniform(g, -1, 1);
        *y = uniform(g, -1, 1);
        length2 = *x * *x + *y * *y;
    } while (length2 > 1 || length2 < 0.01);
    *x /= sqrt(length2);
    *y /= sqrt(length2);
}

// An edge that passes a pixel's centre at most half a pixel away, or half its own
// length if it is shorter than a pixel.
static edge_case near_centre(rng *g, double length) {
    edge_case c;
    c.x = floor(uniform(g, 0, WIDTH)) + 0.5;
    c.y = floor(uniform(g, 0, HEIGHT)) + 0.5;
    double ux, uy;
    direction(g, &ux, &uy);
    const double aside = uniform(g, -0.5, 0.5) * fmin(length, 1);
    const double before = uniform(g, 0.1, 0.9) * length;
    c.a = (raster_point){c.x - aside * uy - before * ux, c.y + aside * ux - before * uy, 1};
    c.b = (raster_point){c.a.x + length * ux, c.a.y + length * uy, 1};
    return c;
}

static int sign(double x) {
    return (x > 0) - (x < 0);
}

static void wrong_sides(double length) {
    for (int v = 0; v < COUNT(edge_variants); v++) {
        if (!is_told(edge_variants[v].uses_real)) continue;
        rng g = rng_seed(1, 1);
        int wrong = 0;
        for (int i = 0; i < CASES; i++) {
            const edge_case c = near_centre(&g, length);
            const exact e = exact_edge(c.a, c.b, c.x, c.y);
            wrong += sign(edge_variants[v].edge(c.a, c.b, c.x, c.y)) != (e > 0) - (e < 0);
        }
        csv_row("edge function: wrong side", edge_variants[v].name, "length in pixels", length,
                "share of pixels on the wrong side", (double)wrong / CASES, "ns", NAN);
    }
}

// ---- two triangles that share an edge ---------------------------------------------------

static bool inside(double e, raster_point a, raster_point b) {
    return e > 0 || (e == 0 && owns_edge(a, b));
}

// Each triangle walks the edge in its own direction.
static int owners_each(edge_case c) {
    return inside(edge_real(c.a, c.b, c.x, c.y), c.a, c.b) +
           inside(edge_real(c.b, c.a, c.x, c.y), c.b, c.a);
}

// Both start from the same end.
static int owners_same_end(edge_case c) {
    const double e = edge_real(c.a, c.b, c.x, c.y);
    return inside(e, c.a, c.b) + inside(-e, c.b, c.a);
}

static void shared_edges(double length) {
    static int (*const owners[])(edge_case c) = {owners_each, owners_same_end};
    static const char *const names[] = {"each from its own end", "both from the same end"};
    for (int v = 0; v < COUNT(owners); v++) {
        rng g = rng_seed(1, 2);
        int wrong = 0;
        for (int i = 0; i < CASES; i++) wrong += owners[v](near_centre(&g, length)) != 1;
        csv_row("shared edge: pixels without one owner", names[v], "length in pixels", length,
                "share of pixels drawn twice or never", (double)wrong / CASES, "ns", NAN);
    }
}

// ---- along a row: worked out anew, or stepped ---------------------------------------------

enum { EDGES = 64 };
typedef struct {
    raster_point a[EDGES], b[EDGES];
    int pixels;
    double end[EDGES]; // the edge function in the last pixel
} row;

// (b - a) x (p - a) at p = (x + 0.5, 0.5); from one pixel to the next it grows by
// b.y - a.y.
#define ROW(name, number, at, step)                                                            \
    static void name(void *data) {                                                             \
        row *r = data;                                                                         \
        for (int i = 0; i < EDGES; i++) {                                                      \
            const number ax = (number)r->a[i].x, ay = (number)r->a[i].y;                       \
            const number dx = (number)r->b[i].x - ax, dy = (number)r->b[i].y - ay;             \
            number e = dy * ((number)0.5 - ax) - dx * ((number)0.5 - ay);                      \
            long covered = e > 0;                                                              \
            for (int x = 1; x < r->pixels; x++) {                                              \
                e = (at) ? dy * (x + (number)0.5 - ax) - dx * ((number)0.5 - ay) : e + (step); \
                covered += e > 0;                                                              \
            }                                                                                  \
            r->end[i] = (double)e;                                                             \
            keep((double)covered);                                                             \
        }                                                                                      \
    }
ROW(anew_real, real, true, 0)
ROW(stepped_real, real, false, dy)
ROW(anew_double, double, true, 0)
ROW(stepped_double, double, false, dy)

// Corners on multiples of 1/256 pixel: whole numbers do not round.
static void stepped_fixed(void *data) {
    row *r = data;
    for (int i = 0; i < EDGES; i++) {
        const int64_t ax = snap(r->a[i].x, 256), ay = snap(r->a[i].y, 256);
        const int64_t dx = snap(r->b[i].x, 256) - ax, dy = snap(r->b[i].y, 256) - ay;
        int64_t e = dy * (128 - ax) - dx * (128 - ay);
        long covered = e > 0;
        for (int x = 1; x < r->pixels; x++) {
            e += 256 * dy;
            covered += e > 0;
        }
        r->end[i] = (double)e / 65536;
        keep((double)covered);
    }
}

static const timed row_variants[] = {
    // the first two use real
    {"worked out anew, real", anew_real},           {"stepped, real", stepped_real},
    {"worked out anew in double", anew_double},     {"stepped in double", stepped_double},
    {"stepped, whole 1/256 pixels", stepped_fixed},
};

static void rows(int pixels) {
    static row r;
    rng g = rng_seed(1, 3);
    r.pixels = pixels;
    for (int i = 0; i < EDGES; i++) {
        r.a[i] = (raster_point){uniform(&g, 0, pixels), uniform(&g, -1000, 0), 1};
        r.b[i] = (raster_point){uniform(&g, 0, pixels), uniform(&g, 1, 1000), 1};
    }
    double ns[COUNT(row_variants)];
    measure_ns(row_variants, COUNT(row_variants), &r, (long)EDGES * pixels, ROUNDS, ns);
    for (int v = 0; v < COUNT(row_variants); v++) {
        if (!is_told(v < 2)) continue;
        double error[EDGES];
        row_variants[v].run(&r);
        for (int i = 0; i < EDGES; i++) {
            const raster_point a = r.a[i], b = r.b[i];
            const double length = sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y));
            error[i] = fabs((double)(r.end[i] - exact_edge(a, b, pixels - 0.5, 0.5))) / length;
        }
        csv_row("edge function: along a row", row_variants[v].name, "pixels", pixels,
                "the edge is off by pixels, worst", quantile(error, EDGES, 1), "ns", ns[v]);
    }
}

// ---- depth in a pixel
// ------------------------------------------------------------------------

typedef struct {
    raster_point p[CASES][3];
    double x[CASES], y[CASES];
    exact depth[CASES];
} depth_cases;

// Wrong, but no rounding can save it: depth is not linear on the screen.
static double depth_linear(const raster_point p[3], double x, double y) {
    const double w0 = edge_function(p[1], p[2], x, y);
    const double w1 = edge_function(p[2], p[0], x, y);
    const double w2 = edge_function(p[0], p[1], x, y);
    return (w0 * p[0].depth + w1 * p[1].depth + w2 * p[2].depth) / (w0 + w1 + w2);
}

static double depth_real(const raster_point p[3], double x, double y) {
    const real w0 = (real)edge_real(p[1], p[2], x, y);
    const real w1 = (real)edge_real(p[2], p[0], x, y);
    const real w2 = (real)edge_real(p[0], p[1], x, y);
    return (w0 + w1 + w2) /
           (w0 / (real)p[0].depth + w1 / (real)p[1].depth + w2 / (real)p[2].depth);
}

static exact depth_exact(const raster_point p[3], double x, double y) {
    const exact w0 = exact_edge(p[1], p[2], x, y), w1 = exact_edge(p[2], p[0], x, y);
    const exact w2 = exact_edge(p[0], p[1], x, y);
    return (w0 + w1 + w2) / (w0 / p[0].depth + w1 / p[1].depth + w2 / p[2].depth);
}

#define TIMED_DEPTH(f)                                                       \
    static void run_##f(void *data) {                                        \
        const depth_cases *c = data;                                         \
        double sum = 0;                                                      \
        for (int i = 0; i < CASES; i++) sum += f(c->p[i], c->x[i], c->y[i]); \
        keep(sum);                                                           \
    }
TIMED_DEPTH(depth_linear)
TIMED_DEPTH(depth_real)
TIMED_DEPTH(depth_at)

static const struct {
    const char *name;
    double (*depth)(const raster_point p[3], double x, double y);
    bool uses_real;
} depth_variants[] = {
    {"1/depth linear, real", depth_real, true},
    {"1/depth linear, double (depth_at)", depth_at, false},
    {"depth linear (the mistake)", depth_linear, false},
};
static const timed depth_timings[] = {
    {"real", run_depth_real},
    {"double", run_depth_at},
    {"linear", run_depth_linear},
};

// Triangles with one corner at depth 1, one at `ratio` and one between, and a
// pixel somewhere inside.
static void fill_depths(depth_cases *c, double ratio) {
    rng g = rng_seed(1, 4);
    for (int i = 0; i < CASES; i++) {
        raster_point *p = c->p[i];
        for (int k = 0; k < 3; k++) {
            p[k].x = uniform(&g, 0, WIDTH);
            p[k].y = uniform(&g, 0, HEIGHT);
        }
        p[0].depth = 1;
        p[1].depth = ratio;
        p[2].depth = uniform(&g, 1, ratio);
        const double v = uniform(&g, 0.05, 0.95), u = uniform(&g, 0.05, 0.95) * (1 - v);
        c->x[i] = p[0].x + u * (p[1].x - p[0].x) + v * (p[2].x - p[0].x);
        c->y[i] = p[0].y + u * (p[1].y - p[0].y) + v * (p[2].y - p[0].y);
        c->depth[i] = depth_exact(p, c->x[i], c->y[i]);
    }
}

static void depths(double ratio) {
    static depth_cases c;
    fill_depths(&c, ratio);
    double ns[COUNT(depth_timings)];
    measure_ns(depth_timings, COUNT(depth_timings), &c, CASES, ROUNDS, ns);
    for (int v = 0; v < COUNT(depth_variants); v++) {
        if (!is_told(depth_variants[v].uses_real)) continue;
        static double error[CASES];
        for (int i = 0; i < CASES; i++)
            error[i] =
                REAL_EPSILON *
                relative_error(depth_variants[v].depth(c.p[i], c.x[i], c.y[i]), c.depth[i]);
        csv_row("depth in a pixel", depth_variants[v].name, "farthest / nearest corner", ratio,
                "relative error of depth, median", quantile(error, CASES, 0.5), "ns", ns[v]);
    }
}

// ---- filling a triangle
// ---------------------------------------------------------------------------

enum { TRIANGLES = 32 };
typedef struct {
    raster_point p[TRIANGLES][3]; // counter-clockwise on the screen
    unsigned char drawn[WIDTH * HEIGHT];
} canvas;

static int within(double x, int most) {
    return (int)fmin(fmax(x, 0), most);
}

static void box_of(const raster_point p[3], int *x0, int *x1, int *y0, int *y1) {
    *x0 = within(floor(fmin(p[0].x, fmin(p[1].x, p[2].x))), WIDTH);
    *x1 = within(floor(fmax(p[0].x, fmax(p[1].x, p[2].x)) + 1), WIDTH);
    *y0 = within(floor(fmin(p[0].y, fmin(p[1].y, p[2].y))), HEIGHT);
    *y1 = within(floor(fmax(p[0].y, fmax(p[1].y, p[2].y)) + 1), HEIGHT);
}

// As the module: three edge functions in every pixel of the box.
static void fill_anew(canvas *c, const raster_point p[3]) {
    int x0, x1, y0, y1;
    box_of(p, &x0, &x1, &y0, &y1);
    for (int y = y0; y < y1; y++)
        for (int x = x0; x < x1; x++)
            c->drawn[y * WIDTH + x] +=
                inside(edge_function(p[0], p[1], x + 0.5, y + 0.5), p[0], p[1]) &&
                inside(edge_function(p[1], p[2], x + 0.5, y + 0.5), p[1], p[2]) &&
                inside(edge_function(p[2], p[0], x + 0.5, y + 0.5), p[2], p[0]);
}

// The edge functions are worked out at the left end of each row, then stepped.
static void fill_stepped(canvas *c, const raster_point p[3]) {
    int x0, x1, y0, y1;
    box_of(p, &x0, &x1, &y0, &y1);
    const real step0 = (real)(p[1].y - p[0].y), step1 = (real)(p[2].y - p[1].y),
               step2 = (real)(p[0].y - p[2].y);
    for (int y = y0; y < y1; y++) {
        real e0 = (real)edge_function(p[0], p[1], x0 + 0.5, y + 0.5);
        real e1 = (real)edge_function(p[1], p[2], x0 + 0.5, y + 0.5);
        real e2 = (real)edge_function(p[2], p[0], x0 + 0.5, y + 0.5);
        for (int x = x0; x < x1; x++, e0 += step0, e1 += step1, e2 += step2)
            c->drawn[y * WIDTH + x] += e0 > 0 && e1 > 0 && e2 > 0;
    }
}

// Where the row through y meets the edge: it ends the row's pixels on the left or
// on the right.
static void cut_row(raster_point a, raster_point b, double y, double *left, double *right) {
    if (a.y == b.y) return;
    const double x = a.x + (y - a.y) * (b.x - a.x) / (b.y - a.y);
    if (b.y > a.y && x > *left) *left = x;
    if (b.y < a.y && x < *right) *right = x;
}

static void fill_rows(canvas *c, const raster_point p[3]) {
    int x0, x1, y0, y1;
    box_of(p, &x0, &x1, &y0, &y1);
    for (int y = y0; y < y1; y++) {
        double left = x0, right = x1;
        cut_row(p[0], p[1], y + 0.5, &left, &right);
        cut_row(p[1], p[2], y + 0.5, &left, &right);
        cut_row(p[2], p[0], y + 0.5, &left, &right);
        const int from = within(ceil(left - 0.5), WIDTH), to = within(ceil(right - 0.5), WIDTH);
        for (int x = from; x < to; x++) c->drawn[y * WIDTH + x]++;
    }
}

#define TIMED_FILL(f)                                      \
    static void run_##f(void *data) {                      \
        canvas *c = data;                                  \
        for (int i = 0; i < TRIANGLES; i++) f(c, c->p[i]); \
        keep(c->drawn[WIDTH + 1]);                         \
    }
TIMED_FILL(fill_anew)
TIMED_FILL(fill_stepped)
TIMED_FILL(fill_rows)

static const timed fill_variants[] = {
    {"three edge functions a pixel", run_fill_anew},
    {"edge functions stepped, real", run_fill_stepped},
    {"each row from left to right end", run_fill_rows},
};
static const bool fill_uses_real[] = {false, true, false};

// Triangles of about `side` pixels, in generic positions.
static void fill_canvas(canvas *c, double side) {
    rng g = rng_seed(1, 5);
    for (int i = 0; i < TRIANGLES; i++) {
        const double x = uniform(&g, side, WIDTH - side), y = uniform(&g, side, HEIGHT - side);
        double ux, uy;
        direction(&g, &ux, &uy);
        const double across = uniform(&g, 0.5, 1) * side;
        c->p[i][0] = (raster_point){x, y, 1};
        c->p[i][1] = (raster_point){x + side * ux, y + side * uy, 1};
        c->p[i][2] = (raster_point){x + across * (uy + ux / 3), y - across * (ux - uy / 3), 1};
    }
}

// How often each pixel is drawn, in exact arithmetic. Returns how often in all.
static long count_exactly(const canvas *c, unsigned char *drawn) {
    long covered = 0;
    for (int i = 0; i < TRIANGLES; i++) {
        const raster_point *p = c->p[i];
        int x0, x1, y0, y1;
        box_of(p, &x0, &x1, &y0, &y1);
        for (int y = y0; y < y1; y++)
            for (int x = x0; x < x1; x++) {
                const bool in = exact_edge(p[0], p[1], x + 0.5, y + 0.5) > 0 &&
                                exact_edge(p[1], p[2], x + 0.5, y + 0.5) > 0 &&
                                exact_edge(p[2], p[0], x + 0.5, y + 0.5) > 0;
                drawn[y * WIDTH + x] += in;
                covered += in;
            }
    }
    return covered;
}

static void fills(double side) {
    static canvas c;
    static unsigned char want[WIDTH * HEIGHT];
    memset(want, 0, sizeof want);
    fill_canvas(&c, side);
    const long covered = count_exactly(&c, want);
    double ns[COUNT(fill_variants)];
    measure_ns(fill_variants, COUNT(fill_variants), &c, covered, ROUNDS, ns);
    for (int v = 0; v < COUNT(fill_variants); v++) {
        if (!is_told(fill_uses_real[v] || v == 0)) continue;
        memset(c.drawn, 0, sizeof c.drawn);
        fill_variants[v].run(&c);
        long wrong = 0;
        for (int i = 0; i < COUNT(want); i++) wrong += abs(c.drawn[i] - want[i]);
        csv_row("filling triangles", fill_variants[v].name, "side in pixels", side,
                "share of wrong pixels", (double)wrong / covered, "ns per covered pixel",
                ns[v]);
    }
}

// ---- "highly parallel"
// ------------------------------------------------------------------------------

typedef struct {
    framebuffer fb;
    projection P;
    painted triangles[TRIANGLES];
} frame;

static void use_threads(int threads) {
#ifdef _OPENMP
    omp_set_num_threads(threads);
#else
    (void)threads;
#endif
}

static void draw(frame *f, int threads) {
    use_threads(threads);
    rasterize_all(&f->fb, f->P, f->triangles, TRIANGLES);
}

static void draw_1(void *data) {
    draw(data, 1);
}

static void draw_2(void *data) {
    draw(data, 2);
}

static const timed thread_variants[] = {{"1 thread", draw_1}, {"2 threads", draw_2}};

static void fill_frame(frame *f, double side) {
    static canvas c;
    fill_canvas(&c, side);
    f->P = (projection){WIDTH, HEIGHT, 1000};
    f->fb = framebuffer_new(WIDTH, HEIGHT, (color){0, 0, 0});
    for (int i = 0; i < TRIANGLES; i++) {
        vec3 p[3];
        for (int k = 0; k < 3; k++) // at depth 1000 + i a unit is nearly a pixel
            p[k] = (vec3){(real)(c.p[i][k].x - WIDTH / 2.0), (real)(HEIGHT / 2.0 - c.p[i][k].y),
                          (real)(-1000 - i)};
        f->triangles[i] = (painted){{p[0], p[1], p[2]}, {1, 1, (real)i}};
    }
}

static void threads(double side) {
    frame one, two;
    fill_frame(&one, side);
    fill_frame(&two, side);
    draw_1(&one);
    draw_2(&two);
    long covered = 0, wrong = 0;
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        covered += one.fb.depth[i] < (double)INFINITY;
        wrong += one.fb.depth[i] != two.fb.depth[i];
    }
    double ns[COUNT(thread_variants)];
    measure_ns(thread_variants, COUNT(thread_variants), &one, covered, ROUNDS, ns);
    for (int v = 0; v < COUNT(thread_variants); v++)
        csv_row("threads", thread_variants[v].name, "side in pixels", side,
                "share of pixels that differ from one thread's",
                v ? (double)wrong / covered : 0, "ns per visible pixel", ns[v]);
    framebuffer_free(&one.fb);
    framebuffer_free(&two.fb);
}

int main(void) {
    for (int k = -6; k <= 9; k += 3) wrong_sides(pow(10, k));
    for (int k = -6; k <= 9; k += 3) shared_edges(pow(10, k));
    for (int pixels = 16; pixels <= 16384; pixels *= 8) rows(pixels);
    static const double ratios[] = {1.01, 2, 10, 1e3, 1e6};
    for (int i = 0; i < COUNT(ratios); i++) depths(ratios[i]);
    for (int side = 2; side <= 512; side *= 4) fills(side);
    if (sizeof(real) == sizeof(float))
        for (int side = 2; side <= 512; side *= 4) threads(side);
}
