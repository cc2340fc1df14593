// progress.c: the progress line and the preview.
// No locks and no data race: threads count in an atomic, and the thread that
// wrote a row copies what the preview needs of it into atomic cells. Whoever
// finds the drawing free and due draws from the cells; nobody waits.
#define _POSIX_C_SOURCE 200809L
#include "common/progress.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "common/measure.h"

static const double line_seconds = 0.1, preview_seconds = 0.2; // between two drawings
enum { MAX_COLUMNS = 240, MAX_LINE = 160 };

static bool is_terminal(void) {
    const char *term = getenv("TERM");
    return isatty(STDERR_FILENO) && term && strcmp(term, "dumb") != 0;
}

static void terminal_size(int *columns, int *lines) {
    *columns = 80, *lines = 24;
#ifdef TIOCGWINSZ
    struct winsize size;
    if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0) return;
    if (size.ws_col > 0) *columns = size.ws_col;
    if (size.ws_row > 0) *lines = size.ws_row;
#endif
}

// As large as fits: a cell is square, half a character; two lines stay for the text.
static void make_cells(progress *p) {
    int columns, lines;
    terminal_size(&columns, &lines);
    const int w = p->preview->width, h = p->preview->height;
    const double across = (double)(columns < MAX_COLUMNS ? columns : MAX_COLUMNS) / w;
    const double down = 2.0 * (lines > 3 ? lines - 2 : 1) / h;
    const double fit = fmin(1.0, fmin(across, down));
    p->columns = (int)fmax(1.0, floor(w * fit));
    p->lines = (int)fmax(1.0, floor(h * fit));
    p->cells = calloc((size_t)p->columns * (size_t)p->lines, sizeof *p->cells);
}

progress progress_start(const char *what, long total, const image *preview) {
    const double now = clock_seconds();
    progress p = {.what = what, .unit = "rays", .total = total, .start = now, .shown = now};
    p.terminal = is_terminal();
    p.preview = p.terminal ? preview : NULL;
    if (p.preview) make_cells(&p);
    if (!p.cells) p.preview = NULL; // no memory: the work matters more
    return p;
}

// The colour of a cell: the mean of the row's pixels that it covers.
static uint32_t cell_color(const color *row, int from, int to) {
    color sum = {0, 0, 0};
    for (int x = from; x < to; x++) {
        if (!is_finite(row[x])) return 0xff00ff; // as in the file
        sum = add(sum, row[x]);
    }
    const color c = scale((real)1 / (real)(to - from), sum);
    return (uint32_t)(srgb_byte(c.x) << 16 | srgb_byte(c.y) << 8 | srgb_byte(c.z));
}

// Of the rows that a line of cells covers only the first is shown.
static void copy_row(progress *p, int y) {
    const long w = p->preview->width, h = p->preview->height;
    const long line = (long)y * p->lines / h;
    if (y > 0 && (long)(y - 1) * p->lines / h == line) return;
    for (long i = 0; i < p->columns; i++) {
        const int from = (int)(i * w / p->columns), to = (int)((i + 1) * w / p->columns);
        const uint32_t c = cell_color(image_at(p->preview, 0, y), from, to);
        atomic_store_explicit(&p->cells[line * p->columns + i], c, memory_order_relaxed);
    }
}

static int cube_level(int byte) { // the 256 colours have a cube of 0, 95, 135, 175, 215, 255
    return byte < 48 ? 0 : byte < 115 ? 1 : (byte - 35) / 40;
}

// SGR 38 sets the upper half (the block's colour), 48 the lower (its background).
static void put_color(FILE *out, int ground, uint32_t c, bool truecolor) {
    const int r = c >> 16 & 255, g = c >> 8 & 255, b = c & 255;
    const int cube = 16 + 36 * cube_level(r) + 6 * cube_level(g) + cube_level(b);
    if (truecolor) fprintf(out, "\033[%d;2;%d;%d;%dm", ground, r, g, b);
    if (!truecolor) fprintf(out, "\033[%d;5;%dm", ground, cube);
}

static uint32_t cell_at(const progress *p, int column, int line) {
    if (line >= p->lines) return 0; // below an odd last line
    return atomic_load_explicit(&p->cells[line * p->columns + column], memory_order_relaxed);
}

static void put_preview(const progress *p, FILE *out) {
    const char *colors = getenv("COLORTERM");
    const bool truecolor = colors && (strstr(colors, "truecolor") || strstr(colors, "24bit"));
    if (p->drawn) fprintf(out, "\033[%dA", (p->lines + 1) / 2);
    for (int line = 0; line < p->lines; line += 2) {
        for (int column = 0; column < p->columns; column++) {
            put_color(out, 38, cell_at(p, column, line), truecolor);
            put_color(out, 48, cell_at(p, column, line + 1), truecolor);
            fputs("\u2580", out); // upper half block
        }
        fputs("\033[0m\033[K\n", out);
    }
}

// 2.6 M, 26 M, 260 k: the prefix is read faster than the digits.
static void print_scaled(char *text, size_t size, double x) {
    static const char *const prefixes[] = {"", " k", " M", " G"};
    int i = 0;
    for (; x >= 999.5 && i < COUNT(prefixes) - 1; i++) x /= 1000;
    snprintf(text, size, x < 9.95 && i > 0 ? "%.1f%s" : "%.0f%s", x, prefixes[i]);
}

static void print_time(char *text, size_t size, double seconds) {
    const long s = (long)ceil(fmin(seconds, 1e9));
    if (s < 100)
        snprintf(text, size, "%ld s", s);
    else if (s < 6000)
        snprintf(text, size, "%ld min %02ld s", s / 60, s % 60);
    else
        snprintf(text, size, "%ld h %02ld min", s / 3600, s / 60 % 60);
}

static double rays_per_second(long done, double seconds) {
    return (double)done / fmax(seconds, 1e-9);
}

static void describe(const progress *p, char *text, size_t size) {
    const long done = atomic_load(&p->done);
    const double seconds = clock_seconds() - p->start;
    const double speed = rays_per_second(done, seconds);
    const double share = p->total > 0 ? (double)done / (double)p->total : 1;
    char rate[32], left[32] = "?";
    print_scaled(rate, sizeof rate, speed);
    if (done > 0) print_time(left, sizeof left, (double)(p->total - done) / speed);
    snprintf(text, size, "%s: %3.0f %%, %s %s/s, %s left", p->what, floor(100 * share), rate,
             p->unit, left);
}

// In one piece, so that nothing flickers. The cursor stays at the line's start:
// a message from elsewhere overwrites the line instead of hanging on to it.
static void draw(progress *p, const char *text, const char *end) {
    char *bytes = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&bytes, &size);
    if (!out) return;
    if (p->preview) put_preview(p, out);
    fprintf(out, "%s\033[K%s", text, end);
    if (fclose(out) == 0) fwrite(bytes, 1, size, stderr);
    free(bytes);
    p->drawn = true;
}

void progress_add(progress *p, long rays) {
    atomic_fetch_add_explicit(&p->done, rays, memory_order_relaxed);
    if (!p->terminal || atomic_exchange(&p->drawing, true)) return;
    const double now = clock_seconds();
    if (now - p->shown >= (p->preview ? preview_seconds : line_seconds)) {
        char text[MAX_LINE]; // cut to the terminal: a wrapped line cannot be rewritten
        int columns, lines;
        terminal_size(&columns, &lines);
        describe(p, text, (size_t)(columns < MAX_LINE ? columns : MAX_LINE));
        draw(p, text, "\r");
        p->shown = now;
    }
    atomic_store(&p->drawing, false);
}

void progress_row(progress *p, int y, long rays) {
    if (p->preview) copy_row(p, y);
    progress_add(p, rays);
}

void progress_end(progress *p) {
    const double seconds = clock_seconds() - p->start;
    const long done = atomic_load(&p->done);
    char text[MAX_LINE], rate[32];
    print_scaled(rate, sizeof rate, rays_per_second(done, seconds));
    snprintf(text, sizeof text, "%s: %ld %s in %.2f s, %s %s/s", p->what, done, p->unit,
             seconds, rate, p->unit);
    if (p->terminal)
        draw(p, text, "\n");
    else
        fprintf(stderr, "%s\n", text);
    free(p->cells);
    p->cells = NULL;
    p->preview = NULL;
}
