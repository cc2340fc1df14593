// svg.h: line drawings for the slides. Coordinates are those of the scene, y up; the drawing
// is scaled to the slide.
#ifndef SLIDES_SVG_H
#define SLIDES_SVG_H

#include <stdio.h>

typedef struct {
    double x, y;
} point;

typedef struct {
    FILE *file;
    double left, top, scale; // of the scene; pixels per unit
} drawing;

// A drawing of the scene's rectangle from `low` to `high`, `width` pixels wide. Dies when the file
// cannot be written.
drawing svg_begin(const char *folder, const char *name, point low, point high, double width);
void svg_end(drawing *d);

// How lines look: named by what they stand for.
typedef enum { OBJECT, RAY, HELP, LIGHT, FAINT, THIN } pen;

void svg_line(drawing *d, point a, point b, pen p);
void svg_arrow(drawing *d, point from, point to, pen p);
void svg_circle(drawing *d, point c, double r, pen p, const char *fill);
void svg_arc(drawing *d, point c, double r, double from, double to, pen p); // radians
void svg_polygon(drawing *d, const point *p, int count, pen how, const char *fill);
void svg_box(drawing *d, point low, point high, pen how, const char *fill);
void svg_dot(drawing *d, point at, pen p);
// A symbol in italics beside the point, moved by (dx, dy) letters; "_" begins an index.
void svg_symbol(drawing *d, point at, double dx, double dy, const char *text);
void svg_vector(drawing *d, point at, double dx, double dy, const char *text); // with an arrow
void svg_words(drawing *d, point at, double dx, double dy, const char *text);

#define NO_FILL "none"
#define PALE "#dfe7ef"
#define WARM "#f6d9a8"

#endif
