// path.c: judges the path traced picture. Any method and any number of samples is right whose
// mean is right: two pictures with different seeds tell the noise, and the mean of both is
// compared with the converged reference, part by part, in units of its standard error.
#include "tests/homework/homework.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TILE = 4, TILES_ACROSS = ACROSS / TILE, TILES = TILES_ACROSS * (DOWN / TILE) };
enum { SHADOWS = BOX_BODIES, EDGES, FIRST_TILE, PARTS = FIRST_TILE + TILES };
enum { FEWEST_BLOCKS = 6 }; // of a part: 96 pixels tell its noise

// Six standard errors: Bonferroni over 58 parts of three colours, 174 · 2 (1 - Φ(6)) < 1e-6 for
// normal noise; less than 1e-5 where only 96 pixels tell how large it is.
static const double most_z = 6;
static const double reference_error = 0.001; // relative, of a part: measured, 0.0004 on average
static const double too_noisy = 0.10; // relative standard error of a body: then 1/2 is seen
static const double weak = 0.20, goal = 0.05; // the relative error that would have been found

typedef struct {
    int count, blocks[BLOCKS];
} part;

static void add_block(part *p, int block) {
    p->blocks[p->count++] = block;
}

static void find_parts(reference *right, part parts[PARTS]) {
    memset(parts, 0, PARTS * sizeof *parts);
    for (int b = 0; b < BLOCKS; b++) {
        const int body = box_body_in(b);
        if (body < 0) {
            add_block(&parts[EDGES], b);
            continue;
        }
        const int tile = b / ACROSS / TILE * TILES_ACROSS + b % ACROSS / TILE;
        add_block(&parts[body], b);
        add_block(&parts[FIRST_TILE + tile], b);
        if (box_lit(b, right->light[LIGHT_0 + 1][b]) < 0.5 && body != 3)
            add_block(&parts[SHADOWS], b); // the ceiling has no direct light at all
    }
}

static const char *part_name(int p) {
    if (p < BOX_BODIES) return box_body_name[p];
    if (p == SHADOWS) return "the shadows";
    if (p == EDGES) return "the edges between bodies";
    const int tile = p - FIRST_TILE, x = tile % TILES_ACROSS, y = tile / TILES_ACROSS;
    return text_kept("the square x %d to %d, y %d to %d", 16 * x, 16 * x + 15, 16 * y,
                     16 * y + 15);
}

// ---- noise ---------------------------------------------------------------------------

// Of the mean M = (A + B)/2 of two independent pictures: (A - B)/2 has M's variance, mean 0.
void measure_blocks(const picture *a, const picture *b, measured *m) {
    memset(m, 0, sizeof *m);
    const double n = BLOCK * BLOCK;
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++)
            for (int c = 0; c < CHANNELS; c++) {
                const int block = y / BLOCK * ACROSS + x / BLOCK;
                const double d = (a->at[y][x][c] - b->at[y][x][c]) / 2;
                m->mean[block][c] += (a->at[y][x][c] + b->at[y][x][c]) / (2 * n);
                m->variance[block][c] += d * d / (n * n);
            }
}

// 1 when the noise of neighbouring pixels is independent, BLOCK² when it is the same: the
// mean of (Σ d)² / Σ d² over blocks. Stratified samples give less.
static double noise_together(const picture *a, const picture *b) {
    double sum = 0;
    int count = 0;
    for (int i = 0; i < BLOCKS * CHANNELS; i++) {
        const int c = i % CHANNELS, block = i / CHANNELS;
        const int left = block % ACROSS * BLOCK, top = block / ACROSS * BLOCK;
        double whole = 0, squares = 0;
        for (int k = 0; k < BLOCK * BLOCK; k++) {
            const int x = left + k % BLOCK, y = top + k / BLOCK;
            const double d = a->at[y][x][c] - b->at[y][x][c];
            whole += d, squares += d * d;
        }
        if (squares == 0) continue;
        sum += whole * whole / squares, count++;
    }
    return count ? sum / count : 1;
}

// Pixels that show something but the lamp, and the same in both.
static double share_of_same(const picture *a, const picture *b) {
    int shown = 0, same = 0;
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        const double *v = a->at[i / WIDTH][i % WIDTH], *w = b->at[i / WIDTH][i % WIDTH];
        if (box_body_in(i / WIDTH / BLOCK * ACROSS + i % WIDTH / BLOCK) == 7) continue;
        if (v[0] + v[1] + v[2] == 0) continue;
        shown++;
        same += v[0] == w[0] && v[1] == w[1] && v[2] == w[2];
    }
    return shown ? (double)same / shown : 0;
}

// ---- the test ------------------------------------------------------------------------

typedef struct {
    double ratio[CHANNELS], error[CHANNELS], z[CHANNELS]; // got / right, its standard error
    double all, all_error;                                // of the three colours' sum
    double worst;                                         // |z|
} compared;

static compared compare(const part *p, const measured *m, double right[][CHANNELS],
                        double together) {
    compared r = {0};
    double got_sum = 0, right_sum = 0, variance_sum = 0;
    for (int c = 0; c < CHANNELS; c++) {
        double got = 0, want = 0, variance = 0;
        for (int i = 0; i < p->count; i++) {
            const int b = p->blocks[i];
            got += m->mean[b][c], want += right[b][c];
            variance += m->variance[b][c] * fmax(together, 1);
        }
        if (want <= 0) { // a guess: nothing at all; guess.c has seen to it
            r.ratio[c] = 1, r.error[c] = 0, r.z[c] = 0;
            continue;
        }
        const double sure = reference_error * want;
        r.ratio[c] = got / want;
        r.error[c] = sqrt(variance + sure * sure) / want;
        r.z[c] = (r.ratio[c] - 1) / r.error[c];
        r.worst = fmax(r.worst, fabs(r.z[c]));
        got_sum += got, right_sum += want, variance_sum += sqrt(variance);
    }
    r.all = right_sum > 0 ? got_sum / right_sum : 1;
    r.all_error =
        right_sum > 0 ? variance_sum / right_sum : 0; // the colours' noise goes together
    return r;
}

static bool is_judged(const part *p) {
    return p->count >= FEWEST_BLOCKS;
}

// ---- words ---------------------------------------------------------------------------

static const char *amount(double ratio) {
    if (ratio >= 2) return text_kept("%s times too bright", fixed_number(ratio));
    if (ratio < 1e-6) return "black";
    if (ratio <= 0.5) return text_kept("%s times too dark", fixed_number(1 / ratio));
    return text_kept("%s %% too %s", fixed_number(100 * fabs(ratio - 1)),
                     ratio > 1 ? "bright" : "dark");
}

static void add_channel(text *t, const char *name, double ratio) {
    if (ratio >= 2)
        text_add(t, "%s %s times", name, fixed_number(ratio));
    else
        text_add(t, "%s %s%s %%", name, ratio < 1 ? "-" : "+",
                 fixed_number(100 * fabs(ratio - 1)));
}

static void describe_part(text *t, int p, const compared *r) {
    const double spread = fmax(r->ratio[0], fmax(r->ratio[1], r->ratio[2])) -
                          fmin(r->ratio[0], fmin(r->ratio[1], r->ratio[2]));
    const bool colored = spread > 0.01 && spread > 5 * r->error[0];
    const bool right_sum = colored && fabs(r->all - 1) < 0.01;
    text words = {0};
    text_add(&words, "%s: %s", part_name(p), right_sum ? "the colour" : amount(r->all));
    if (colored) {
        text_add(&words, ": ");
        add_channel(&words, "red", r->ratio[0]);
        add_channel(&words, ", green", r->ratio[1]);
        add_channel(&words, ", blue", r->ratio[2]);
    }
    text_row(t, "wrong", "%s (noise: %s %%)", words.chars, fixed_number(100 * r->all_error));
}

static void describe_parts(text *t, const part *parts, const compared *results) {
    text right = {0};
    int wrong = 0;
    for (int p = 0; p < FIRST_TILE; p++) {
        if (!is_judged(&parts[p])) continue;
        if (results[p].worst > most_z)
            describe_part(t, p, &results[p]), wrong++;
        else
            text_add(&right, "%s%s", right.length ? ", " : "", part_name(p));
    }
    if (right.length) text_row(t, "right", "%s", right.chars);
    int squares = 0;
    for (int p = FIRST_TILE; p < PARTS && !wrong; p++)
        if (is_judged(&parts[p]) && results[p].worst > most_z && squares++ < 5)
            describe_part(t, p, &results[p]);
    if (squares > 5) text_row(t, "wrong", "and %d squares more", squares - 5);
}

// Is the light of most blocks more than three times what is possible? The mean of a right one is
// right, and it is not negative: by Markov's inequality at most a third of them is, however noisy.
static bool is_far_too_bright(const measured *m, reference *right) {
    int lit = 0, bright = 0;
    for (int b = 0; b < BLOCKS; b++) {
        const double *got = m->mean[b], *want = right->light[ALL_LIGHT][b];
        if (right->light[LIGHT_0][b][0] > 0) continue; // the lamp
        lit++;
        bright += got[0] + got[1] + got[2] > 3 * (want[0] + want[1] + want[2]);
    }
    return 2 * bright > lit;
}

// ---- where the rays go through the pixels ----------------------------------------------

// The lamp's edges tell it, since it is bright and without noise. Rays from `from` to `from` +
// `size` in both directions; the sum of the squares of what that leaves unexplained.
static double lamp_misfit(const picture *a, const picture *b, reference *right, double from,
                          double size) {
    enum { FINE = 6 };
    double sum = 0;
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        const int x = i % WIDTH, y = i / WIDTH;
        if (!box_lamp_near(x, y)) continue;
        double covered = 0;
        for (int k = 0; k < FINE * FINE; k++)
            covered += box_is_lamp(x + from + size * (k % FINE + 0.5) / FINE,
                                   y + from + size * (k / FINE + 0.5) / FINE);
        covered /= FINE * FINE;
        const double ceiling = right->light[ALL_LIGHT][0][0]; // small beside the lamp
        const double got = (a->at[y][x][0] + b->at[y][x][0]) / 2;
        const double off = fmin(got, 11) - (covered * 11 + (1 - covered) * ceiling);
        sum += off * off;
    }
    return sum;
}

static const char *where_rays_go(const picture *a, const picture *b, reference *right) {
    static const struct {
        double from, size;
        const char *words;
    } ways[] = {
        {0.5, 0, "the rays are not spread over the whole pixel: all go through its middle"},
        {0, 0,
         "the rays are not spread over the whole pixel: all go through its corner. They go "
         "from "
         "x to x + 1, y to y + 1"},
        {-0.5, 1,
         "all is half a pixel off: the rays of a pixel go from x to x + 1 and y to y + 1, not "
         "from x - 0.5 to x + 0.5"},
    };
    double least = 0.5 * lamp_misfit(a, b, right, 0, 1);
    const char *words = NULL;
    for (int i = 0; i < COUNT(ways); i++) {
        const double now = lamp_misfit(a, b, right, ways[i].from, ways[i].size);
        if (now < least) least = now, words = ways[i].words;
    }
    return words;
}

// Is everything cut off at 1, the lamp too?
static bool is_clamped(const picture *a, const picture *b, const compared *results) {
    double most = 0;
    for (int i = 0; i < WIDTH * HEIGHT * CHANNELS; i++)
        most = fmax(most, fmax((&a->at[0][0][0])[i], (&b->at[0][0][0])[i]));
    const double lamp = results[BOX_BODIES - 1].ratio[0] * 11;
    return most <= 1.0001 && lamp > 0.99;
}

// When no known mistake explains all of it: what the places say.
static const char *guess_by_place(const compared *results, const part *parts) {
    enum { THE_LAMP = BOX_BODIES - 1 };
    int wrong = 0, last = -1;
    double worst_tile = 0, darkest = INFINITY, brightest = 0;
    for (int p = 0; p < PARTS; p++) {
        if (!is_judged(&parts[p])) continue;
        if (p < THE_LAMP) {
            darkest = fmin(darkest, results[p].all);
            brightest = fmax(brightest, results[p].all);
        }
        if (results[p].worst <= most_z) continue;
        if (p < BOX_BODIES) wrong++, last = p;
        if (p >= FIRST_TILE) worst_tile = fmax(worst_tile, results[p].worst);
    }
    if (wrong == 1)
        return text_kept("only %s is wrong: its colour, or a factor in the code for it alone",
                         part_name(last));
    const bool lamp_right = results[THE_LAMP].worst <= most_z;
    if (wrong > 1 && lamp_right && darkest < 0.8 && brightest > 0.9 && brightest < 1.1)
        return "some bodies lose much light: do rays that leave them hit them again at t near "
               "0, is "
               "their normal not a unit vector or turned the wrong way, or their colour wrong?";
    if (wrong > 1 || results[SHADOWS].worst > most_z) return NULL;
    if (results[EDGES].worst > most_z)
        return "only the edges of bodies are wrong: the rays are to be spread evenly over the "
               "whole pixel, x to x + 1 and y to y + 1";
    if (worst_tile < 2 * most_z)
        return "little is wrong, and in squares alone: something small there; or the random "
               "numbers of neighbouring pixels overlap (seed + pixel?): hash them";
    return NULL;
}

// Does the guess take away most of what is wrong, in every part that is? At the edges it cannot
// be told exactly: they count when nothing else is wrong. Noise of a third of the light explains
// everything, and so nothing.
static bool explains(explanation *e, const part *parts, const compared *before,
                     double together) {
    bool inside = false;
    for (int p = 0; p < PARTS; p++)
        inside |= p != EDGES && is_judged(&parts[p]) && before[p].worst > most_z;
    for (int p = 0; p < PARTS; p++) {
        if (!is_judged(&parts[p]) || before[p].worst <= most_z) continue;
        if (p == EDGES && inside) continue;
        const compared after = compare(&parts[p], &e->got, e->light, together);
        for (int c = 0; c < CHANNELS; c++) {
            const double was = fabs(before[p].ratio[c] - 1), is = fabs(after.ratio[c] - 1);
            if (p < BOX_BODIES && after.error[c] > 0.3) return false;
            const bool square = p >= FIRST_TILE; // small: its noise is badly known
            const double noise = (square ? most_z : 4) * after.error[c];
            if (!(is <= fmax(fmin((square ? 0.6 : 0.4) * was, 0.1), noise))) return false;
        }
    }
    return true;
}

static void draw(const picture *a, const picture *b, const measured *m, reference *right) {
    static picture both;
    for (int i = 0; i < WIDTH * HEIGHT * CHANNELS; i++)
        (&both.at[0][0][0])[i] = ((&a->at[0][0][0])[i] + (&b->at[0][0][0])[i]) / 2;
    draw_difference("path", &both, ACROSS, DOWN, &m->mean[0][0], &right->light[ALL_LIGHT][0][0],
                    0.1, 0, 1);
}

static void row_of_picture(text *t) {
    text_row(t, "picture", "%s/path.png: yours, right, difference", program_folder());
}

// ---- the verdict -----------------------------------------------------------------------

static void describe_bad(text *t, const picture *got, int i, reference *right) {
    const int x = i % WIDTH, y = i / WIDTH, block = y / BLOCK * ACROSS + x / BLOCK;
    const double *v = got->at[y][x], *w = right->light[ALL_LIGHT][block];
    text_row(t, "for example", "x %d, y %d", x, y);
    text_row(t, "expected", "about (%.3g, %.3g, %.3g), and noise", w[0], w[1], w[2]);
    text_row(t, "got", "(%.5g, %.5g, %.5g)", v[0], v[1], v[2]);
    row_of_picture(t);
}

static void judge_values(const picture *got, reference *right) {
    static text t;
    const bad_pixels odd = program_bad_pixels(got, false);
    const bad_pixels bad = program_bad_pixels(got, true);
    if (!bad.count) return;
    if (odd.count) {
        describe_bad(&t, got, odd.first, right);
        fail(&t, "path: %d pixel%s not finite (NaN or infinity), the first at x %d, y %d: 0/0?",
             odd.count, odd.count == 1 ? " is" : "s are", odd.first % WIDTH, odd.first / WIDTH);
    }
    describe_bad(&t, got, bad.first, right);
    fail(
        &t,
        "path: %d pixel%s negative, light is not: is dot(d, v) where n·v is meant, or n on the "
        "wrong side?",
        bad.count, bad.count == 1 ? " is" : "s are");
}

static void judge_noise(const picture *a, const picture *b, double together) {
    if (share_of_same(a, b) > 0.5)
        fail(NULL, "path: the pictures with two different seeds are the same: SEED, the "
                   "third argument, must seed the random numbers");
    if (together > 2)
        fail(NULL,
             "path: the noise is the same in neighbouring pixels (it is as large as if of "
             "16 pixels only %.0f had numbers of their own): does every pixel begin with "
             "the same random numbers?",
             fmax(1, BLOCK * BLOCK / together));
}

// The body whose light has the largest relative standard error.
static int noisiest_body(const part *parts, const compared *results) {
    int most = 0;
    for (int p = 1; p < BOX_BODIES; p++)
        if (is_judged(&parts[p]) && results[p].all_error > results[most].all_error) most = p;
    return most;
}

static void judge_samples(int body, double worst) {
    const double times = ceil(worst * worst / (too_noisy * too_noisy));
    if (worst > too_noisy)
        fail(
            NULL,
            "path: too noisy to judge: the standard error of the light of %s is %s %%, at most "
            "%.0f %% is asked for: %s",
            part_name(body), fixed_number(100 * worst), 100 * too_noisy,
            times <= 1000
                ? text_kept("take %.0f times as many samples", times)
                : "more samples alone will hardly do: a few paths bring all the light. Is "
                  "something divided by a density that can be near 0?");
    const double found = most_z * worst;
    if (found > weak)
        program_note(
            "report.txt",
            "path: ok, but weak: errors below %s %% in the light of %s drown in the noise. "
            "Done when this says %.0f %% or less: more samples, or less noise\n",
            fixed_number(100 * found), part_name(body), 100 * goal);
    else
        program_note("report.txt",
                     "path: right within its noise: an error of %s %% in the light of any body "
                     "would have been found%s\n",
                     fixed_number(100 * found), found > goal ? " (the goal: 5 % or less)" : "");
}

static _Noreturn void say_what_is_wrong(const picture *a, const picture *b, reference *right,
                                        const part *parts, const compared *results,
                                        double together, bool far_too_bright) {
    static text t;
    static explanation guessed;
    double worst = 0;
    for (int p = 0; p < PARTS; p++)
        if (is_judged(&parts[p])) worst = fmax(worst, results[p].worst);
    const char *words = where_rays_go(a, b, right);
    if (words || !guess_light(a, b, right, &t, &guessed) ||
        !explains(&guessed, parts, results, together)) {
        t = (text){0};
        if (!words && is_clamped(a, b, results))
            words = "values above 1 are cut off: a PFM keeps them";
        if (!words) words = guess_by_place(results, parts);
        if (!words && far_too_bright)
            words = "far too bright, every reflection adds light: is 1/π missing in the BRDF "
                    "(albedo/π), the cosine, or a factor in the density of the directions?";
        if (words) text_row(&t, "likely", "%s", words);
    }
    describe_parts(&t, parts, results);
    row_of_picture(&t);
    if (far_too_bright && worst < 1000)
        fail(&t, "path: most of the picture is more than 3 times too bright");
    fail(&t, "path: the light is wrong, by %s standard errors (%.0f are noise)",
         worst < 1000 ? text_kept("up to %.0f", worst) : "more than 1000", most_z);
}

static void judge(const picture *a, const picture *b) {
    static part parts[PARTS];
    static compared results[PARTS];
    static measured m;
    reference *right = reference_read();
    measure_blocks(a, b, &m);
    draw(a, b, &m, right);
    judge_values(a, right), judge_values(b, right);
    const double together = noise_together(a, b);
    judge_noise(a, b, together);
    find_parts(right, parts);
    double worst = 0;
    for (int p = 0; p < PARTS; p++) {
        results[p] = compare(&parts[p], &m, right->light[ALL_LIGHT], together);
        if (is_judged(&parts[p])) worst = fmax(worst, results[p].worst);
    }
    const int body = noisiest_body(parts, results);
    const double noise = results[body].all_error;
    const double limit = most_z * (noise > too_noisy ? 2 : 1); // much noise: badly known
    const bool bright = is_far_too_bright(&m, right);
    if (worst > limit || bright)
        say_what_is_wrong(a, b, right, parts, results, together, bright);
    judge_samples(body, noise);
}

void judge_path(void) {
    const char *seed = runner_setting("SEED"); // others, to try
    const long more = seed ? 1000003 * strtol(seed, NULL, 10) : 0;
    const picture *a = program_draw("path", text_kept("%ld", 12345 + more));
    if (!a) return;
    const picture *b = program_draw("path", text_kept("%ld", 987654321 + more));
    if (b) judge(a, b);
}
