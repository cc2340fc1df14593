// options.c: the command line, read strictly: a number that was mistyped is an
// error, not another picture.
#include "common/options.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#ifdef _OPENMP
#include <omp.h>
#endif

#include "common/die.h"
#include "common/image.h"

enum { OUT = 1 << 16, SHOW = 1 << 17, HELP = 1 << 18 }; // beside USES_SIZE ...

typedef struct {
    int id;
    const char *name, *value; // value: how --help calls it; NULL: takes none
    const char *meaning;
    uint64_t least, most; // of a number
} option;

static const option table[] = {
    {USES_SIZE, "--size", "WIDTHxHEIGHT", "size of the picture in pixels", 1, 16384},
    {USES_SAMPLES, "--samples", "N", "rays per pixel", 1, 1000000},
    {USES_DEPTH, "--depth", "N", "bounces at most", 0, 1000000},
    {USES_SEED, "--seed", "N", "another seed, other random numbers", 0, UINT64_MAX},
    {USES_THREADS, "--threads", "N", "0: as many as there are cores", 0, 1024},
    {USES_PREVIEW, "--preview", NULL, "draw in the terminal while it renders", 0, 0},
    {SHOW, "--show", "NAME", "which picture", 0, 0},
    {OUT, "--out", "FILE", "the picture, .png or .pfm", 0, 0},
    {HELP, "--help", NULL, "this text", 0, 0},
};

static bool same(const char *a, const char *b) {
    return strcmp(a, b) == 0;
}

static bool has(const program *about, int id) {
    if (id == OUT) return about->defaults.out != NULL;
    if (id == SHOW) return about->shows != NULL;
    return id == HELP || (about->uses & id);
}

// Digits only, so no sign, space or exponent. Returns what follows them, or NULL
// when there is no number from least to most.
static const char *read_number(const char *text, const option *o, uint64_t *number) {
    const char *c = text;
    uint64_t n = 0;
    for (; *c >= '0' && *c <= '9'; c++) {
        const uint64_t digit = (uint64_t)(*c - '0');
        if (n > (o->most - digit) / 10) return NULL; // also keeps n from overflowing
        n = 10 * n + digit;
    }
    if (c == text || n < o->least) return NULL;
    *number = n;
    return c;
}

static uint64_t number_of(const option *o, const char *text) {
    uint64_t n = 0;
    const char *rest = read_number(text, o, &n);
    if (!rest || *rest)
        die(EXIT_USAGE, "%s: expected a whole number, %" PRIu64 " to %" PRIu64 ", got \"%s\"",
            o->name, o->least, o->most, text);
    return n;
}

static void read_size(const option *o, const char *text, options *result) {
    uint64_t width = 0, height = 0;
    const char *rest = read_number(text, o, &width);
    if (rest) rest = *rest == 'x' ? read_number(rest + 1, o, &height) : NULL;
    if (!rest || *rest)
        die(EXIT_USAGE, "%s: expected %s, %" PRIu64 " to %" PRIu64 " each, got \"%s\"", o->name,
            o->value, o->least, o->most, text);
    result->width = (int)width;
    result->height = (int)height;
}

static const char *read_show(const choice *shows, const char *text) {
    char names[1024] = "";
    size_t used = 0;
    for (const choice *c = shows; c->name; c++) {
        if (same(c->name, text)) return c->name;
        if (used < sizeof names)
            used += (size_t)snprintf(names + used, sizeof names - used, "%s%s",
                                     c == shows ? "" : ", ", c->name);
    }
    die(EXIT_USAGE, "--show: expected one of %s, got \"%s\"", names, text);
}

static void print_default(const option *o, const options *d) {
    switch (o->id) {
    case USES_SIZE:
        printf(" (%dx%d)", d->width, d->height);
        break;
    case USES_SAMPLES:
        printf(" (%d)", d->samples);
        break;
    case USES_DEPTH:
        printf(" (%d)", d->depth);
        break;
    case USES_SEED:
        printf(" (%" PRIu64 ")", d->seed);
        break;
    case USES_THREADS:
        printf(" (%d)", d->threads);
        break;
    case SHOW:
        printf(" (%s)", d->show);
        break;
    case OUT:
        printf(" (%s)", d->out);
        break;
    }
}

static void help(const char *path, const program *about, const options *defaults) {
    const bool file = about->uses & USES_FILE;
    printf("%s: %s\n\nusage: %s [options]%s\n", about->name, about->summary, path,
           file ? " [FILE]" : "");
    if (file) printf("  %-22s  %s\n", "FILE", about->file);
    for (int i = 0; i < COUNT(table); i++) {
        const option *o = &table[i];
        if (!has(about, o->id)) continue;
        const char *value = o->value ? o->value : "";
        printf("  %-*s %-*s  %s", 9, o->name, 12, value, o->meaning);
        if (o->most)
            printf(", %" PRIu64 " to %" PRIu64 "%s", o->least, o->most,
                   o->id == USES_SIZE ? " each" : "");
        print_default(o, defaults);
        putchar('\n');
    }
    if (about->shows) puts("\nThe pictures:");
    for (const choice *c = about->shows; c && c->name; c++)
        printf("  %-22s  %s\n", c->name, c->description);
    exit(EXIT_SUCCESS);
}

static void apply(const option *o, const char *text, const program *about, options *result) {
    switch (o->id) {
    case USES_SIZE:
        read_size(o, text, result);
        break;
    case USES_SAMPLES:
        result->samples = (int)number_of(o, text);
        break;
    case USES_DEPTH:
        result->depth = (int)number_of(o, text);
        break;
    case USES_SEED:
        result->seed = number_of(o, text);
        break;
    case USES_THREADS:
        result->threads = (int)number_of(o, text);
        break;
    case USES_PREVIEW:
        result->preview = true;
        break;
    case SHOW:
        result->show = read_show(about->shows, text);
        break;
    case OUT:
        result->out = text;
        break;
    }
}

// The option whose name `argument` has up to its end or to '='.
static const option *find(const char *argument, const program *about) {
    const size_t length = strcspn(argument, "=");
    for (int i = 0; i < COUNT(table); i++) {
        const char *name = table[i].name;
        if (strlen(name) != length || strncmp(name, argument, length) != 0) continue;
        if (has(about, table[i].id)) return &table[i];
    }
    die(EXIT_USAGE, "%s \"%.*s\", try --help",
        argument[0] == '-' ? "unknown option" : "unexpected argument", (int)length, argument);
}

// Is it the program's FILE? What begins with - is none: ./-name is.
static bool takes_file(const char *argument, const program *about, options *result) {
    if (!(about->uses & USES_FILE) || argument[0] == '-' || !argument[0]) return false;
    if (result->file)
        die(EXIT_USAGE, "one file at most: got \"%s\" and \"%s\"", result->file, argument);
    result->file = argument;
    return true;
}

static void set_threads(int threads) {
#ifdef _OPENMP
    if (threads > 0) omp_set_num_threads(threads);
#else
    if (threads > 1) fputs("note: built without OpenMP: this program uses one core\n", stderr);
#endif
}

options options_parse(int argc, char **argv, const program *about) {
    options result = about->defaults;
    if (about->shows && !result.show) result.show = about->shows[0].name;
    const options defaults = result;
    for (int i = 1; i < argc; i++) {
        if (takes_file(argv[i], about, &result)) continue;
        const option *o = find(argv[i], about);
        const char *equals = strchr(argv[i], '=');
        if (!o->value && equals)
            die(EXIT_USAGE, "%s takes no value, got \"%s\"", o->name, argv[i]);
        if (o->id == HELP) help(argv[0], about, &defaults);
        const char *text = equals ? equals + 1 : o->value ? NULL : "";
        if (!text && ++i < argc) text = argv[i];
        if (!text) die(EXIT_USAGE, "%s: a value is missing, try --help", o->name);
        apply(o, text, about, &result);
    }
    if (result.out) image_check_path(result.out);
    set_threads(result.threads);
    return result;
}

bool shows(const options *opt, const char *name) {
    return opt->show && same(opt->show, name);
}
