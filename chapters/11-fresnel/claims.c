// claims.c: see claims.h. The derivations are in README.md.
#include "chapters/11-fresnel/claims.h"

#include "common/wide3.h"

// ---- a glass ball under the sun ------------------------------------------------------

double ball_focus(double n) {
    return n / (2 * (n - 1));
}

// A ray of light in the plane through the ball's centre: from the angle `at` on the ball's
// rim, measured from the top, towards the angle `to`; what it still carries.
typedef struct {
    double at, to, power;
} beam;

// What leaves after `chords` chords through the ball, for light that falls in from straight
// above at the distance sin(in) from the axis: each chord turns it by π - 2 out, and each end of
// a chord but the last reflects.
static beam beam_out(double n, double in, int chords) {
    const double out = asin(sin(in) / n);
    const double R = (double)fresnel_dielectric((real)cos(in), (real)n);
    const double at = in + chords * (PI - 2 * out);
    return (beam){at, at + in, (1 - R) * (1 - R) * pow(R, chords - 1)};
}

// A unit vector perpendicular to the unit vector a.
static wide3 beside(wide3 a, double turn) {
    const frame f = orthonormal_basis(narrow(a));
    const wide3 s = widen(f.s), t = widen(f.t);
    return wide_along((wide3){cos(turn) * s.x, cos(turn) * s.y, cos(turn) * s.z}, sin(turn), t);
}

// In the plane of `axis` and `side`: the direction at this angle from the axis.
static wide3 turned(wide3 axis, wide3 side, double angle) {
    const double c = cos(angle);
    return wide_along((wide3){c * axis.x, c * axis.y, c * axis.z}, sin(angle), side);
}

typedef struct {
    image map;
    double half_width, weight; // of one photon, as irradiance
} plate;

static void land(plate *p, const ball_lens *B, wide3 O, wide3 d, double power) {
    if (!(d.y < 0)) return;
    const wide3 q = wide_along(O, (O.y + B->depth) / -d.y, d);
    const double scaled = p->map.width / (2 * p->half_width);
    const double x = (q.x + p->half_width) * scaled, y = (q.z + p->half_width) * scaled;
    if (!(x >= 0 && y >= 0 && x < p->map.width && y < p->map.height)) return;
    const real light = (real)(power * p->weight);
    color *const at = image_at(&p->map, (int)x, (int)y);
    *at = add(*at, (color){light, light, light});
}

// One photon: its direction by the sun's irradiance (uniform in the disc of its sines), its
// place uniform over the disc that the ball is to the sun.
static void photon(plate *p, const ball_lens *B, rng *g) {
    enum { CHORDS = 6 }; // the light left after so many is far below a standard error
    const double sine = sin(B->sun) * sqrt(rng_double(g));
    const double round = 2 * PI * rng_double(g);
    const wide3 axis = {sine * cos(round), sqrt(1 - sine * sine), sine * sin(round)};
    const double in = asin(sqrt(rng_double(g)));
    const wide3 side = beside(axis, 2 * PI * rng_double(g));
    for (int chords = 1; chords <= CHORDS; chords++) {
        const beam b = beam_out(B->n, in, chords);
        land(p, B, turned(axis, side, b.at), turned(axis, side, b.to), b.power / axis.y);
    }
}

image caustic_forwards(const ball_lens *B, double half_width, int size, long photons, rng *g) {
    const double pixel = 2 * half_width / size;
    plate p = {image_new(size, size), half_width, PI / ((double)photons * pixel * pixel)};
    for (long i = 0; i < photons; i++) photon(&p, B, g);
    return p.map;
}

// Only the cone in which the ball is seen: chapter 10's sphere_direction.
double caustic_backwards(const glass_room *sc, const ball_lens *B, double x, double z, rng *g) {
    enum { BOUNCES = 16 };
    const sphere ball = sc->room.bodies.spheres[0];
    const vec3 O = {(real)x, (real)-B->depth, (real)z}, d = sphere_direction(ball, O, g);
    const real p = sphere_probability(ball, O, d);
    if (!(p > 0)) return 0; // the rim, rounded: the ray misses the ball
    const color L = glass_trace(sc, (ray){O, d}, BOUNCES, g);
    const double sun = PI * sin(B->sun) * sin(B->sun);
    return (double)(L.y * fmax(d.y, 0) / p) / sun;
}

// ---- from under water ----------------------------------------------------------------

double window_radius(double n, double h) {
    return h * tan(asin(1 / n));
}

double window_light(double n, double cosine) {
    const double sine = n * sqrt((1 - cosine) * (1 + cosine)); // above the surface
    if (!(sine < 1)) return 0;
    const double up = sqrt((1 - sine) * (1 + sine));
    const double rs = (n * cosine - up) / (n * cosine + up);
    const double rp = (cosine - n * up) / (cosine + n * up);
    return n * n * (1 - (rs * rs + rp * rp) / 2);
}

// ---- comparing -------------------------------------------------------------------------

// The variance of a + b is that of a - b: the sum over mirrored pairs of (a - b)² estimates
// that of the whole sum.
estimate ring_mean(const image *img, double r0, double r1) {
    double sum = 0, squares = 0;
    long n = 0;
    for (int y = 0; y < img->height; y++)
        for (int x = 0; x < img->width / 2; x++) {
            const double r = hypot(x + 0.5 - img->width / 2.0, y + 0.5 - img->height / 2.0);
            if (r < r0 || r >= r1) continue;
            const double a = image_at(img, x, y)->y;
            const double b = image_at(img, img->width - 1 - x, y)->y;
            sum += a + b;
            squares += (a - b) * (a - b);
            n += 2;
        }
    return (estimate){sum / (double)n, sqrt(squares) / (double)n, n};
}

double errors_apart(estimate measured, estimate expected) {
    return (measured.value - expected.value) /
           hypot(measured.standard_error, expected.standard_error);
}
