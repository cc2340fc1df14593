// guess.c: which classic mistakes explain a picture of the box: flips, colours, curves, and the
// light of the reference put together wrongly. Every combination is tried.
#include "tests/homework/homework.h"

#include <string.h>

double srgb_decoded(double v) {
    if (v < 0) return v;
    return v <= 0.04045 ? v / 12.92 : pow((v + 0.055) / 1.055, 2.4);
}

static double same(double v) {
    return v;
}
static double undo_twice(double v) {
    return srgb_decoded(srgb_decoded(v));
}
static double undo_power(double v) {
    return pow(v, 2.2);
}
static double undo_power_twice(double v) {
    return pow(v, 2.2 * 2.2);
}
static double undo_square(double v) {
    return pow(v, 1 / 2.2);
}
static double undo_tone(double v) {
    return v < 0.999 ? v / (1 - v) : 999;
}

static const struct {
    double (*undo)(double v);
    const char *words;
} curves[] = {
    {same, ""},
    {srgb_decoded, "the sRGB curve (gamma) was applied: a PFM holds linear light"},
    {undo_power, "gamma 2.2 was applied: a PFM holds linear light"},
    {undo_twice, "gamma was applied, and twice: a PFM holds linear light"},
    {undo_power_twice, "gamma was applied, and twice: a PFM holds linear light"},
    {undo_square, "the inverse of gamma was applied: a PFM holds linear light"},
    {undo_tone, "a tone curve L / (1 + L) was applied: a PFM holds linear light"},
};

// ---- what the light may have been made of ------------------------------------------------

// LIGHT_0 + k LIGHT_1 + k² LIGHT_2 + ...; what is left after LIGHT_4 falls like a geometric row.
static double by_reflection(const double *L[], double k, int c) {
    const double *l[LIGHT_4 + 1];
    for (int n = 0; n <= 4; n++) l[n] = L[LIGHT_0 + n];
    double sum = l[0][c], power = 1, known = l[0][c];
    for (int n = 1; n <= 4; n++) {
        power *= k;
        sum += power * l[n][c], known += l[n][c];
    }
    const double rest = fmax(L[ALL_LIGHT][c] - known, 0);
    if (rest == 0) return sum;
    const double fall = fmin(rest / (rest + l[4][c]), 0.9);
    return sum + power * k * rest * (1 - fall) / (1 - fmin(k * fall, 0.97));
}

static double upto(const double *L[], int n, int c) {
    double sum = 0;
    for (int i = 0; i <= n; i++) sum += L[LIGHT_0 + i][c];
    return sum;
}

// Up to k reflections, with k > 4 by the same row.
static double few(const double *L[], double k, int c) {
    const double known = upto(L, 4, c), rest = fmax(L[ALL_LIGHT][c] - known, 0);
    if (rest == 0 || k <= 4) return known;
    const double fall = fmin(rest / (rest + L[LIGHT_4][c]), 0.9);
    return known + rest * (1 - pow(fall, k - 4));
}

// Each gives the light of a block's colour c; k is fitted, or unused.
typedef double compose(const double *L[], double k, int c);
static double all(const double *L[], double k, int c) {
    return k * L[ALL_LIGHT][c];
}
static double reflected(const double *L[], double k, int c) {
    return L[LIGHT_0][c] + k * (L[ALL_LIGHT][c] - L[LIGHT_0][c]);
}
static double no_lamp(const double *L[], double k, int c) {
    (void)k;
    return L[ALL_LIGHT][c] - L[LIGHT_0][c];
}
static double lamp_alone(const double *L[], double k, int c) {
    (void)k;
    return L[LIGHT_0][c];
}
static double one_reflection(const double *L[], double k, int c) {
    (void)k;
    return upto(L, 1, c);
}
static double two_reflections(const double *L[], double k, int c) {
    (void)k;
    return upto(L, 2, c);
}
static double three_reflections(const double *L[], double k, int c) {
    (void)k;
    return upto(L, 3, c);
}

static double four_reflections(const double *L[], double k, int c) {
    (void)k;
    return upto(L, 4, c);
}
#define LAYER(name, layer)                                   \
    static double name(const double *L[], double k, int c) { \
        (void)k;                                             \
        return L[layer][c];                                  \
    }
LAYER(no_shadows, NO_SHADOWS)
LAYER(no_cosine, NO_COSINE)
LAYER(no_lamp_cosine, NO_LAMP_COSINE)
LAYER(falloff, FALLOFF)
LAYER(uniform, UNIFORM)
LAYER(uniform_all, UNIFORM_ALL)
LAYER(no_cosine_all, NO_COSINE_ALL)
LAYER(cosine_twice, COSINE_TWICE)
LAYER(cosine_again, COSINE_AGAIN)
LAYER(last_color, LAST_COLOR)
LAYER(last_color_uniform, LAST_COLOR_UNIFORM)
LAYER(both_sides, BOTH_SIDES)

#define TOO_FEW "too few bounces, or roulette that does not divide by its q"
#define COSINE_AND_COSINE                                                                     \
    "the directions are chosen by the cosine, and weighted by it again: sampler and density " \
    "belong together"
#define REPLACED "the albedos of a path are not multiplied: each replaces what was before it"
static const struct {
    compose *light;
    bool fitted;
    const char *words; // a fitted one has %s for k
} rules[] = {
    {all, false, ""},
    {no_lamp, false,
     "the lamp itself is not seen: its emission is missing where the camera's "
     "ray meets it"},
    {lamp_alone, false, "nothing but the lamp is lit: no light is reflected"},
    {one_reflection, false, "direct light alone: light reflected twice or more is missing"},
    {two_reflections, false, "light reflected three times or more is missing: " TOO_FEW},
    {three_reflections, false, "light reflected four times or more is missing: " TOO_FEW},
    {four_reflections, false, "light reflected five times or more is missing: " TOO_FEW},
    {few, true, "light reflected more than about %s times is missing: " TOO_FEW},
    {no_shadows, false, "no shadows: nothing is asked to stand between surface and lamp"},
    {no_cosine, false, "the cosine at the surface, n·v, is missing"},
    {no_lamp_cosine, false, "the cosine at the lamp is missing where it is aimed at"},
    {falloff, false, "the lamp's light falls with the distance, not with its square"},
    {uniform, false,
     "the directions are uniform, but weighted as if chosen by the cosine: sampler and density "
     "belong together"},
    {uniform_all, false,
     "the directions are uniform, but weighted as if chosen by the cosine: sampler and density "
     "belong together"},
    {no_cosine_all, false, "the cosine at the surface, n·v, is missing at every reflection"},
    {cosine_twice, false, COSINE_AND_COSINE},
    {cosine_again, false, COSINE_AND_COSINE},
    {last_color, false, REPLACED},
    {last_color_uniform, false, REPLACED},
    {both_sides, false, "the lamp's upper side shines: it is black"},
    {all, true, "all light is multiplied by %s"},
    {by_reflection, true,
     "every reflection is multiplied by %s: BRDF albedo/π, and divide by the density of the "
     "direction"},
    {reflected, true, "all reflected light is multiplied by %s, once: how the lamp is sampled"},
};

// ---- how well does it fit? --------------------------------------------------------------

typedef struct {
    reference *right;
    const measured *got;
    blocks *variance; // smoothed
    int flip;
    bool swap, clamped;
} trial;

static const double slack = 0.01; // relative: what the guess need not explain
static const double most = 25;    // of a squared error: an outlier counts no more

static int flipped(int block, int flip) {
    const int x = block % ACROSS, y = block / ACROSS;
    return (flip & 2 ? DOWN - 1 - y : y) * ACROSS + (flip & 1 ? ACROSS - 1 - x : x);
}

// A block without a lucky path would seem surer than it is: the mean of its neighbours' variances.
static void smooth(blocks from, blocks to) {
    for (int i = 0; i < BLOCKS * CHANNELS; i++) {
        const int c = i % CHANNELS, x = i / CHANNELS % ACROSS, y = i / CHANNELS / ACROSS;
        double sum = 0;
        int count = 0;
        for (int v = y - 2; v <= y + 2; v++)
            for (int u = x - 2; u <= x + 2; u++) {
                if (u < 0 || v < 0 || u >= ACROSS || v >= DOWN) continue;
                sum += from[v * ACROSS + u][c], count++;
            }
        to[i / CHANNELS][c] = sum / count;
    }
}

// The light of a block's three colours.
static void wanted(const trial *t, compose *light, double k, int block, double want[CHANNELS]) {
    const double *L[LAYERS];
    for (int i = 0; i < LAYERS; i++) L[i] = t->right->light[i][block];
    for (int c = 0; c < CHANNELS; c++) {
        want[c] = light(L, k, c);
        if (t->clamped) want[c] = fmin(want[c], 1);
    }
}

static double misfit(const trial *t, compose *light, double k) {
    double sum = 0;
    for (int b = 0; b < BLOCKS; b++) {
        const int from = flipped(b, t->flip);
        double want[CHANNELS];
        wanted(t, light, k, b, want);
        for (int c = 0; c < CHANNELS; c++) {
            const int channel = t->swap ? 2 - c : c;
            const double off = t->got->mean[from][channel] - want[c], size = slack * want[c];
            const double square = (*t->variance)[from][channel] + size * size;
            sum += fmin(off * off / (square + 1e-8), most);
        }
    }
    return sum;
}

// The lamp has no noise: what is supposed must agree with it. So a right lamp rules out gamma.
static bool lamp_fits(const trial *t, compose *light, double k) {
    double got = 0, all_wanted = 0, variance = 0;
    for (int b = 0; b < BLOCKS; b++) {
        if (t->right->light[LIGHT_0][b][0] < 10.9) continue; // not the lamp alone
        const int from = flipped(b, t->flip);
        double want[CHANNELS];
        wanted(t, light, k, b, want);
        for (int c = 0; c < CHANNELS; c++) {
            got += t->got->mean[from][t->swap ? 2 - c : c];
            variance += t->got->variance[from][t->swap ? 2 - c : c];
            all_wanted += want[c];
        }
    }
    return fabs(got - all_wanted) <= 0.05 * all_wanted + 5 * sqrt(variance) + 0.01;
}

// Is there nothing but the lamp?
static bool is_dark(const trial *t) {
    double got = 0, want = 0;
    for (int b = 0; b < BLOCKS; b++) {
        if (t->right->light[LIGHT_0][b][0] > 0) continue;
        for (int c = 0; c < CHANNELS; c++) {
            got += t->got->mean[flipped(b, t->flip)][c];
            want += t->right->light[ALL_LIGHT][b][c];
        }
    }
    return got < 0.01 * want;
}

// The k with the least misfit: by a row of guesses, then by ever smaller steps.
static double best_factor(const trial *t, compose *light, double *least) {
    double k = 1;
    *least = INFINITY;
    for (double guess = 0.05; guess < 25; guess *= 1.12) {
        const double now = misfit(t, light, guess);
        if (now < *least) *least = now, k = guess;
    }
    for (double step = 1.06; step > 1.0005; step = sqrt(step))
        for (int side = 0; side < 2; side++) {
            const double guess = side ? k * step : k / step, now = misfit(t, light, guess);
            if (now < *least) *least = now, k = guess;
        }
    return k;
}

typedef struct {
    double misfit, k;
    trial trial;
    int rule, curve;
} guess;

static const double price = 20; // of each thing that a guess supposes
static const double doubt = 30; // two guesses as near as this in misfit cannot be told apart
enum { VALUES = BLOCKS * CHANNELS };

static int supposed(const trial *t, int rule, int curve) {
    return (t->flip != 0) + t->swap + t->clamped + (curve != 0) + (rule != 0) +
           rules[rule].fitted;
}

static void try_rules(const trial *t, int curve, guess *best) {
    for (int i = 0; i < COUNT(rules); i++) {
        if (rules[i].fitted && (t->flip || t->swap) && curve) continue; // far-fetched
        double least, k = 1;
        const bool scales_lamp = rules[i].fitted && rules[i].light == all;
        if (!scales_lamp && !lamp_fits(t, rules[i].light, k)) continue;
        if (rules[i].fitted)
            k = best_factor(t, rules[i].light, &least);
        else
            least = misfit(t, rules[i].light, k);
        least += price * supposed(t, i, curve);
        if (rules[i].light == few && k < 4.5) continue; // four_reflections
        if (rules[i].light == lamp_alone && !is_dark(t)) continue;
        if (least < best[i].misfit && lamp_fits(t, rules[i].light, k))
            best[i] = (guess){least, k, *t, i, curve};
    }
}

// The best guess of every rule.
static void best_guesses(const picture *a, const picture *b, reference *right, guess *best) {
    for (int i = 0; i < COUNT(rules); i++) best[i] = (guess){.misfit = INFINITY};
    static picture p, q;
    static measured m[COUNT(curves)]; // the guesses point into it
    static blocks variance[COUNT(curves)];
    for (int curve = 0; curve < COUNT(curves); curve++) {
        for (int i = 0; i < WIDTH * HEIGHT * CHANNELS; i++) {
            (&p.at[0][0][0])[i] = curves[curve].undo((&a->at[0][0][0])[i]);
            (&q.at[0][0][0])[i] = curves[curve].undo((&b->at[0][0][0])[i]);
        }
        measure_blocks(&p, &q, &m[curve]);
        smooth(m[curve].variance, variance[curve]);
        for (int i = 0; i < 16; i++) {
            const trial t = {right, &m[curve],    &variance[curve],
                             i & 3, (i & 4) != 0, (i & 8) != 0};
            try_rules(&t, curve, best);
        }
    }
}

// ---- words ---------------------------------------------------------------------------

static const char *factor_words(double k) {
    const double area = 0.64; // of the lamp: 1/0.64 is nearly π/2
    static const struct {
        double value;
        const char *name;
    } known[] = {
        {2, "2"},        {0.5, "1/2"},   {PI, "π"},
        {1 / PI, "1/π"}, {2 * PI, "2π"}, {1 / (2 * PI), "1/(2π)"},
        {4, "4"},        {0.25, "1/4"},  {PI / 2, "1.57 (π/2, or 1/0.64: the lamp's area)"},
        {2 / PI, "2/π"}, {4 * PI, "4π"}, {1 / (4 * PI), "1/(4π)"}};
    for (int i = 0; i < COUNT(known); i++)
        if (fabs(k / known[i].value - 1) < 0.03) return known[i].name;
    if (fabs(k / area - 1) < 0.01) return "0.64, the lamp's area";
    return text_kept("%.2g", k);
}

static void add_words(text *t, const char *words) {
    if (*words) text_row(t, "likely", "%s", words);
}

static void add_rule(text *t, const char *label, const guess *g) {
    const char *words = rules[g->rule].words, *hole = strstr(words, "%s");
    const bool twice = rules[g->rule].light == reflected && fabs(g->k / 2 - 1) < 0.03;
    const char *k = rules[g->rule].light == few ? text_kept("%.0f", g->k) : factor_words(g->k);
    if (twice)
        text_row(t, label, "%s",
                 "the lamp is counted twice: aimed at, and again where a path runs into it; or "
                 "a factor 2 in how it is sampled");
    else if (!hole && *words)
        text_row(t, label, "%s", words);
    else if (hole)
        text_row(t, label, "%.*s%s%s", (int)(hole - words), words, k, hole + 2);
}

// What the guess takes for the light of every block, and for the picture itself.
static void apply(const guess *g, explanation *e) {
    for (int b = 0; b < BLOCKS; b++) {
        const int from = flipped(b, g->trial.flip);
        wanted(&g->trial, rules[g->rule].light, g->k, b, e->light[b]);
        for (int c = 0; c < CHANNELS; c++) {
            const int channel = g->trial.swap ? 2 - c : c;
            e->got.mean[b][c] = g->trial.got->mean[from][channel];
            e->got.variance[b][c] = g->trial.got->variance[from][channel];
        }
    }
}

// Do the two rules say different things? Too few bounces are too few, however many.
static bool excludes(int i, int j) {
    const bool few_i = strstr(rules[i].words, TOO_FEW), few_j = strstr(rules[j].words, TOO_FEW);
    return strcmp(rules[i].words, rules[j].words) != 0 && !(few_i && few_j);
}

static bool same_change(const guess *a, const guess *b) {
    return a->trial.flip == b->trial.flip && a->trial.swap == b->trial.swap &&
           a->trial.clamped == b->trial.clamped && a->curve == b->curve;
}

bool guess_light(const picture *a, const picture *b, reference *right, text *words,
                 explanation *e) {
    static guess best[COUNT(rules)];
    best_guesses(a, b, right, best);
    const guess *g = &best[0], *second = NULL;
    for (int i = 0; i < COUNT(rules); i++)
        if (best[i].misfit < g->misfit) g = &best[i];
    if (isinf(g->misfit)) return false;
    for (int i = 0; i < COUNT(rules); i++) {
        if (!excludes(i, g->rule)) continue;
        if (best[i].misfit < (second ? second->misfit : g->misfit + doubt)) second = &best[i];
    }
    if (second && !same_change(g, second)) return false;
    apply(g, e);
    if (g->trial.flip & 1) add_words(words, "mirrored left to right");
    if (g->trial.flip & 2) add_words(words, UPSIDE_DOWN);
    if (g->trial.swap) add_words(words, "red and blue are swapped");
    add_words(words, curves[g->curve].words);
    if (g->trial.clamped) add_words(words, "values above 1 are cut off: a PFM keeps them");
    if (second && (!*rules[second->rule].words || !*rules[g->rule].words)) return true;
    add_rule(words, "likely", g);
    if (second) add_rule(words, "or", second);
    return true;
}
