// exact.c: judges depth, normals and mirrors pixel by pixel. A value must lie within 0.001 of
// what is right anywhere within a fiftieth of a pixel around the centre; where an edge passes as
// near as that, either side is right.
#include "tests/homework/homework.h"

#include <stdio.h>
#include <stdlib.h>

enum { NEIGHBOURS = 9, PIXELS = WIDTH * HEIGHT };
static const double reach = 0.02; // pixels
static const double tolerance[] = {[DEPTH] = 1e-3, [NORMAL] = 1e-3, [MIRROR] = 3e-3};

// What a pixel may show.
typedef struct {
    double low[CHANNELS], high[CHANNELS], centre[CHANNELS];
    int body;
    bool edge; // not judged
} range;

static range range_at(stage s, int x, int y, int wrong) {
    range r = {
        {INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}, {0}, 0, false};
    uint64_t history = 0;
    for (int i = 0; i < NEIGHBOURS; i++) {
        const int k = (i + 4) % 9; // the centre first
        const seen there =
            truth_seen(s, x + 0.5 + reach * (k % 3 - 1), y + 0.5 + reach * (k / 3 - 1), wrong);
        if (i == 0) {
            r.body = there.body, history = there.history;
            for (int c = 0; c < CHANNELS; c++) r.centre[c] = there.value[c];
        }
        r.edge |= there.history != history;
        for (int c = 0; c < CHANNELS; c++) {
            r.low[c] = fmin(r.low[c], there.value[c]);
            r.high[c] = fmax(r.high[c], there.value[c]);
        }
    }
    for (int c = 0; c < CHANNELS; c++) {
        const double slack = tolerance[s] * (s == DEPTH ? fabs(r.centre[c]) : 1);
        r.low[c] -= slack, r.high[c] += slack;
    }
    return r;
}

static void all_ranges(stage s, int wrong, range *ranges) {
    for (int i = 0; i < PIXELS; i++) ranges[i] = range_at(s, i % WIDTH, i / WIDTH, wrong);
}

// ---- what may have been done to a right picture -----------------------------------------

typedef struct {
    int flip;  // 1: left to right, 2: upside down
    bool swap; // red and blue
    int curve;
} change;

static double same(double v) {
    return v;
}
static double undo_twice(double v) {
    return srgb_decoded(srgb_decoded(v));
}
static double undo_power(double v) {
    return pow(fmax(v, 0), 2.2);
}
static double undo_square(double v) {
    return pow(fmax(v, 0), 1 / 2.2);
}
static double undo_negative(double v) {
    return -v;
}
static double undo_bytes(double v) {
    return v / 255;
}
static const struct {
    double (*undo)(double v);
    const char *words;
    int stages;
} curves[] = {
    {same, "", 1 << DEPTH | 1 << NORMAL | 1 << MIRROR},
    {srgb_decoded, "the sRGB curve (gamma) was applied: a PFM holds linear light", 1 << MIRROR},
    {undo_power, "gamma 2.2 was applied: a PFM holds linear light", 1 << MIRROR},
    {undo_twice, "gamma was applied, and twice: a PFM holds linear light", 1 << MIRROR},
    {undo_square, "the inverse of gamma was applied: a PFM holds linear light", 1 << MIRROR},
    {undo_negative, "the sign is wrong", 1 << NORMAL},
    {undo_bytes, "the values are 255 times too large", 1 << MIRROR},
};

static bool pixel_agrees(const picture *got, const range *r, int x, int y, change w) {
    const double *v = got->at[w.flip & 2 ? HEIGHT - 1 - y : y][w.flip & 1 ? WIDTH - 1 - x : x];
    for (int c = 0; c < CHANNELS; c++) {
        const double value = curves[w.curve].undo(v[w.swap ? 2 - c : c]);
        if (!(value >= r->low[c] && value <= r->high[c])) return false;
    }
    return true;
}

// The share of the judged pixels that agree. `bodies`: the background does not count.
static double agreement(const picture *got, const range *ranges, change w, bool bodies) {
    int judged = 0, agree = 0;
    for (int i = 0; i < PIXELS; i++) {
        if (ranges[i].edge || (bodies && ranges[i].body < 0)) continue;
        judged++;
        agree += pixel_agrees(got, &ranges[i], i % WIDTH, i / WIDTH, w);
    }
    return (double)agree / judged;
}

typedef struct {
    double agreement;
    change change;
    int mistake;
} guess;

static void try_changes(stage s, const picture *got, const range *ranges, int m, guess *best) {
    for (int flip = 0; flip < 4; flip++)
        for (int swap = 0; swap < 2; swap++)
            for (int curve = 0; curve < COUNT(curves); curve++) {
                if (!(curves[curve].stages & 1 << s)) continue;
                const change w = {flip, swap == 1, curve};
                const double share = agreement(got, ranges, w, s == NORMAL);
                if (share > best->agreement + 0.002) *best = (guess){share, w, m};
            }
}

static guess best_guess(stage s, const picture *got) {
    guess best = {0};
    range *ranges = calloc(PIXELS, sizeof *ranges);
    if (!ranges) runner_die("get memory");
    for (int m = 0; m < mistake_count; m++) {
        if (!(mistakes[m].stages & 1 << s)) continue;
        all_ranges(s, mistakes[m].id, ranges);
        try_changes(s, got, ranges, m, &best);
    }
    free(ranges);
    return best;
}

static void add_words(text *t, const char *words) {
    if (*words) text_row(t, "likely", "%s", words);
}

static void explain_guess(text *t, guess g) {
    if (g.change.flip & 1) add_words(t, "mirrored left to right");
    if (g.change.flip & 2)
        add_words(t, "upside down: a PFM begins with the lowest row of the picture");
    if (g.change.swap) add_words(t, "red and blue are swapped");
    add_words(t, curves[g.change.curve].words);
    add_words(t, mistakes[g.mistake].words);
}

// ---- where it is wrong, when no guess fits ------------------------------------------------

enum { MOST_BODIES = 8 };

static void describe_places(stage s, const picture *got, const range *ranges, text *t) {
    int judged[MOST_BODIES] = {0}, wrong[MOST_BODIES] = {0};
    for (int i = 0; i < PIXELS; i++) {
        if (ranges[i].edge) continue;
        const bool agrees = pixel_agrees(got, &ranges[i], i % WIDTH, i / WIDTH, (change){0});
        judged[ranges[i].body + 1]++;
        wrong[ranges[i].body + 1] += !agrees;
    }
    for (int b = 0; b < MOST_BODIES; b++) {
        if (!judged[b]) continue;
        const char *name = truth_body(s, b - 1);
        if (!wrong[b])
            text_row(t, "right", "%s", name);
        else
            text_row(t, "wrong", "%s: %.3g %% of its pixels", name,
                     100.0 * wrong[b] / judged[b]);
    }
}

// Wrong pixels with a right one on each side.
static bool is_speckled(const picture *got, const range *ranges) {
    int wrong = 0, lone = 0;
    for (int i = 0; i < PIXELS; i++) {
        const int x = i % WIDTH, y = i / WIDTH;
        if (x == 0 || x == WIDTH - 1 || ranges[i].edge) continue;
        if (pixel_agrees(got, &ranges[i], x, y, (change){0})) continue;
        wrong++;
        lone += pixel_agrees(got, &ranges[i - 1], x - 1, y, (change){0}) ||
                pixel_agrees(got, &ranges[i + 1], x + 1, y, (change){0});
    }
    return wrong > 20 && 4 * lone > wrong;
}

static void describe_pixel(stage s, const picture *got, const range *ranges, text *t) {
    int worst = 0;
    double most = -1;
    for (int i = 0; i < PIXELS; i++)
        for (int c = 0; c < CHANNELS && !ranges[i].edge; c++) {
            const double d = fabs(got->at[i / WIDTH][i % WIDTH][c] - ranges[i].centre[c]);
            if (d > most) most = d, worst = i;
        }
    const double *v = got->at[worst / WIDTH][worst % WIDTH], *w = ranges[worst].centre;
    text_row(t, "for example", "x %d, y %d (%s)", worst % WIDTH, worst / WIDTH,
             truth_body(s, ranges[worst].body));
    text_row(t, "expected", "(%.5g, %.5g, %.5g)", w[0], w[1], w[2]);
    text_row(t, "got", "(%.5g, %.5g, %.5g)", v[0], v[1], v[2]);
}

// ---- the verdict -----------------------------------------------------------------------

static void draw(stage s, const char *name, const picture *got, const range *ranges) {
    double *right = calloc(PIXELS * CHANNELS, sizeof *right);
    if (!right) runner_die("get memory");
    for (int i = 0; i < PIXELS; i++)
        for (int c = 0; c < CHANNELS; c++) right[CHANNELS * i + c] = ranges[i].centre[c];
    const double offset = s == NORMAL ? 1 : 0;
    const double shown = s == NORMAL ? 0.5 : s == DEPTH ? 0.1 : 1;
    draw_difference(name, WIDTH, HEIGHT, &got->at[0][0][0], right, s == DEPTH ? 1 : 0.3, offset,
                    shown);
    free(right);
}

static _Noreturn void say_what_is_wrong(stage s, const char *name, const picture *got,
                                        const range *ranges, double share) {
    static text t;
    const guess g = best_guess(s, got);
    if (g.agreement > 0.98 && g.agreement > share)
        explain_guess(&t, g);
    else if (is_speckled(got, ranges))
        add_words(&t, "speckles: a ray hits again, at t near 0, what it has just left");
    describe_places(s, got, ranges, &t);
    describe_pixel(s, got, ranges, &t);
    text_row(&t, "picture", "%s/%s.png: yours, right, difference", program_folder(), name);
    fail(&t, "%s: %.3g %% of the pixels are wrong", name, 100 * (1 - share));
}

void judge_exact(stage s, const char *name) {
    const picture *got = program_draw(name, "12345");
    if (!got) return;
    static range ranges[PIXELS];
    all_ranges(s, 0, ranges);
    draw(s, name, got, ranges);
    const double share = agreement(got, ranges, (change){0}, false);
    if (share < 1) say_what_is_wrong(s, name, got, ranges, share);
}
