// svg.c: see svg.h.
#include "slides/figures/svg.h"

#include <errno.h>
#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "common/die.h"

enum { FONT = 26 };

static const char *const colors[] = {"#1d3557", "#c1121f", "#6c757d",
                                     "#e09f00", "#b8c0c8", "#c1121f"};
static const double widths[] = {3.5, 3, 1.8, 3, 1.5, 1.2};
static const char *const dashes[] = {"none", "none", "7 6", "none", "none", "none"};

static double px(const drawing *d, double x) {
    return (x - d->left) * d->scale;
}
static double py(const drawing *d, double y) {
    return (d->top - y) * d->scale;
}

static void stroke(drawing *d, pen p) {
    fprintf(d->file, " stroke=\"%s\" stroke-width=\"%g\" stroke-dasharray=\"%s\"", colors[p],
            widths[p], dashes[p]);
}

drawing svg_begin(const char *folder, const char *name, point low, point high, double width) {
    char path[512];
    if (snprintf(path, sizeof path, "%s/%s.svg", folder, name) >= (int)sizeof path)
        die(EXIT_RUN, "%s: the name is too long", folder);
    FILE *file = fopen(path, "w");
    if (!file) die(EXIT_RUN, "%s: %s", path, strerror(errno));
    const double scale = width / (high.x - low.x), height = scale * (high.y - low.y);
    fprintf(
        file,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %.0f %.0f\" width=\"%.0f\" "
        "height=\"%.0f\">\n",
        width, height, width, height);
    return (drawing){file, low.x, high.y, scale};
}

void svg_end(drawing *d) {
    fputs("</svg>\n", d->file);
    if (fclose(d->file)) die(EXIT_RUN, "a figure could not be written: %s", strerror(errno));
}

void svg_line(drawing *d, point a, point b, pen p) {
    fprintf(d->file,
            "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke-linecap=\"round\"",
            px(d, a.x), py(d, a.y), px(d, b.x), py(d, b.y));
    stroke(d, p);
    fputs("/>\n", d->file);
}

void svg_arrow(drawing *d, point from, point to, pen p) {
    enum { HEAD = 14 }; // pixels
    const double x = px(d, to.x), y = py(d, to.y), dx = x - px(d, from.x),
                 dy = y - py(d, from.y);
    const double l = hypot(dx, dy), u = dx / l, v = dy / l;
    const point neck = {to.x - HEAD * 0.8 * u / d->scale, to.y + HEAD * 0.8 * v / d->scale};
    svg_line(d, from, neck, p);
    fprintf(d->file, "<polygon points=\"%.1f,%.1f %.1f,%.1f %.1f,%.1f\" fill=\"%s\"/>\n", x, y,
            x - HEAD * u - HEAD * 0.4 * v, y - HEAD * v + HEAD * 0.4 * u,
            x - HEAD * u + HEAD * 0.4 * v, y - HEAD * v - HEAD * 0.4 * u, colors[p]);
}

void svg_circle(drawing *d, point c, double r, pen p, const char *fill) {
    fprintf(d->file, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\" fill=\"%s\"", px(d, c.x),
            py(d, c.y), r * d->scale, fill);
    stroke(d, p);
    fputs("/>\n", d->file);
}

void svg_arc(drawing *d, point c, double r, double from, double to, pen p) {
    const double R = r * d->scale;
    fprintf(d->file, "<path d=\"M %.1f %.1f A %.1f %.1f 0 %d 0 %.1f %.1f\" fill=\"none\"",
            px(d, c.x + r * cos(from)), py(d, c.y + r * sin(from)), R, R,
            to - from > 3.14159265358979, px(d, c.x + r * cos(to)), py(d, c.y + r * sin(to)));
    stroke(d, p);
    fputs("/>\n", d->file);
}

void svg_polygon(drawing *d, const point *p, int count, pen how, const char *fill) {
    fputs("<polygon points=\"", d->file);
    for (int i = 0; i < count; i++)
        fprintf(d->file, "%.1f,%.1f ", px(d, p[i].x), py(d, p[i].y));
    fprintf(d->file, "\" fill=\"%s\" stroke-linejoin=\"round\"", fill);
    stroke(d, how);
    fputs("/>\n", d->file);
}

void svg_box(drawing *d, point low, point high, pen how, const char *fill) {
    const point corners[] = {low, {high.x, low.y}, high, {low.x, high.y}};
    svg_polygon(d, corners, 4, how, fill);
}

void svg_dot(drawing *d, point at, pen p) {
    fprintf(d->file, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"6\" fill=\"%s\"/>\n", px(d, at.x),
            py(d, at.y), colors[p]);
}

static void begin_text(drawing *d, point at, double dx, double dy, const char *style) {
    fprintf(d->file,
            "<text x=\"%.1f\" y=\"%.1f\" font-family=\"DejaVu Serif, serif\" font-size=\"%d\" "
            "text-anchor=\"middle\" dominant-baseline=\"central\" fill=\"#222\"%s>",
            px(d, at.x) + dx * FONT, py(d, at.y) - dy * FONT, (int)FONT, style);
}

void svg_symbol(drawing *d, point at, double dx, double dy, const char *text) {
    const char *below = strchr(text, '_');
    begin_text(d, at, dx, dy, " font-style=\"italic\"");
    if (!below)
        fprintf(d->file, "%s</text>\n", text);
    else
        fprintf(d->file, "%.*s<tspan font-size=\"%d\" dy=\"8\">%s</tspan></text>\n",
                (int)(below - text), text, (int)(FONT * 0.7), below + 1);
}

// The arrow stands above the first letter; what comes below moves that to the left.
void svg_vector(drawing *d, point at, double dx, double dy, const char *text) {
    svg_symbol(d, at, dx, dy, text);
    const bool tall = strchr("Obdkl", *text) || (*text >= 'A' && *text <= 'Z');
    const char *below = strchr(text, '_');
    const double x = px(d, at.x) +
                     FONT * (dx + 0.08 - (below ? 0.22 * (double)strlen(below + 1) : 0)),
                 y = py(d, at.y) - FONT * (dy + (tall ? 0.55 : 0.36)), half = FONT * 0.27;
    fprintf(d->file,
            "<path d=\"M %.1f %.1f h %.1f m -5 -4 l 5 4 l -5 4\" fill=\"none\" stroke=\"#222\" "
            "stroke-width=\"1.6\"/>\n",
            x - half, y, 2 * half);
}

void svg_words(drawing *d, point at, double dx, double dy, const char *text) {
    begin_text(d, at, dx, dy, "");
    fprintf(d->file, "%s</text>\n", text);
}
