// progress.h: how far long work is, on stderr.
// On a terminal one line, rewritten: percent, rays per second, time left; and
// with preview the picture in half blocks. Elsewhere one summary line at the end.
#ifndef COMMON_PROGRESS_H
#define COMMON_PROGRESS_H

#include <stdatomic.h>

#include "common/image.h"

typedef struct {
    const char *what;     // "04-sphere"
    const image *preview; // drawn while it renders, or NULL
    const char *unit;     // of the work: "rays" unless set
    long total;           // so many of them
    atomic_long done;
    double start, shown; // seconds
    bool terminal;
    atomic_bool drawing;     // one thread draws, the others go on
    int columns, lines;      // of the preview, in cells; two cells are one character
    _Atomic uint32_t *cells; // 0xRRGGBB: copies, so that no thread reads a pixel being written
    bool drawn;              // the cursor must climb back over the preview
} progress;

// `unit` of work is a camera ray. preview may be NULL.
progress progress_start(const char *what, long total, const image *preview);

// Adds finished rays; prints at most ten times a second. Call from any thread.
void progress_add(progress *p, long rays);

// The same, and row y of the preview has new pixels. Call it from the thread
// that wrote the row, as often as the row changes.
void progress_row(progress *p, int y, long rays);

// The last line: rays, seconds, rays per second. When all threads have finished.
void progress_end(progress *p);

#endif
