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
    drawing d = svg_begin(folder, "path", (point){-0.1, -0.5}, (point){5.2, 3.6}, 620);
    draw_room(&d);
    const point above = {2.6, 3.3};
    svg_arc(&d, stations[1], 0.7, 0, PI, HELP);
    svg_symbol(&d, polar(stations[1], 0.7, PI * 0.62), 0, 0.7, "Ω");
    svg_symbol(&d, stations[1], 0, -0.7, "x");
    for (int i = 0; i + 1 < 5; i++) svg_arrow(&d, stations[i], stations[i + 1], RAY);
    svg_arrow(&d, stations[4], above, RAY);
    for (int i = 1; i < 5; i++) svg_dot(&d, stations[i], RAY);
    svg_end(&d);
}

// The same with a ray to the lamp at each station.
void lamp_figure(const char *folder) {
    drawing d = svg_begin(folder, "lamp", (point){-0.1, -0.5}, (point){5.2, 3.9}, 620);
    draw_room(&d);
    const point y = {2.75, 3.3}, x = stations[1], other = {3, 3.3};
    const double towards_x = atan2(x.y - y.y, x.x - y.x);
    for (int i = 0; i + 1 < 4; i++) svg_arrow(&d, stations[i], stations[i + 1], RAY);
    svg_arrow(&d, x, y, LIGHT);
    svg_arrow(&d, stations[2], other, LIGHT);
    svg_arrow(&d, y, (point){y.x, y.y - 1.6}, OBJECT);
    svg_arc(&d, y, 1, towards_x, -PI / 2, HELP);
    svg_symbol(&d, polar(y, 1.25, (towards_x - PI / 2) / 2), 0, -0.1, "θ′");
    for (int i = 1; i < 4; i++) svg_dot(&d, stations[i], RAY);
    svg_dot(&d, y, LIGHT);
    svg_symbol(&d, x, 0, -0.7, "x");
    svg_symbol(&d, y, -0.7, -0.5, "y");
    svg_symbol(&d, (point){2.5, 3.4}, 0, 0.7, "A");
    svg_end(&d);
}

void snell_figure(const char *folder) {
    drawing d = svg_begin(folder, "snell", (point){-2, -2}, (point){2.3, 2}, 560);
    const double eta = 1.5, theta = 50 * PI / 180;
    const vec3 n = {0, 1, 0}, in = {(real)sin(theta), (real)-cos(theta), 0};
    vec3 t = {0, 0, 0};
    refract(in, n, (real)eta, &t);
    const vec3 r = reflect(in, n);
    const point zero = {0, 0}, refracted = {1.8 * (double)t.x, 1.8 * (double)t.y};
    svg_box(&d, (point){-2, -2}, (point){2.3, 0}, FAINT, PALE);
    svg_line(&d, (point){-2, 0}, (point){2.3, 0}, OBJECT);
    svg_line(&d, (point){0, -1.8}, (point){0, 1.8}, HELP);
    svg_arrow(&d, (point){-1.8 * (double)in.x, -1.8 * (double)in.y}, zero, RAY);
    svg_arrow(&d, zero, (point){1.8 * (double)r.x, 1.8 * (double)r.y}, LIGHT);
    svg_arrow(&d, zero, refracted, RAY);
    svg_arc(&d, zero, 0.7, PI / 2, PI / 2 + theta, HELP);
    svg_arc(&d, zero, 0.7, -PI / 2, -PI / 2 + asin(sin(theta) / eta), HELP);
    svg_symbol(&d, polar(zero, 0.95, PI / 2 + theta / 2), 0, 0, "θ");
    svg_symbol(&d, polar(zero, 1, -PI / 2 + asin(sin(theta) / eta) / 2), 0, 0, "θ_t");
    svg_symbol(&d, (point){1.8 * (double)r.x, 1.8 * (double)r.y}, 0.8, 0, "R");
    svg_symbol(&d, refracted, 2, 0, "1 − R");
    svg_symbol(&d, (point){-1.7, 0}, 0, 0.7, "n_i");
    svg_symbol(&d, (point){-1.7, 0}, 0, -0.7, "n_t");
    svg_end(&d);
}

// R over the angle of the ray, 0 to 90 degrees: into glass and out of it, exact; dashed Schlick by
// the ray's own cosine, the dots by the cosine on the less dense side.
void fresnel_figure(const char *folder) {
    drawing d = svg_begin(folder, "fresnel", (point){-0.15, -0.22}, (point){3.4, 1.06}, 860);
    enum { STEPS = 360 };
    const double most = 3.1; // the width of 90 degrees
    const real etas[] = {(real)1.5, (real)(1 / 1.5)};
    svg_line(&d, (point){0, 0}, (point){most, 0}, OBJECT);
    svg_line(&d, (point){0, 0}, (point){0, 1}, OBJECT);
    for (int side = 0; side < 2; side++)
        for (int i = 0; i < STEPS; i++) {
            const double a = i * PI / 2 / STEPS, b = (i + 1) * PI / 2 / STEPS;
            const double x = most * i / STEPS, y = most * (i + 1) / STEPS;
            const real p = (real)cos(a), q = (real)cos(b), eta = etas[side];
            svg_line(&d, (point){x, (double)fresnel_dielectric(p, eta)},
                     (point){y, (double)fresnel_dielectric(q, eta)}, side ? RAY : OBJECT);
            if (i % 10 == 0)
                svg_circle(&d, (point){x, (double)schlick(p, eta)}, 0.015, LIGHT, NO_FILL);
            if (i % 10 < 5 && side)
                svg_line(&d, (point){x, (double)schlick(p, etas[0])},
                         (point){y, (double)schlick(q, etas[0])}, FAINT);
        }
    svg_symbol(&d, (point){most, 0}, 0.8, 0, "θ");
    svg_symbol(&d, (point){0, 1}, -0.6, -0.2, "R");
    svg_words(&d, (point){most / 2, 0}, 0, -0.9, "45°");
    svg_words(&d, (point){most, 0}, 0, -0.9, "90°");
    svg_end(&d);
}
