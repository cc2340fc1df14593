// options.h: the command line, the same names in every chapter.
#ifndef COMMON_OPTIONS_H
#define COMMON_OPTIONS_H

#include "common/real.h"

enum { // which options a program has; --out and --help always
    USES_SIZE = 1,
    USES_SAMPLES = 2,
    USES_DEPTH = 4,
    USES_SEED = 8,
    USES_PREVIEW = 16,
    USES_THREADS = 32,
    USES_FILE = 64, // one argument that is no option
};

typedef struct {
    int width, height; // --size 640x480    1 to 16384 each
    int samples;       // --samples 64      rays per pixel, 1 to 1000000
    int depth;         // --depth 8         bounces at most, 0 to 1000000
    uint64_t seed;     // --seed 1
    int threads;       // --threads N       1 to 1024; 0: as many as there are cores
    bool preview;      // --preview         draw in the terminal while it renders
    const char *out;   // --out x.png|x.pfm
    const char *show;  // --show NAME       which of the program's pictures
    const char *file;  // FILE              not checked; NULL: not given
} options;

typedef struct {
    const char *name, *description; // the last row of a list is {0}
} choice;

typedef struct {
    const char *name;    // "04-sphere"
    const char *summary; // one sentence for --help
    int uses;            // USES_SIZE | ...
    options defaults;    // .out: the file's name when --out is missing
    const choice *shows; // the pictures for --show, the first is the default; or NULL
    const char *file;    // USES_FILE: what FILE is, for --help
} program;

// Reads the command line. --help prints and exits 0; anything unknown, missing
// or out of range, and a second FILE, gives one line on stderr and exits with EXIT_USAGE.
// The output path is checked too (image_check_path). Sets the number of threads.
options options_parse(int argc, char **argv, const program *about);

// Is `name` the picture that was asked for?
bool shows(const options *opt, const char *name);

#endif
