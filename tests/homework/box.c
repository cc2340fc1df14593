// box.c: scene 3 in double, as far as judging needs it: which body is seen where, how much of
// the lamp reaches it; and the converged reference.
#include "tests/homework/homework.h"

#include <string.h>

const char *const box_body_name[BOX_BODIES] = {
    "the red wall",  "the green wall", "the floor",       "the ceiling",
    "the back wall", "the blue ball",  "the yellow ball", "the lamp",
};
enum { LAMP = 7 };

// ---- what is seen --------------------------------------------------------------------

typedef struct {
    wide3 p, n;
    int body;
} place;

typedef struct {
    double t;
    int body;
} nearest;

static void meet(nearest *best, double t, int body) {
    if (t > 0 && t < best->t) *best = (nearest){t, body};
}

static const struct {
    wide3 c;
    double r;
} balls[] = {{{-0.42, 0.45, -0.35}, 0.45}, {{0.5, 0.3, 0.3}, 0.3}};

static double ball_t(int i, wide3 O, wide3 d) {
    const wide3 v = wide_along(O, -1, balls[i].c);
    const double b = wide_dot(v, d);
    const double D = b * b - wide_dot(v, v) + balls[i].r * balls[i].r;
    return D < 0 ? -1 : -b - sqrt(D);
}

static void meet_lamp(nearest *best, wide3 O, wide3 d) {
    const double t = (1.9 - O.y) / d.y;
    const wide3 p = wide_along(O, t, d);
    if (p.x > -0.35 && p.x < 0.45 && p.z > -0.5 && p.z < 0.3) meet(best, t, LAMP);
}

static place place_at(double x, double y) {
    static const wide3 inwards[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
    const wide3 O = {0.1, 1.05, 3.3};
    const wide3 forward = wide_unit((wide3){-0.1, -0.1, -3.3});
    const wide3 right = wide_unit(wide_cross(forward, (wide3){0, 1, 0}));
    const wide3 up = wide_cross(right, forward);
    const double half = tan(20 * PI / 180);
    const wide3 ahead = wide_along(forward, half * (2 * x - WIDTH) / HEIGHT, right);
    const wide3 d = wide_unit(wide_along(ahead, half * (1 - 2 * y / HEIGHT), up));
    nearest best = {INFINITY, -1};
    meet(&best, (-1 - O.x) / d.x, 0);
    meet(&best, (1 - O.x) / d.x, 1);
    meet(&best, -O.y / d.y, 2);
    meet(&best, (2 - O.y) / d.y, 3);
    meet(&best, (-1 - O.z) / d.z, 4);
    for (int i = 0; i < COUNT(balls); i++) meet(&best, ball_t(i, O, d), 5 + i);
    meet_lamp(&best, O, d);
    place s = {.p = wide_along(O, best.t, d), .body = best.body};
    if (s.body < COUNT(inwards)) s.n = inwards[s.body];
    if (s.body == 5 || s.body == 6) s.n = wide_unit(wide_along(s.p, -1, balls[s.body - 5].c));
    return s;
}

int box_body_in(int block) {
    const int left = block % ACROSS * BLOCK, top = block / ACROSS * BLOCK;
    const int body = place_at(left, top).body;
    for (int i = 0; i <= 2 * (BLOCK + 1); i++) // half a pixel beyond the block on each side
        for (int j = 0; j <= 2 * (BLOCK + 1); j++)
            if (place_at(left - 0.5 + i / 2.0, top - 0.5 + j / 2.0).body != body) return -1;
    return body;
}

bool box_is_lamp(double x, double y) {
    return place_at(x, y).body == LAMP;
}

bool box_lamp_near(int x, int y) {
    for (int k = 0; k < 25; k++)
        if (box_is_lamp(x + k % 5 - 1.5, y + k / 5 - 1.5)) return true;
    return false;
}

// The irradiance from the lamp without any shadow, of the radiance 1: ∫ cos θ cos θ' / r² dA.
static double unshadowed(place s) {
    enum { SIDE = 8 };
    double sum = 0;
    for (int i = 0; i < SIDE * SIDE; i++) {
        const wide3 y = {-0.35 + 0.8 * (i % SIDE + 0.5) / SIDE, 1.9,
                         -0.5 + 0.8 * (i / SIDE + 0.5) / SIDE};
        const wide3 d = wide_along(y, -1, s.p);
        const double at_x = wide_dot(s.n, d), at_y = d.y, square = wide_dot(d, d);
        if (at_x > 0 && at_y > 0) sum += at_x * at_y / (square * square);
    }
    return sum * 0.64 / (SIDE * SIDE);
}

double box_lit(int block, const double light_1[CHANNELS]) {
    static const double albedo[] = {0.1, 0.4, 0.68, 0.68, 0.68, 0.45, 0.55}; // green
    const int left = block % ACROSS * BLOCK, top = block / ACROSS * BLOCK;
    const place s = place_at(left + BLOCK / 2.0, top + BLOCK / 2.0);
    if (s.body == LAMP) return 1;
    const double full = 9 * albedo[s.body] / PI * unshadowed(s);
    return full > 0 ? light_1[1] / full : 1;
}

// ---- the reference ---------------------------------------------------------------------

reference *reference_read(void) {
    static float values[LAYERS * BLOCKS * CHANNELS];
    static reference r;
    const char *path = "tests/homework/reference.pfm";
    const char *reason = pfm_read(path, ACROSS, LAYERS * DOWN, values);
    if (reason) fail(NULL, "%s: %s", path, reason);
    for (int i = 0; i < COUNT(values); i++) (&r.light[0][0][0])[i] = values[i];
    return &r;
}
