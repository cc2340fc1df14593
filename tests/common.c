// Tests of common/: random numbers, pictures, the command line, statistics.
#define _XOPEN_SOURCE 700 // POSIX 2008 with SIGXFSZ
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "common/image.h"
#include "common/measure.h"
#include "common/options.h"
#include "common/rng.h"
#include "common/todo.h"
#include "common/wide3.h"
#include "tests/check.h"

// ---- rng -----------------------------------------------------------------------

static void rng_sequence(void) {
    static const uint32_t published[] = {0xa15c02b7, 0x7b47f409, 0xba1d3330,
                                         0x83d2f293, 0xbfa4784b, 0xcbed606e};
    rng g = rng_seed(42, 54);
    given("PCG32 seeded (42, 54), against the published numbers");
    for (int i = 0; i < COUNT(published); i++) CHECK_INT(rng_bits(&g), published[i]);
}

// The largest and the smallest result: all bits set, and none.
static void rng_range(void) {
    rng g = rng_seed(1, 2);
    running s = {0};
    for (int i = 0; i < 2000000; i++) {
        const real u = rng_real(&g);
        CHECK(u >= 0 && u < 1, "rng_real is in [0, 1), never 1");
        running_add(&s, u);
    }
    given("2 million numbers");
    CHECK_REAL(s.mean, 0.5, standard_errors(5, sqrt(1 / 12.0 / 2e6)));
    CHECK_REAL(running_variance(&s), 1 / 12.0, standard_errors(5, sqrt(1 / 180.0 / 2e6)));
}

// The correlation of the first numbers of two streams of samples.
static double correlation(int dx, int dy, int dsample, uint64_t dseed) {
    enum { SIDE = 300 };
    double sum = 0;
    for (int y = 0; y < SIDE; y++)
        for (int x = 0; x < SIDE; x++) {
            rng a = rng_sample(1, x, y, 0), b = rng_sample(1 + dseed, x + dx, y + dy, dsample);
            sum += 12 * (rng_double(&a) - 0.5) * (rng_double(&b) - 0.5);
        }
    return sum / (SIDE * SIDE);
}

static void rng_neighbours(void) {
    const allowance none = standard_errors(5, 1 / 300.0);
    given("the first numbers of 90000 pixels and of their neighbours: correlation 0");
    CHECK_REAL(correlation(1, 0, 0, 0), 0, none);
    CHECK_REAL(correlation(0, 1, 0, 0), 0, none);
    CHECK_REAL(correlation(1, -1, 0, 0), 0, none);
    CHECK_REAL(correlation(0, 0, 1, 0), 0, none);
    CHECK_REAL(correlation(0, 0, 0, 1), 0, none);
}

// Same seed, pixel and sample: the same numbers; all else different.
static void rng_keys(void) {
    rng a = rng_sample(7, 11, 13, 17), b = rng_sample(7, 11, 13, 17),
        c = rng_sample(7, 13, 11, 17);
    const uint32_t first = rng_bits(&a);
    CHECK_INT(rng_bits(&b), first);
    CHECK(rng_bits(&c) != first, "x and y exchanged give another stream");
}

// ---- statistics and higher precision ---------------------------------------------

static void welford(void) {
    running s = {0};
    // 1e9 + 4, 7, 13, 16: the sum of squares cancels, the running variance must not.
    const double x[] = {1e9 + 4, 1e9 + 7, 1e9 + 13, 1e9 + 16};
    for (int i = 0; i < COUNT(x); i++) running_add(&s, x[i]);
    given("1e9 + 4, 7, 13, 16");
    CHECK_REAL(s.mean, 1e9 + 10, exactly());
    CHECK_REAL(running_variance(&s), 30, relative_to(1e-12, "double"));
    CHECK_REAL(running_standard_error(&s), sqrt(7.5), relative_to(1e-12, "double"));
    CHECK_REAL(s.min, 1e9 + 4, exactly());
    CHECK_REAL(s.max, 1e9 + 16, exactly());
    const running none = {0};
    CHECK_REAL(running_variance(&none), 0, exactly());
}

static void quantiles(void) {
    double x[] = {5, 1, NAN, 3, 2};
    given("5, 1, NaN, 3, 2: NaN counts as infinity");
    CHECK_REAL(quantile(x, 5, 0.5), 3, exactly());
    CHECK_REAL(quantile(x, 5, 0), 1, exactly());
    CHECK_REAL(quantile(x, 5, 1), INFINITY, exactly());
}

static void exact_root(void) {
    const exact two = 2, root = exact_sqrt(two);
    const double off = (double)((root * root - two) / two);
    given("the square of exact_sqrt(2), less 2");
    CHECK_AT_MOST(fabs(off), sizeof(exact) > 8 ? 1e-18 : 5e-16, "higher precision than double");
    CHECK_REAL((double)exact_sqrt(-1), 0, exactly());
    CHECK_REAL(relative_error(1 + 4 * REAL_EPSILON, 1), 4, relative_to(1e-6, "exact data"));
    CHECK_REAL(relative_error(NAN, 1), INFINITY, exactly());
}

// ---- vectors ------------------------------------------------------------------------

static void vectors(void) {
    const vec3 a = {1, -2, 3}, b = {4, 0.5f, -6};
    given("a = (1, -2, 3), b = (4, 0.5, -6)");
    CHECK_REAL(dot(a, b), -15, exactly());
    CHECK_VEC3(cross(a, b), ((vec3){10.5f, 18, 8.5f}), exactly());
    CHECK_VEC3(lerp(a, b, 0.25f), ((vec3){1.75f, -1.375f, 0.75f}), exactly());
    CHECK_REAL(length(normalize(b)), 1, roundings(4, "a root, a quotient, products"));
    CHECK_VEC3(narrow(wide_cross(widen(a), widen(b))), cross(a, b), exactly());
}

// ---- pictures -----------------------------------------------------------------------

static const char *folder(void) {
    static char path[] = "/tmp/common-XXXXXX";
    static bool made = false;
    if (!made) CHECK(mkdtemp(path) != NULL, "a folder for pictures in /tmp");
    made = true;
    return path;
}

static char *in_folder(const char *name) {
    static char path[256];
    snprintf(path, sizeof path, "%s/%s", folder(), name);
    return path;
}

static void srgb(void) {
    given("sRGB, IEC 61966-2-1: 0, 0.0031308, 0.2140, 0.5, 1, 2, -1, NaN");
    CHECK_INT(srgb_byte(0), 0);
    CHECK_INT(srgb_byte((real)0.0031308), 10);
    CHECK_INT(srgb_byte((real)0.2140), 127);
    CHECK_INT(srgb_byte((real)0.5), 188);
    CHECK_INT(srgb_byte(1), 255);
    CHECK_INT(srgb_byte(2), 255);
    CHECK_INT(srgb_byte(-1), 0);
    CHECK_INT(srgb_byte((real)NAN), 0);
    CHECK_REAL(srgb_light((real)0.5), 0.21404114048223255,
               roundings(4, "two roundings, magnified"));
    for (int byte = 0; byte <= 255; byte++) {
        given("the byte %d, to light and back", byte);
        CHECK_INT(srgb_byte(srgb_light((real)(byte / 255.0))), byte);
    }
}

static void pfm(void) {
    image img = image_new(2, 2);
    *image_at(&img, 0, 0) = (color){1.5f, -2, 0.25f};
    *image_at(&img, 1, 1) = (color){(real)NAN, 0, 0};
    char *path = in_folder("a.pfm");
    given("a 2 x 2 picture with one NaN, written as PFM");
    const long not_finite = image_write(&img, path);
    image_free(&img);
    CHECK_INT(not_finite, 1);
    unsigned char bytes[128];
    FILE *f = fopen(path, "rb");
    CHECK(f != NULL, "the file is there");
    const size_t size = fread(bytes, 1, sizeof bytes, f);
    fclose(f);
    const char head[] = "PF\n2 2\n-1.0\n";
    CHECK_INT(size, strlen(head) + 4 * 3 * 4);
    CHECK(memcmp(bytes, head, strlen(head)) == 0, "the header");
    float first; // of the top row, which is the last in the file
    memcpy(&first, bytes + strlen(head) + 2 * 3 * 4, 4);
    CHECK_REAL(first, 1.5, exactly());
    remove(path);
    rmdir(folder());
}

// ---- what ends a program ------------------------------------------------------------

typedef struct {
    int status;
    char said[512];
} ending;

// Runs f in a process of its own: how it ended, and what it said on stderr.
static ending end_of(void (*f)(void)) {
    int ends[2];
    ending e = {0};
    CHECK(pipe(ends) == 0, "a pipe");
    fflush(NULL);
    const pid_t child = fork();
    if (child == 0) {
        dup2(ends[1], STDERR_FILENO);
        dup2(ends[1], STDOUT_FILENO);
        close(ends[0]);
        f();
        _exit(99);
    }
    close(ends[1]);
    size_t got = 0;
    for (ssize_t n; (n = read(ends[0], e.said + got, sizeof e.said - 1 - got)) > 0;)
        got += (size_t)n;
    close(ends[0]);
    waitpid(child, &e.status, 0);
    e.status = WIFEXITED(e.status) ? WEXITSTATUS(e.status) : -1;
    return e;
}

static const char *words[4];

static void parse_words(void) {
    static const choice pictures[] = {{"near", "one"}, {"far", "two"}, {0}};
    const program about = {
        .name = "test",
        .summary = "A test.",
        .uses = USES_SIZE | USES_SAMPLES | USES_THREADS,
        .defaults = {.width = 4, .height = 3, .samples = 1, .out = "/dev/null"},
        .shows = pictures};
    char *argv[] = {(char *)"test", (char *)words[0], (char *)words[1], NULL};
    options_parse(words[1] ? 3 : 2, argv, &about);
}

// The same for a program that takes a file.
static options parse_file(int argc, const char *const *argv) {
    const program about = {.name = "test",
                           .summary = "A test.",
                           .uses = USES_SAMPLES | USES_FILE,
                           .defaults = {.samples = 1},
                           .file = "a mesh"};
    char *copy[8];
    for (int i = 0; i < argc; i++) copy[i] = (char *)argv[i];
    return options_parse(argc, copy, &about);
}

static void refuses(const char *option, const char *value, const char *says, int status) {
    words[0] = option, words[1] = value;
    const ending e = end_of(parse_words);
    given("%s %s; said: %s", option, value ? value : "", e.said);
    CHECK_INT(e.status, status);
    CHECK(strncmp(e.said, "error: ", 7) == 0 &&
              strchr(e.said, '\n') == e.said + strlen(e.said) - 1,
          "one line that begins with error:");
    CHECK(strstr(e.said, says) != NULL, "it names what is wrong");
}

static void bad_options(void) {
    static const char *const rows[][3] = {
        {"--size", "640", "--size"},       {"--size", "0x4", "--size"},
        {"--size", "4x16385", "--size"},   {"--size", "4x3x2", "--size"},
        {"--size", "-4x3", "--size"},      {"--samples", "0", "--samples"},
        {"--samples", "1e3", "--samples"}, {"--samples", "99999999999999999999", "--samples"},
        {"--samples", "", "--samples"},    {"--threads", "2048", "--threads"},
        {"--show", "middle", "near, far"}, {"--depth", "4", "--depth"},
        {"--sizes", "4x3", "--sizes"},     {"picture", NULL, "picture"},
        {"--samples", NULL, "--samples"},  {"--out", "picture.jpg", ".png"},
    };
    for (int i = 0; i < COUNT(rows); i++) refuses(rows[i][0], rows[i][1], rows[i][2], 2);
}

static void one_file(void) {
    static const char *const last[] = {"test", "--samples", "7", "a=b.obj"},
                             *const first[] = {"test", "./-x", "--samples=7"},
                             *const none[] = {"test", "--samples", "7"};
    given("--samples 7 a=b.obj;  ./-x --samples=7;  --samples 7");
    const options a = parse_file(4, last), b = parse_file(3, first), c = parse_file(3, none);
    CHECK(a.file == last[3] && a.samples == 7, "the last word is the file, = or not");
    CHECK(b.file == first[1] && b.samples == 7, "the first word is, since it begins with .");
    CHECK(c.file == NULL && c.samples == 7, "7 is --samples' value and no file");
}

static void parse_two_files(void) {
    static const char *const two[] = {"test", "a.obj", "b.obj"};
    parse_file(3, two);
}
static void parse_dash(void) {
    static const char *const dash[] = {"test", "-a.obj"};
    parse_file(2, dash);
}
static void parse_empty(void) {
    static const char *const empty[] = {"test", ""};
    parse_file(2, empty);
}
static void parse_file_help(void) {
    static const char *const help[] = {"test", "--help"};
    parse_file(2, help);
}

static void bad_files(void) {
    static const struct {
        void (*parse)(void);
        const char *says;
        int status;
    } rows[] = {{parse_two_files, "\"a.obj\" and \"b.obj\"", 2},
                {parse_dash, "unknown option \"-a.obj\"", 2},
                {parse_empty, "unexpected argument \"\"", 2},
                {parse_file_help, "[FILE]\n  FILE                    a mesh", 0}};
    for (int i = 0; i < COUNT(rows); i++) {
        const ending e = end_of(rows[i].parse);
        given("a program that takes a file said: %s", e.said);
        CHECK_INT(e.status, rows[i].status);
        CHECK(strstr(e.said, rows[i].says) != NULL, "it says so");
    }
}

static void bad_paths(void) {
    refuses("--out", "/nowhere/at/all/x.png", "/nowhere/at/all", 1);
    refuses("--out", "/tmp", "/tmp", 1);
}

static void help(void) {
    words[0] = "--help", words[1] = NULL;
    const ending e = end_of(parse_words);
    given("--help said: %s", e.said);
    CHECK_INT(e.status, 0);
    CHECK(strstr(e.said, "--samples") && strstr(e.said, "far") && !strstr(e.said, "--depth"),
          "the options that there are, and the pictures");
}

// A full disk, as far as one process can have one: no file may grow beyond 8 bytes.
static void write_on_full_disk(void) {
    const struct rlimit tiny = {8, 8};
    signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &tiny);
    const image img = image_new(20, 20);
    image_write(&img, in_folder("old.png"));
}

static void old_picture_stays(void) {
    image img = image_new(3, 3);
    image_write(&img, in_folder("old.png"));
    image_free(&img);
    struct stat before, after;
    CHECK(stat(in_folder("old.png"), &before) == 0, "the first picture is written");
    const ending e = end_of(write_on_full_disk);
    given("a second picture in its place, on a full disk; said: %s", e.said);
    CHECK_INT(e.status, 1);
    CHECK(strstr(e.said, "old.png") != NULL, "it names the file");
    CHECK(stat(in_folder("old.png"), &after) == 0 && after.st_size == before.st_size &&
              after.st_ino == before.st_ino,
          "the old one is whole");
    remove(in_folder("old.png"));
    CHECK(rmdir(folder()) == 0, "nothing half-written is left behind");
}

int main(void) {
    static const test tests[] = {
        {"rng: the published sequence", rng_sequence, "Seeding or output function."},
        {"rng: range, mean, variance", rng_range, "24 bits for float: more round to 1."},
        {"rng: neighbours are uncorrelated", rng_neighbours, "Seed and pixel must be hashed."},
        {"rng: keyed by pixel and sample", rng_keys, NULL},
        {"running: no cancellation", welford, NULL},
        {"quantile: nearest rank", quantiles, NULL},
        {"exact: more than double", exact_root, NULL},
        {"vec3: by hand", vectors, NULL},
        {"image: sRGB", srgb, NULL},
        {"image: PFM", pfm, NULL},
        {"image: a failure leaves the old picture", old_picture_stays, NULL},
        {"options: bad values give one line and exit 2", bad_options, NULL},
        {"options: bad paths give one line and exit 1", bad_paths, NULL},
        {"options: one file", one_file, NULL},
        {"options: two files, -file, an empty one, and help", bad_files, NULL},
        {"options: help", help, NULL},
    };
    return run_tests("common", tests, COUNT(tests));
}
