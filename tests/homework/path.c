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
        const double sure = reference_error * want;
        r.ratio[c] = got / want;
        r.error[c] = sqrt(variance + sure * sure) / want;
        r.z[c] = (r.ratio[c] - 1) / r.error[c];
        r.worst = fmax(r.worst, fabs(r.z[c]));
        got_sum += got, right_sum += want, variance_sum += sqrt(variance);
    }
    r.all = got_sum / right_sum;
    r.all_error = variance_sum / right_sum; // the colours' noise goes together
    return r;
}

static bool is_judged(const part *p) {
    return p->count >= FEWEST_BLOCKS;
}

// ---- words ---------------------------------------------------------------------------

static const char *amount(double ratio) {
    if (ratio > 2) return text_kept("%.3g times too bright", ratio);
    if (ratio <= 0) return "black";
    if (ratio < 0.5) return text_kept("%.3g times too dark", 1 / ratio);
    return text_kept("%.2g %% too %s", 100 * fabs(ratio - 1), ratio > 1 ? "bright" : "dark");
}

static void describe_part(text *t, int p, const compared *r) {
    const double spread = fmax(r->ratio[0], fmax(r->ratio[1], r->ratio[2])) -
                          fmin(r->ratio[0], fmin(r->ratio[1], r->ratio[2]));
    text words = {0};
    text_add(&words, "%s: %s", part_name(p), amount(r->all));
    if (spread > 0.01 && spread > 5 * r->error[0])
        text_add(&words, ": red %+.2g %%, green %+.2g %%, blue %+.2g %%",
                 100 * (r->ratio[0] - 1), 100 * (r->ratio[1] - 1), 100 * (r->ratio[2] - 1));
    text_row(t, "wrong", "%s (noise: %.1g %%)", words.chars, 100 * r->all_error);
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
    for (int p = FIRST_TILE; p < PARTS && !wrong; p++)
        if (is_judged(&parts[p]) && results[p].worst > most_z) describe_part(t, p, &results[p]);
}

// When no known mistake explains all of it: what the places say.
static void guess_by_place(text *t, const compared *results, const part *parts) {
    int wrong = 0, last = -1;
    for (int p = 0; p < BOX_BODIES; p++)
        if (is_judged(&parts[p]) && results[p].worst > most_z) wrong++, last = p;
    if (wrong == 0 && results[EDGES].worst > most_z)
        text_row(t, "likely", "%s",
                 "the rays are not spread over the whole pixel: x to x + 1, y to y + 1");
    else if (wrong == 1 && last >= 0)
        text_row(t, "likely",
                 "only %s is wrong: its colour, or a factor in the code for it alone",
                 part_name(last));
}

// Does the guess take away most of what is wrong, in every part that is? At the edges it cannot
// be told exactly: they count when nothing else is wrong.
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
            if (is > fmax(fmin(0.4 * was, 0.1), 4 * after.error[c])) return false;
        }
    }
    return true;
}

static void draw(const measured *m, reference *right) {
    draw_difference("path", ACROSS, DOWN, &m->mean[0][0], &right->light[ALL_LIGHT][0][0], 0.1,
                    0, 1);
}

// ---- the verdict -----------------------------------------------------------------------

static void judge_noise(const picture *a, const picture *b, double together) {
    if (share_of_same(a, b) > 0.5)
        fail(NULL, "path: the pictures with two different seeds are the same: SEED, the "
                   "third argument, must seed the random numbers");
    if (together > 2)
        fail(
            NULL,
            "path: the noise is the same in neighbouring pixels (%.1f of 16 go together): does "
            "every pixel begin with the same random numbers?",
            together);
}

// The largest relative standard error of a body's light.
static double noise_of_bodies(const part *parts, const compared *results) {
    double most = 0;
    for (int p = 0; p < BOX_BODIES; p++)
        if (is_judged(&parts[p])) most = fmax(most, results[p].all_error);
    return most;
}

static void judge_samples(double worst) {
    if (worst > too_noisy)
        fail(NULL,
             "path: too noisy to judge: the standard error of a body's light is %.2g %%, at "
             "most %.2g %% is asked for: take %.0f times as many samples",
             100 * worst, 100 * too_noisy, ceil(worst * worst / (too_noisy * too_noisy)));
    program_say(
        "path: right within its noise: an error of %.1f %% in the light of any body would "
        "have been found (more samples find smaller ones)\n",
        100 * most_z * worst);
}

static _Noreturn void say_what_is_wrong(const picture *a, const picture *b, reference *right,
                                        const part *parts, const compared *results,
                                        double together) {
    static text t;
    static explanation guessed;
    double worst = 0;
    for (int p = 0; p < PARTS; p++)
        if (is_judged(&parts[p])) worst = fmax(worst, results[p].worst);
    guess_light(a, b, right, &t, &guessed);
    if (!explains(&guessed, parts, results, together)) {
        t = (text){0};
        guess_by_place(&t, results, parts);
    }
    describe_parts(&t, parts, results);
    text_row(&t, "picture", "%s/path.png: yours, right, difference", program_folder());
    fail(&t, "path: the light is wrong, by up to %.3g standard errors (%.0f are noise)", worst,
         most_z);
}

static void judge(const picture *a, const picture *b) {
    static part parts[PARTS];
    static compared results[PARTS];
    static measured m;
    reference *right = reference_read();
    measure_blocks(a, b, &m);
    draw(&m, right);
    const double together = noise_together(a, b);
    judge_noise(a, b, together);
    find_parts(right, parts);
    double worst = 0;
    for (int p = 0; p < PARTS; p++) {
        results[p] = compare(&parts[p], &m, right->light[ALL_LIGHT], together);
        if (is_judged(&parts[p])) worst = fmax(worst, results[p].worst);
    }
    const double noise = noise_of_bodies(parts, results);
    const double limit = most_z * (noise > too_noisy ? 2 : 1); // much noise: badly known
    if (worst > limit) say_what_is_wrong(a, b, right, parts, results, together);
    judge_samples(noise);
}

void judge_path(void) {
    const char *seed = runner_setting("SEED"); // others, to try
    const long more = seed ? 1000003 * strtol(seed, NULL, 10) : 0;
    const picture *a = program_draw("path", text_kept("%ld", 12345 + more));
    if (!a) return;
    const picture *b = program_draw("path", text_kept("%ld", 987654321 + more));
    if (b) judge(a, b);
}
