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
static double no_shadows(const double *L[], double k, int c) {
    (void)k;
    return L[NO_SHADOWS][c];
}
static double no_cosine(const double *L[], double k, int c) {
    (void)k;
    return L[NO_COSINE][c];
}
static double no_lamp_cosine(const double *L[], double k, int c) {
    (void)k;
    return L[NO_LAMP_COSINE][c];
}
static double falloff(const double *L[], double k, int c) {
    (void)k;
    return L[FALLOFF][c];
}

static double uniform(const double *L[], double k, int c) {
    (void)k;
    return L[UNIFORM][c];
}
static double uniform_all(const double *L[], double k, int c) {
    (void)k;
    return L[UNIFORM_ALL][c];
}

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
    {two_reflections, false, "light reflected three times or more is missing: too few bounces"},
    {three_reflections, false,
     "light reflected four times or more is missing: too few bounces"},
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
    int flip;
    bool swap, clamped;
} trial;

static const double slack = 0.01; // relative: what the guess need not explain
static const double most = 25;    // of a squared error: an outlier counts no more

static int flipped(int block, int flip) {
    const int x = block % ACROSS, y = block / ACROSS;
    return (flip & 2 ? DOWN - 1 - y : y) * ACROSS + (flip & 1 ? ACROSS - 1 - x : x);
}

static double misfit(const trial *t, compose *light, double k) {
    double sum = 0;
    for (int b = 0; b < BLOCKS; b++) {
        const double *L[LAYERS];
        for (int i = 0; i < LAYERS; i++) L[i] = t->right->light[i][b];
        const int from = flipped(b, t->flip);
        for (int c = 0; c < CHANNELS; c++) {
            double want = light(L, k, c);
            if (t->clamped) want = fmin(want, 1);
            const int channel = t->swap ? 2 - c : c;
            const double off = t->got->mean[from][channel] - want;
            const double square = t->got->variance[from][channel] + slack * slack * want * want;
            sum += fmin(off * off / (square + 1e-8), most);
        }
    }
    return sum;
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
enum { VALUES = BLOCKS * CHANNELS };

static int supposed(const trial *t, int rule, int curve) {
    return (t->flip != 0) + t->swap + t->clamped + (curve != 0) + (rule != 0) +
           rules[rule].fitted;
}

static void try_rules(const trial *t, int curve, guess *best) {
    for (int i = 0; i < COUNT(rules); i++) {
        if (rules[i].fitted && (t->flip || t->swap) && curve) continue; // far-fetched
        double least, k = 1;
        if (rules[i].fitted)
            k = best_factor(t, rules[i].light, &least);
        else
            least = misfit(t, rules[i].light, k);
        least += price * supposed(t, i, curve);
        if (least < best->misfit) *best = (guess){least, k, *t, i, curve};
    }
}

static guess best_guess(const picture *a, const picture *b, reference *right) {
    guess best = {.misfit = INFINITY};
    static picture p, q;
    static measured m[COUNT(curves)]; // the best guess points into it
    for (int curve = 0; curve < COUNT(curves); curve++) {
        for (int i = 0; i < WIDTH * HEIGHT * CHANNELS; i++) {
            (&p.at[0][0][0])[i] = curves[curve].undo((&a->at[0][0][0])[i]);
            (&q.at[0][0][0])[i] = curves[curve].undo((&b->at[0][0][0])[i]);
        }
        measure_blocks(&p, &q, &m[curve]);
        for (int i = 0; i < 16; i++) {
            const trial t = {right, &m[curve], i & 3, (i & 4) != 0, (i & 8) != 0};
            try_rules(&t, curve, &best);
        }
    }
    return best;
}

// ---- words ---------------------------------------------------------------------------

static const char *factor_words(double k) {
    static const struct {
        double value;
        const char *name;
    } known[] = {{2, "2"},        {0.5, "1/2"},   {PI, "π"},
                 {1 / PI, "1/π"}, {2 * PI, "2π"}, {1 / (2 * PI), "1/(2π)"},
                 {4, "4"},        {0.25, "1/4"},  {PI / 2, "π/2"},
                 {2 / PI, "2/π"}, {4 * PI, "4π"}, {1 / (4 * PI), "1/(4π)"}};
    for (int i = 0; i < COUNT(known); i++)
        if (fabs(k / known[i].value - 1) < 0.03) return known[i].name;
    return text_kept("%.2g", k);
}

static void add_words(text *t, const char *words) {
    if (*words) text_row(t, "likely", "%s", words);
}

static void add_rule(text *t, const guess *g) {
    const char *words = rules[g->rule].words, *hole = strstr(words, "%s");
    const bool twice = rules[g->rule].light == reflected && fabs(g->k / 2 - 1) < 0.03;
    if (twice)
        add_words(
            t, "the lamp is counted twice: aimed at, and again where a path runs into it; or "
               "a factor 2 in how it is sampled");
    else if (!hole)
        add_words(t, words);
    else
        text_row(t, "likely", "%.*s%s%s", (int)(hole - words), words, factor_words(g->k),
                 hole + 2);
}

// What the guess takes for the light of every block, and for the picture itself.
static void apply(const guess *g, explanation *e) {
    for (int b = 0; b < BLOCKS; b++) {
        const double *L[LAYERS];
        for (int i = 0; i < LAYERS; i++) L[i] = g->trial.right->light[i][b];
        const int from = flipped(b, g->trial.flip);
        for (int c = 0; c < CHANNELS; c++) {
            const double want = rules[g->rule].light(L, g->k, c);
            const int channel = g->trial.swap ? 2 - c : c;
            e->light[b][c] = g->trial.clamped ? fmin(want, 1) : want;
            e->got.mean[b][c] = g->trial.got->mean[from][channel];
            e->got.variance[b][c] = g->trial.got->variance[from][channel];
        }
    }
}

void guess_light(const picture *a, const picture *b, reference *right, text *words,
                 explanation *e) {
    const guess g = best_guess(a, b, right);
    apply(&g, e);
    if (g.trial.flip & 1) add_words(words, "mirrored left to right");
    if (g.trial.flip & 2)
        add_words(words, "upside down: a PFM begins with the lowest row of the picture");
    if (g.trial.swap) add_words(words, "red and blue are swapped");
    add_words(words, curves[g.curve].words);
    if (g.trial.clamped) add_words(words, "values above 1 are cut off: a PFM keeps them");
    add_rule(words, &g);
}
