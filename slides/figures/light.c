// light.c: how light arrives, and what a path does in a room.
#include "common/real.h"

#include "chapters/11-fresnel/fresnel.h"
#include "slides/figures/figures.h"

static point polar(point c, double r, double angle) {
    return (point){c.x + r * cos(angle), c.y + r * sin(angle)};
}

// The same beam, straight on and aslant: it covers 1 / cos θ as much of the floor.
void cosine_figure(const char *folder) {
    drawing d = svg_begin(folder, "cosine", (point){-2, -0.75}, (point){8.4, 2.75}, 1000);
    for (int side = 0; side < 2; side++) {
        const double theta = side ? PI / 3 : 0, half = 0.5, x = side ? 4.6 : 0;
        const point u = {sin(theta), cos(theta)};
        const double foot = half / cos(theta);
        svg_line(&d, (point){x - 2, 0}, (point){side ? x + 3.8 : 1.6, 0}, OBJECT);
        for (int i = -2; i <= 2; i++) {
            const point end = {x + foot * i / 2, 0};
            // back along the beam to a line across it
            const double along = (side ? 3 : 2.4) - (end.x - x) * u.x;
            svg_arrow(&d, (point){end.x + along * u.x, along * u.y}, end, LIGHT);
        }
        svg_line(&d, (point){x - foot, -0.12}, (point){x + foot, -0.12}, RAY);
        svg_symbol(&d, (point){x, 0}, 0, -1.1, side ? "1 / cos θ" : "1");
        const point base = {side ? x : x - 1.2, 0};
        svg_arrow(&d, base, (point){base.x, 1.5}, OBJECT);
        svg_vector(&d, (point){base.x, 1.5}, -0.7, -0.1, "n");
        if (side) {
            svg_arc(&d, (point){x, 0}, 1, PI / 2 - theta, PI / 2, HELP);
            svg_symbol(&d, polar((point){x, 0}, 1.25, PI / 2 - theta / 2), 0, 0, "θ");
        }
    }
    svg_end(&d);
}

void solid_angle_figure(const char *folder) {
    drawing d = svg_begin(folder, "solid-angle", (point){-2.1, -0.6}, (point){3.6, 3.4}, 460);
    const point x = {0, 0}, c = {2.3, 2.5};
    const double r = 0.7, far = hypot(c.x, c.y), middle = atan2(c.y, c.x), half = asin(r / far);
    svg_line(&d, (point){-2.1, 0}, (point){3.6, 0}, OBJECT);
    svg_arc(&d, x, 1.8, 0, PI, HELP);
    svg_circle(&d, c, r, LIGHT, WARM);
    svg_line(&d, x, polar(x, far * cos(half), middle + half), LIGHT);
    svg_line(&d, x, polar(x, far * cos(half), middle - half), LIGHT);
    svg_arc(&d, x, 1.8, middle - half, middle + half, RAY);
    svg_arrow(&d, x, (point){0, 2.5}, OBJECT);
    svg_arrow(&d, x, polar(x, 1.2, middle), RAY);
    svg_dot(&d, x, OBJECT);
    svg_symbol(&d, x, 0, -0.9, "x");
    svg_symbol(&d, (point){0, 2.5}, -0.7, -0.2, "n");
    svg_symbol(&d, polar(x, 0.95, middle - half), 0.9, -0.1, "ω_i");
    svg_symbol(&d, polar(x, 1.8, middle - half), 1, 0.7, "dω");
    svg_symbol(&d, polar(x, 1.8, PI * 0.8), -0.7, 0.4, "Ω");
    svg_end(&d);
}

// A path in a room with a lamp in its ceiling: from the eye, bounce by bounce.
static void draw_room(drawing *d) {
    svg_box(d, (point){0, 0}, (point){5, 3.4}, OBJECT, NO_FILL);
    svg_box(d, (point){1.9, 3.3}, (point){3.1, 3.4}, LIGHT, WARM);
    svg_circle(d, (point){3.6, 0.6}, 0.6, OBJECT, PALE);
    svg_dot(d, (point){0.4, 1.2}, OBJECT);
    svg_symbol(d, (point){0.4, 1.2}, -0.2, 0.9, "O");
}

static const point stations[] = {{0.4, 1.2}, {1.5, 0}, {5, 2.4}, {3.9, 3.4}, {3.4, 1.166}};

void path_figure(const char *folder) {
    drawing d = svg_begin(folder, "path", (point){-0.3, -0.3}, (point){5.3, 3.7}, 720);
    draw_room(&d);
    const point above = {2.6, 3.3};
    for (int i = 0; i + 1 < 4; i++) svg_arrow(&d, stations[i], stations[i + 1], RAY);
    svg_arrow(&d, stations[3], stations[4], RAY);
    svg_arrow(&d, stations[4], above, RAY);
    for (int i = 1; i < 5; i++) svg_dot(&d, stations[i], RAY);
    svg_end(&d);
}

// The same with a ray to the lamp at each station.
void lamp_figure(const char *folder) {
    drawing d = svg_begin(folder, "lamp", (point){-0.3, -0.3}, (point){5.3, 3.7}, 720);
    draw_room(&d);
    const double aims[] = {0, 2.2, 2.9, 0, 2.4};
    for (int i = 0; i + 1 < 4; i++) svg_arrow(&d, stations[i], stations[i + 1], RAY);
    for (int i = 1; i < 3; i++) svg_line(&d, stations[i], (point){aims[i], 3.3}, LIGHT);
    for (int i = 1; i < 4; i++) svg_dot(&d, stations[i], RAY);
    svg_end(&d);
}

void snell_figure(const char *folder) {
    drawing d = svg_begin(folder, "snell", (point){-2.4, -2}, (point){2.6, 2}, 700);
    const double eta = 1.5, theta = 50 * PI / 180;
    const vec3 n = {0, 1, 0}, in = {(real)sin(theta), (real)-cos(theta), 0};
    vec3 t = {0, 0, 0};
    refract(in, n, (real)eta, &t);
    const vec3 r = reflect(in, n);
    const point zero = {0, 0}, refracted = {1.8 * (double)t.x, 1.8 * (double)t.y};
    svg_box(&d, (point){-2.4, -2}, (point){2.6, 0}, FAINT, PALE);
    svg_line(&d, (point){-2.4, 0}, (point){2.6, 0}, OBJECT);
    svg_line(&d, (point){0, -1.8}, (point){0, 1.8}, HELP);
    svg_arrow(&d, (point){-1.8 * (double)in.x, -1.8 * (double)in.y}, zero, RAY);
    svg_arrow(&d, zero, (point){1.8 * (double)r.x, 1.8 * (double)r.y}, LIGHT);
    svg_arrow(&d, zero, refracted, RAY);
    svg_arc(&d, zero, 0.7, PI / 2, PI / 2 + theta, HELP);
    svg_arc(&d, zero, 0.7, -PI / 2, -PI / 2 + asin(sin(theta) / eta), HELP);
    svg_symbol(&d, polar(zero, 0.95, PI / 2 + theta / 2), 0, 0, "θ");
    svg_symbol(&d, polar(zero, 1, -PI / 2 + asin(sin(theta) / eta) / 2), 0, 0, "θ_t");
    svg_symbol(&d, (point){1.8 * (double)r.x, 1.8 * (double)r.y}, 0.7, 0, "R");
    svg_symbol(&d, refracted, 1.4, 0, "1 − R");
    svg_end(&d);
}
