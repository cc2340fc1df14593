// homework.h: how the homework's ray tracer is judged, as a black box.
//
//     ../homework.c  the stages: build, depth, normal, mirror, path
//     program.c      runs the student's program; compiling is tests/tools/homework.sh's
//     pfm.c          reads a picture strictly, and draws the difference
//     truth.c        scenes 1 and 2 in double, right or with one classic mistake
//     exact.c        judges depth, normal and mirror pixel by pixel
//     box.c          scene 3: what is seen where, the converged reference
//     path.c         judges the path traced picture by its noise
//     guess.c        which mistakes explain it
//     reference.c    makes reference.pfm: make homework-reference
#ifndef TESTS_HOMEWORK_H
#define TESTS_HOMEWORK_H

#include "common/image.h"
#include "common/wide3.h"
#include "tests/check_inside.h"

enum { WIDTH = 128, HEIGHT = 96, CHANNELS = 3 };

typedef struct {
    double at[HEIGHT][WIDTH][CHANNELS]; // from the top left
} picture;

// Ends the test as failed: the first line says what is wrong, `more` may be NULL.
_Noreturn void fail(const text *more, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

// ---- program.c -------------------------------------------------------------------------

enum { BUILT, NOT_BUILT, EMPTY };
// Whether there is a program; in NOT_BUILT and EMPTY `why` gets the reason.
int program_state(text *why);

// Runs `raytracer name file seed` and reads its picture. Fails the test when it does not come to
// that; notes a todo and returns NULL when the program does not know the name. The picture lives
// until two more are drawn.
const picture *program_draw(const char *name, const char *seed);

// How many pixels are not finite, or `negative`, and which is the first from the top, row by row.
typedef struct {
    int count, first;
} bad_pixels;
bad_pixels program_bad_pixels(const picture *p, bool negative);

// A number for people, in two or three digits and never with an exponent. Lives as text_kept's.
const char *fixed_number(double x);

// The folder for pictures; adds a line to a file there: report.txt is shown to the student even if
// all is right, todo.txt has the pictures that are not written yet.
const char *program_folder(void);
void program_note(const char *file, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

// ---- pfm.c -----------------------------------------------------------------------------

// Reads a colour PFM of width x height into `values`, top row first; the reason when it is none,
// else NULL.
const char *pfm_read(const char *path, int width, int height, float *values);

// Yours (the picture), right, and the difference: grey is right, red too much, blue too little;
// `full` is the difference that gives full colour. `means` and `right` have width x height
// values: what is compared. Written enlarged as folder/name.png. `shown` scales the values to be
// seen, after `offset` is added; what is not finite is magenta, and what is negative without an
// offset.
void draw_difference(const char *name, const picture *yours, int width, int height,
                     const double *means, const double *right, double full, double offset,
                     double shown);

// ---- truth.c ---------------------------------------------------------------------------

typedef enum { DEPTH, NORMAL, MIRROR } stage;

// A classic mistake; the first is none.
typedef struct {
    const char *words;
    int stages; // 1 << DEPTH | ...
    int id;
} mistake;
extern const mistake mistakes[];
extern const int mistake_count;

typedef struct {
    double value[CHANNELS];
    uint64_t history; // what the ray met, in order: differs across an edge
    int body;         // that the ray met first, -1: none
} seen;
seen truth_seen(stage s, double x, double y, int mistake_id);
const char *truth_body(stage s, int body);
bool truth_is_mirror(stage s, int body);

// ---- exact.c ---------------------------------------------------------------------------

void judge_exact(stage s, const char *name);

// ---- box.c -----------------------------------------------------------------------------

// The path traced picture is judged by the means of blocks of 4 x 4 pixels.
enum { BLOCK = 4, ACROSS = WIDTH / BLOCK, DOWN = HEIGHT / BLOCK, BLOCKS = ACROSS * DOWN };
typedef double blocks[BLOCKS][CHANNELS];

enum { // the pictures in reference.pfm, from the top
    ALL_LIGHT,
    LIGHT_0, // after exactly 0, 1, ... reflections: the lamp as it is seen
    LIGHT_4 = LIGHT_0 + 4,
    NO_SHADOWS, // the mistakes of tests/homework/wrong/path-*.c
    NO_COSINE,
    NO_LAMP_COSINE,
    FALLOFF,
    UNIFORM,
    UNIFORM_ALL,
    NO_COSINE_ALL,
    COSINE_TWICE,
    COSINE_AGAIN,
    LAST_COLOR,
    LAST_COLOR_UNIFORM,
    BOTH_SIDES,
    LAYERS
};
typedef struct {
    blocks light[LAYERS];
} reference;
reference *reference_read(void);

enum { BOX_BODIES = 8 };
extern const char *const box_body_name[BOX_BODIES];
// The body that fills the block, or -1: an edge runs through it or near it.
int box_body_in(int block);
// Is the lamp seen at this point of the picture; is it within two pixels of this one?
bool box_is_lamp(double x, double y);
bool box_lamp_near(int x, int y);
// The share of the lamp's direct light that is not in shadow there; from light_1.
double box_lit(int block, const double light_1[CHANNELS]);

// ---- path.c ----------------------------------------------------------------------------

typedef struct {
    blocks mean, variance; // of the mean
} measured;

void judge_path(void);
void measure_blocks(const picture *a, const picture *b, measured *m);

// ---- guess.c ---------------------------------------------------------------------------

// What may explain the two pictures: the picture as it would be without the mistake in its
// pixels, and the light that the mistake would give. Adds to `words` what it is; false when
// nothing known comes near, or two that exclude each other come equally near.
typedef struct {
    measured got;
    blocks light;
} explanation;
bool guess_light(const picture *a, const picture *b, reference *right, text *words,
                 explanation *e);

double srgb_decoded(double v);
#define UPSIDE_DOWN                                                                          \
    "upside down: a PFM begins with the lowest row of the picture; or y points down in the " \
    "camera"

#endif
