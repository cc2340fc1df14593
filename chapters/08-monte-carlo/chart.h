// chart.h: lines, dots and small capitals on a picture, for programs that draw what they
// measured.
#ifndef CHAPTER_CHART_H
#define CHAPTER_CHART_H

#include "common/image.h"

// A frame within a picture, and the range of x and y that it shows.
typedef struct {
    image *on;
    double left, right, top, bottom; // in pixels; top < bottom
    double x0, x1, y0, y1;           // x0 at the left, y0 at the bottom
} frame;

extern const color chart_paper, chart_ink, chart_pale;

image chart_paper_new(int width, int height);

// A line between two points, or a dot, in the frame's own units; the thickness and the
// radius in pixels. Edges are smooth; what leaves the frame is cut off.
void chart_line(const frame *f, double x0, double y0, double x1, double y1, double thickness,
                color c);
void chart_dot(const frame *f, double x, double y, double radius, color c);

// A line and its power of ten below for each whole x, for logarithmic axes; for each whole
// y to the left.
void chart_powers_x(const frame *f);
void chart_powers_y(const frame *f);

// Capitals, digits and - . / from pixel (x, y), the top left corner: 6 x 10 pixels each
// and 2 between. Other characters are blank.
void chart_text(const image *on, double x, double y, const char *text, color c);

// The same to the right of the frame, or to its left, at the height y.
void chart_name(const frame *f, double y, const char *text, color c);
void chart_mark(const frame *f, double y, const char *text, color c);

#endif
