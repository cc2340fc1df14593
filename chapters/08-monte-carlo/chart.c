// chart.c: see chart.h.
#include "chapters/08-monte-carlo/chart.h"

#include <stdio.h>
#include <string.h>

const color chart_paper = {(real)0.93, (real)0.93, (real)0.91};
const color chart_ink = {(real)0.02, (real)0.02, (real)0.02};
const color chart_pale = {(real)0.68, (real)0.68, (real)0.67};

image chart_paper_new(int width, int height) {
    image img = image_new(width, height);
    for (int i = 0; i < width * height; i++) img.pixels[i] = chart_paper;
    return img;
}

// ---- lines and dots ------------------------------------------------------------------

static double pixel_x(const frame *f, double x) {
    return f->left + (x - f->x0) / (f->x1 - f->x0) * (f->right - f->left);
}

static double pixel_y(const frame *f, double y) {
    return f->bottom - (y - f->y0) / (f->y1 - f->y0) * (f->bottom - f->top);
}

typedef struct {
    double x0, y0, x1, y1; // in pixels
} segment;

static double distance(segment s, double x, double y) {
    const double dx = s.x1 - s.x0, dy = s.y1 - s.y0, square = dx * dx + dy * dy;
    const double along = square > 0 ? ((x - s.x0) * dx + (y - s.y0) * dy) / square : 0;
    const double t = fmin(1, fmax(0, along));
    return hypot(x - s.x0 - t * dx, y - s.y0 - t * dy);
}

static int within(double x, double least, double most) {
    return (int)fmin(most, fmax(least, x));
}

// All pixels of the frame within `radius` of the segment; the last one by its share. What
// has no place, as log 0, is not drawn.
static void stroke(const frame *f, segment s, double radius, color c) {
    if (!isfinite(s.x0 + s.x1 + s.y0 + s.y1)) return;
    const double reach = radius + 1, width = f->on->width, height = f->on->height;
    const int left = within(fmin(s.x0, s.x1) - reach, fmax(f->left, 0), width);
    const int right = within(fmax(s.x0, s.x1) + reach, 0, fmin(f->right, width));
    const int top = within(fmin(s.y0, s.y1) - reach, fmax(f->top, 0), height);
    const int bottom = within(fmax(s.y0, s.y1) + reach, 0, fmin(f->bottom, height));
    for (int y = top; y < bottom; y++)
        for (int x = left; x < right; x++) {
            const double inside = radius + 0.5 - distance(s, x + 0.5, y + 0.5);
            color *at = image_at(f->on, x, y);
            *at = lerp(*at, c, (real)fmin(1, fmax(0, inside)));
        }
}

void chart_line(const frame *f, double x0, double y0, double x1, double y1, double thickness,
                color c) {
    const segment s = {pixel_x(f, x0), pixel_y(f, y0), pixel_x(f, x1), pixel_y(f, y1)};
    stroke(f, s, thickness / 2, c);
}

void chart_dot(const frame *f, double x, double y, double radius, color c) {
    const segment s = {pixel_x(f, x), pixel_y(f, y), pixel_x(f, x), pixel_y(f, y)};
    stroke(f, s, radius, c);
}

// ---- letters -------------------------------------------------------------------------

// Five rows of three dots, each an octal digit.
static const unsigned short digits[] = {075557, 026227, 071747, 071717, 055711,
                                        074717, 074757, 071111, 075757, 075717};
static const unsigned short letters[] = {025755, 065656, 034443, 065556, 074647, 074644, 034553,
                                         055755, 072227, 011152, 055655, 044447, 057755, 065555,
                                         025552, 065644, 025563, 065655, 034216, 072222, 055557,
                                         055552, 055775, 055255, 055222, 071247};

static unsigned dots_of(char c) {
    if (c >= '0' && c <= '9') return digits[c - '0'];
    if (c >= 'A' && c <= 'Z') return letters[c - 'A'];
    return c == '-' ? 000700 : c == '.' ? 000002 : c == '/' ? 011244 : 0;
}

enum { DOT = 2, LETTER = 4 * DOT, HEIGHT = 5 * DOT }; // in pixels

static void square_dot(const image *on, int x, int y, color c) {
    for (int b = y; b < y + DOT; b++)
        for (int a = x; a < x + DOT; a++)
            if (a >= 0 && a < on->width && b >= 0 && b < on->height) *image_at(on, a, b) = c;
}

void chart_text(const image *on, double x, double y, const char *text, color c) {
    for (int left = (int)x, top = (int)y; *text; text++, left += LETTER)
        for (int dot = 0; dot < 15; dot++)
            if (dots_of(*text) >> (14 - dot) & 1)
                square_dot(on, left + dot % 3 * DOT, top + dot / 3 * DOT, c);
}

void chart_name(const frame *f, double y, const char *text, color c) {
    const double on_chart = fmin(f->y1, fmax(f->y0, y));
    chart_text(f->on, f->right + LETTER, pixel_y(f, on_chart) - HEIGHT / 2, text, c);
}

void chart_mark(const frame *f, double y, const char *text, color c) {
    const double width = LETTER * (double)strlen(text);
    chart_text(f->on, f->left - 4 - width, pixel_y(f, y) - HEIGHT / 2, text, c);
}

// The exponent stands as high as in print.
static void power(const image *on, double x, double y, int exponent) {
    char text[16];
    snprintf(text, sizeof text, "%d", exponent);
    chart_text(on, x, y, "10", chart_ink);
    chart_text(on, x + 2 * LETTER, y - 2 * DOT, text, chart_ink);
}

void chart_powers_x(const frame *f) {
    for (int x = (int)ceil(f->x0); x <= f->x1; x++) {
        chart_line(f, x, f->y0, x, f->y1, 1, chart_pale);
        power(f->on, pixel_x(f, x) - LETTER, f->bottom + HEIGHT, x);
    }
}

void chart_powers_y(const frame *f) {
    for (int y = (int)ceil(f->y0); y <= f->y1; y++) {
        chart_line(f, f->x0, y, f->x1, y, 1, chart_pale);
        power(f->on, f->left - 4 - 4 * LETTER, pixel_y(f, y) - HEIGHT / 2, y);
    }
}
