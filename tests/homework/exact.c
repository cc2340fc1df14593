// exact.c: judges depth, normals and mirrors pixel by pixel. A value must lie within 0.001 of
// what is right anywhere within a fiftieth of a pixel around the centre; where an edge passes as
// near as that, either side is right.
#include "tests/homework/homework.h"

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
    int flip;     // 1: left to right, 2: upside down
    bool swap;    // red and blue
    bool clamped; // to [0, 1]
    int curve;
} change;

static void undo_srgb(double v[CHANNELS]) {
    for (int c = 0; c < CHANNELS; c++) v[c] = v[c] < 0 ? v[c] / 12.92 : srgb_decoded(v[c]);
}
static void undo_twice(double v[CHANNELS]) {
    undo_srgb(v), undo_srgb(v);
}
static void undo_power(double v[CHANNELS]) {
    for (int c = 0; c < CHANNELS; c++) v[c] = pow(fmax(v[c], 0), 2.2);
}
static void undo_square(double v[CHANNELS]) {
    for (int c = 0; c < CHANNELS; c++) v[c] = pow(fmax(v[c], 0), 1 / 2.2);
}
static void undo_negative(double v[CHANNELS]) {
    for (int c = 0; c < CHANNELS; c++) v[c] = -v[c];
}
static void undo_bytes(double v[CHANNELS]) {
    for (int c = 0; c < CHANNELS; c++) v[c] /= 255;
}
static void undo_length(double v[CHANNELS]) {
    const double size = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (int c = 0; c < CHANNELS && size > 0; c++) v[c] /= size;
}
enum { GREY = 1 << DEPTH | 1 << MIRROR };
static const struct {
    void (*undo)(double v[CHANNELS]); // NULL: nothing was done
    const char *words;
    int stages;
} curves[] = {
    {NULL, "", GREY | 1 << NORMAL},
    {undo_srgb, "the sRGB curve (gamma) was applied: a PFM holds linear values",
     GREY | 1 << NORMAL},
    {undo_power, "gamma 2.2 was applied: a PFM holds linear values", GREY},
    {undo_twice, "gamma was applied, and twice: a PFM holds linear values", 1 << MIRROR},
    {undo_square, "the inverse of gamma was applied: a PFM holds linear values", GREY},
    {undo_negative, "the sign is wrong", 1 << NORMAL},
    {undo_length, "the normals have the right direction, but are not of unit length",
     1 << NORMAL},
    {undo_bytes, "the values are 255 times too large", GREY},
};

static double clamped(double v) {
    return fmin(fmax(v, 0), 1);
}

// `got`: without the curve.
static bool pixel_agrees(const picture *got, const range *r, int x, int y, change w) {
    const double *v = got->at[w.flip & 2 ? HEIGHT - 1 - y : y][w.flip & 1 ? WIDTH - 1 - x : x];
    for (int c = 0; c < CHANNELS; c++) {
        const double value = v[w.swap ? 2 - c : c];
        const double low = w.clamped ? clamped(r->low[c]) : r->low[c];
        const double high = w.clamped ? clamped(r->high[c]) : r->high[c];
        if (!(value >= low && value <= high)) return false;
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
    return judged < PIXELS / 3 ? 0 : (double)agree / judged; // chaos proves nothing
}

typedef struct {
    double agreement;
    change change;
    int mistake;
} guess;

// Tries what was done to the picture on what the mistake m shows. The swap of grey is none.
static void try_changes(stage s, const picture *undone, const range *ranges, int m,
                        guess *best) {
    for (int curve = 0; curve < COUNT(curves); curve++) {
        if (!(curves[curve].stages & 1 << s)) continue;
        for (int i = 0; i < 16; i++) {
            const change w = {i & 3, (i & 4) != 0, (i & 8) != 0, curve};
            if ((w.swap && s == DEPTH) || (w.clamped && (s == MIRROR || curve))) continue;
            const double share = agreement(&undone[curve], ranges, w, s == NORMAL);
            const bool better =
                share > best->agreement + 0.002 || 1 - share < 0.2 * (1 - best->agreement);
            if (better) *best = (guess){share, w, m};
        }
    }
}

static guess best_guess(stage s, const picture *got) {
    static picture undone[COUNT(curves)];
    guess best = {0};
    range *ranges = calloc(PIXELS, sizeof *ranges);
    if (!ranges) runner_die("get memory");
    for (int curve = 0; curve < COUNT(curves); curve++) {
        undone[curve] = *got;
        for (int i = 0; i < PIXELS && curves[curve].undo; i++)
            curves[curve].undo(undone[curve].at[i / WIDTH][i % WIDTH]);
    }
    for (int m = 0; m < mistake_count; m++) {
        if (!(mistakes[m].stages & 1 << s)) continue;
        all_ranges(s, mistakes[m].id, ranges);
        try_changes(s, undone, ranges, m, &best);
    }
    free(ranges);
    return best;
}

static void add_words(text *t, const char *words) {
    if (*words) text_row(t, "likely", "%s", words);
}

static void explain_guess(stage s, text *t, guess g) {
    if (g.change.flip & 1) add_words(t, "mirrored left to right");
    if (g.change.flip & 2) add_words(t, UPSIDE_DOWN);
    if (g.change.swap)
        add_words(t, s == NORMAL ? "x and z are swapped" : "red and blue are swapped");
    add_words(t, curves[g.change.curve].words);
    if (g.change.clamped)
        add_words(t, s == NORMAL ? "cut off to 0..1: the parts of n go from -1 to 1"
                                 : "values above 1 are cut off: a PFM keeps them");
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
            text_row(t, "wrong", "%s: %s %% of its pixels", name,
                     fixed_number(100.0 * wrong[b] / judged[b]));
    }
}

// Is all right but the mirrors?
static bool only_mirrors(const picture *got, const range *ranges) {
    for (int i = 0; i < PIXELS; i++) {
        if (ranges[i].edge || truth_is_mirror(MIRROR, ranges[i].body)) continue;
        if (!pixel_agrees(got, &ranges[i], i % WIDTH, i / WIDTH, (change){0})) return false;
    }
    return true;
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

static int worst_pixel(const picture *got, const range *ranges) {
    int worst = 0;
    double most = -1;
    for (int i = 0; i < PIXELS; i++)
        for (int c = 0; c < CHANNELS && !ranges[i].edge; c++) {
            const double d = fabs(got->at[i / WIDTH][i % WIDTH][c] - ranges[i].centre[c]);
            if (d > most) most = d, worst = i;
        }
    return worst;
}

static void describe_pixel(stage s, const picture *got, const range *ranges, int i, text *t) {
    const double *v = got->at[i / WIDTH][i % WIDTH], *w = ranges[i].centre;
    text_row(t, "for example", "x %d, y %d (%s)", i % WIDTH, i / WIDTH,
             truth_body(s, ranges[i].body));
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
    draw_difference(name, got, WIDTH, HEIGHT, &got->at[0][0][0], right, s == DEPTH ? 1 : 0.3,
                    offset, shown);
    free(right);
}

static void row_of_picture(text *t, const char *name) {
    text_row(t, "picture", "%s/%s.png: yours, right, difference", program_folder(), name);
}

// What NaN and infinity tell by their places.
static const char *why_not_finite(stage s, const picture *got, const range *ranges) {
    bool background = true, negative = true;
    for (int i = 0; i < PIXELS; i++)
        for (int c = 0; c < CHANNELS; c++) {
            if (isfinite(got->at[i / WIDTH][i % WIDTH][c]) || ranges[i].edge) continue;
            background &= ranges[i].body < 0;
            negative &= ranges[i].low[c] < 0;
        }
    if (background && s != MIRROR) return "it is where nothing is hit: 0 is asked for there";
    if (negative && s == NORMAL)
        return "it is where n is negative: pow() or sqrt() of it. A normal is no colour: no "
               "gamma";
    return NULL;
}

static void judge_finite(stage s, const char *name, const picture *got, const range *ranges) {
    const bad_pixels bad = program_bad_pixels(got, false);
    if (!bad.count) return;
    static text t;
    const char *why = why_not_finite(s, got, ranges);
    if (why) add_words(&t, why);
    describe_pixel(s, got, ranges, bad.first, &t);
    row_of_picture(&t, name);
    fail(&t, "%s: %d pixel%s not finite (NaN or infinity), the first at x %d, y %d%s", name,
         bad.count, bad.count == 1 ? " is" : "s are", bad.first % WIDTH, bad.first / WIDTH,
         why ? "" : ": 0/0?");
}

static const char reflected_right[] =
    "is the reflected direction d - 2 (n·d) n, with a unit n, and still a unit vector?";

// What negative values tell, when no guess fits.
static const char *why_negative(stage s, const picture *got, const range *ranges) {
    if (s == MIRROR) return reflected_right;
    bool background = true;
    for (int i = 0; i < PIXELS; i++)
        if (got->at[i / WIDTH][i % WIDTH][0] < 0 && ranges[i].body >= 0 && !ranges[i].edge)
            background = false;
    return background ? "a sign for \"no hit\" is left in the picture: 0 is asked for there"
                      : "a hit behind the eye: t < 0 is taken for a hit";
}

static _Noreturn void say_what_is_wrong(stage s, const char *name, const picture *got,
                                        const range *ranges, double share) {
    static text t;
    const guess g = best_guess(s, got);
    const bad_pixels bad = program_bad_pixels(got, s != NORMAL);
    if (g.agreement > 0.98 && g.agreement > share)
        explain_guess(s, &t, g);
    else if (bad.count)
        add_words(&t, why_negative(s, got, ranges));
    else if (is_speckled(got, ranges))
        add_words(&t, "speckles: a ray hits again, at t near 0, what it has just left");
    else if (s == MIRROR && only_mirrors(got, ranges))
        add_words(&t, reflected_right);
    describe_places(s, got, ranges, &t);
    describe_pixel(s, got, ranges, bad.count ? bad.first : worst_pixel(got, ranges), &t);
    row_of_picture(&t, name);
    if (bad.count)
        fail(&t, "%s: %d pixel%s negative, light and distances are not", name, bad.count,
             bad.count == 1 ? " is" : "s are");
    fail(&t, "%s: %s %% of the pixels are wrong", name, fixed_number(100 * (1 - share)));
}

void judge_exact(stage s, const char *name) {
    const picture *got = program_draw(name, "12345");
    if (!got) return;
    static range ranges[PIXELS];
    all_ranges(s, 0, ranges);
    draw(s, name, got, ranges);
    judge_finite(s, name, got, ranges);
    const double share = agreement(got, ranges, (change){0}, false);
    if (share < 1) say_what_is_wrong(s, name, got, ranges, share);
}
