// geometry.c: rays and what they meet, in the plane z = 0.
#include "common/real.h"

#include "chapters/06-bounce/bounce.h"
#include "slides/figures/figures.h"

static vec3 vec(point p) {
    return (vec3){(real)p.x, (real)p.y, 0};
}
static point on_ray(point O, point d, double t) {
    return (point){O.x + t * d.x, O.y + t * d.y};
}
static point plus(point a, double s, point b) {
    return (point){a.x + s * b.x, a.y + s * b.y};
}

// ---- the camera ----------------------------------------------------------------------

void camera_figure(const char *folder) {
    drawing d = svg_begin(folder, "camera", (point){-0.8, -1.5}, (point){6.8, 1.5}, 900);
    const point O = {0, 0}, c = {5.4, 0.35};
    const double f = 1.8, half = 1.2, r = 0.85;
    enum { ROWS = 8 };
    const point b = {f, half - 2 * half * 3.5 / ROWS}; // the middle of a pixel
    const sphere S = {vec(c), (real)r};
    for (int i = 0; i < ROWS; i++) {
        const point through = {f, half - 2 * half * (i + 0.5) / ROWS};
        const real t = sphere_hit(S, (ray){vec(O), vec(through)}, 0, NO_HIT);
        const double end = fmin(6.6 / f, 1.45 / fabs(through.y)); // of the drawing
        svg_line(&d, O, on_ray(O, through, t == NO_HIT ? end : (double)t), FAINT);
    }
    svg_line(&d, (point){f, -half}, (point){f, half}, OBJECT);
    for (int i = 0; i <= ROWS; i++) {
        const double y = half - 2 * half * i / ROWS;
        svg_line(&d, (point){f - 0.06, y}, (point){f + 0.06, y}, OBJECT);
    }
    svg_circle(&d, c, r, OBJECT, PALE);
    const real t = sphere_hit(S, (ray){vec(O), vec(b)}, 0, NO_HIT);
    svg_arrow(&d, O, on_ray(O, b, (double)t), RAY);
    svg_dot(&d, O, OBJECT);
    svg_dot(&d, b, RAY);
    svg_vector(&d, O, -0.9, 0, "O");
    svg_vector(&d, b, 0.8, -0.65, "b");
    svg_end(&d);
}

// Rays from a lamp in all directions, and one that comes into the eye.
void backwards_figure(const char *folder) {
    drawing d = svg_begin(folder, "backwards", (point){-3.6, -0.1}, (point){3.6, 2.75}, 900);
    const point lamp = {-1.7, 2}, eye = {3, 1.3}, floor = {0.9, 0};
    svg_line(&d, (point){-3.6, 0}, (point){3.6, 0}, OBJECT);
    enum { RAYS = 26 };
    for (int i = 0; i < RAYS; i++) {
        const double angle = 2 * PI * (i + 0.3) / RAYS;
        const point u = {cos(angle), sin(angle)};
        const real t =
            plane_hit((plane){{0, 0, 0}, {0, 1, 0}}, (ray){vec(lamp), vec(u)}, 0, NO_HIT);
        svg_arrow(&d, plus(lamp, 0.15, u), plus(lamp, t < 2.7 ? (double)t : 0.7, u), LIGHT);
    }
    svg_line(&d, floor, lamp, HELP);
    svg_circle(&d, lamp, 0.12, LIGHT, WARM);
    svg_arrow(&d, eye, floor, RAY);
    svg_circle(&d, eye, 0.11, OBJECT, PALE);
    svg_end(&d);
}

// ---- what a ray meets -----------------------------------------------------------------

void plane_figure(const char *folder) {
    drawing d = svg_begin(folder, "plane", (point){-0.6, -0.7}, (point){6.9, 2.1}, 900);
    const point O = {0.1, 1.75}, u = {1.25, -0.4}, x = {6, 0.5}, n = {-0.14, 1};
    const plane P = {vec(x), vec(n)};
    const double t = (double)plane_hit(P, (ray){vec(O), vec(u)}, 0, NO_HIT);
    const point p = on_ray(O, u, t), along = {n.y, -n.x};
    const double k = ((O.x - x.x) * n.x + (O.y - x.y) * n.y) / (n.x * n.x + n.y * n.y);
    svg_line(&d, plus(x, -6.5, along), plus(x, 0.8, along), OBJECT);
    svg_line(&d, O, plus(O, -k, n), HELP);
    svg_line(&d, x, O, HELP);
    svg_arrow(&d, O, p, RAY);
    svg_arrow(&d, O, plus(O, 1, u), OBJECT);
    svg_arrow(&d, x, plus(x, 1, n), OBJECT);
    svg_dot(&d, O, OBJECT);
    svg_dot(&d, x, OBJECT);
    svg_dot(&d, p, RAY);
    svg_vector(&d, O, -0.8, 0.1, "O");
    svg_vector(&d, plus(O, 0.55, u), -0.1, -0.9, "d");
    svg_vector(&d, x, 0.2, -0.9, "x");
    svg_vector(&d, plus(x, 1, n), 0.7, -0.3, "n");
    svg_vector(&d, p, 0.1, -0.95, "p");
    svg_end(&d);
}

void sphere_figure(const char *folder) {
    drawing d = svg_begin(folder, "sphere", (point){-0.7, -1.5}, (point){7.1, 1.3}, 900);
    const point O = {0, 0.75}, u = {1, -0.1}, c = {4.3, -0.1};
    const double r = 1.3;
    const sphere S = {vec(c), (real)r};
    const ray R = {vec(O), vec(u)};
    const double t1 = (double)sphere_hit(S, R, 0, NO_HIT);
    const double t2 = (double)sphere_hit(S, R, (real)t1, NO_HIT);
    const point first = on_ray(O, u, t1);
    svg_circle(&d, c, r, OBJECT, PALE);
    svg_line(&d, O, c, HELP);
    svg_line(&d, c, first, HELP);
    svg_arrow(&d, O, on_ray(O, u, 6.8), RAY);
    svg_arrow(&d, O, on_ray(O, u, 1), OBJECT);
    svg_dot(&d, O, OBJECT);
    svg_dot(&d, c, OBJECT);
    svg_dot(&d, first, RAY);
    svg_dot(&d, on_ray(O, u, t2), RAY);
    svg_vector(&d, O, -0.8, 0.1, "O");
    svg_vector(&d, on_ray(O, u, 0.9), 0.1, 0.8, "d");
    svg_vector(&d, c, 0.5, -0.6, "c");
    svg_symbol(&d, first, -0.5, 0.9, "t_1");
    svg_symbol(&d, on_ray(O, u, t2), 0.8, 0.8, "t_2");
    svg_symbol(&d, plus(c, 0.5, (point){first.x - c.x, first.y - c.y}), 0.6, 0.4, "r");
    svg_vector(&d, (point){c.x / 2, (O.y + c.y) / 2}, 0, -0.9, "v");
    svg_end(&d);
}

// Seen aslant, so that the normal has a place.
void triangle_figure(const char *folder) {
    drawing d = svg_begin(folder, "triangle", (point){-0.9, -0.5}, (point){7.2, 2.3}, 900);
    const point p1 = {0, 0.3}, p2 = {5.3, 0}, p3 = {4.2, 1.65}, n = {0, 1.5};
    const point corners[] = {p1, p2, p3}, p = {3.3, 0.6};
    svg_polygon(&d, corners, 3, FAINT, PALE);
    svg_line(&d, p2, p3, OBJECT);
    svg_arrow(&d, p1, p2, OBJECT);
    svg_arrow(&d, p1, p3, OBJECT);
    svg_arrow(&d, p1, plus(p1, 1, n), OBJECT);
    svg_arrow(&d, (point){6.4, 2.15}, p, RAY);
    svg_dot(&d, p, RAY);
    svg_vector(&d, p1, -0.8, -0.2, "p_1");
    svg_vector(&d, p2, 0.9, 0, "p_2");
    svg_vector(&d, p3, -0.2, 0.9, "p_3");
    svg_vector(&d, plus(p1, 1, n), -0.7, -0.2, "n");
    svg_vector(&d, p, -0.7, -0.1, "p");
    svg_end(&d);
}

// The three part triangles at p: each has the sign of its turn.
void inside_figure(const char *folder) {
    drawing d = svg_begin(folder, "inside", (point){-0.6, -0.3}, (point){11.1, 3.25}, 1000);
    for (int side = 0; side < 2; side++) {
        const double x = 5.6 * side;
        const point a = {x + 0.3, 0.2}, b = {x + 4.2, 0.6}, c = {x + 1.6, 2.6};
        const point p = side ? (point){x + 4.3, 2.1} : (point){x + 2.1, 1.1};
        const point all[] = {a, b, c};
        const vec3 n = {0, 0, 1};
        const triangle T = {vec(a), vec(b), vec(c)};
        svg_polygon(&d, all, 3, OBJECT, point_in_triangle(vec(p), T, n) ? PALE : NO_FILL);
        for (int i = 0; i < 3; i++) {
            const point *from = &all[i], *to = &all[(i + 1) % 3];
            const double turn =
                (to->x - from->x) * (p.y - from->y) - (to->y - from->y) * (p.x - from->x);
            svg_arrow(&d, *from, *to, OBJECT);
            svg_line(&d, *from, p, HELP);
            const point middle = {(from->x + to->x + p.x) / 3, (from->y + to->y + p.y) / 3};
            svg_symbol(&d, middle, 0, 0, turn > 0 ? "+" : "−");
        }
        svg_dot(&d, p, RAY);
        svg_vector(&d, p, side ? 0.8 : 0.7, side ? 0.2 : 0.3, "p");
        svg_vector(&d, a, -0.9, -0.2, "p_1");
        svg_vector(&d, b, 0.9, -0.2, "p_2");
        svg_vector(&d, c, -0.2, 0.9, "p_3");
    }
    svg_end(&d);
}

// ---- the bounce ----------------------------------------------------------------------

// "−2(d·n) n", the arrows with it.
static void twice_symbol(drawing *d, point at) {
    svg_symbol(d, at, 1.1, 0, "−2(");
    svg_vector(d, at, 2.3, 0, "d");
    svg_symbol(d, at, 2.85, 0, "·");
    svg_vector(d, at, 3.35, 0, "n");
    svg_symbol(d, at, 3.9, 0, ")");
    svg_vector(d, at, 4.6, 0, "n");
}

void bounce_figure(const char *folder) {
    drawing d = svg_begin(folder, "bounce", (point){-3.6, -1.6}, (point){4.4, 1.7}, 860);
    const point u = {2.1, -1.5}, zero = {0, 0}, n = {0, 1};
    const vec3 r = reflect(vec(u), vec(n));
    const point out = {(double)r.x, (double)r.y}, below = plus(zero, 1, u);
    svg_line(&d, (point){-3.6, 0}, (point){4.4, 0}, OBJECT);
    svg_arrow(&d, zero, below, HELP);
    svg_arrow(&d, below, plus(out, -0.04, n), LIGHT);
    svg_arrow(&d, (point){-u.x, -u.y}, zero, RAY);
    svg_arrow(&d, zero, out, RAY);
    svg_arrow(&d, zero, n, OBJECT);
    svg_vector(&d, (point){-u.x / 2, -u.y / 2}, -0.5, -0.7, "d");
    svg_vector(&d, (point){out.x / 2, out.y / 2}, -0.5, 0.6, "r");
    svg_vector(&d, n, -0.6, -0.2, "n");
    twice_symbol(&d, (point){out.x, -0.75});
    svg_vector(&d, (point){below.x / 2, below.y / 2}, -0.6, -0.6, "d");
    svg_end(&d);
}

// The mirrored direction, and a ball of random vectors around its end.
void fuzzy_figure(const char *folder) {
    drawing d = svg_begin(folder, "fuzzy", (point){-3.2, -0.32}, (point){4.2, 2.2}, 900);
    const point u = {1.9, -1}, zero = {0, 0};
    const vec3 r = reflect(vec(u), (vec3){0, 1, 0});
    const point out = {(double)r.x, (double)r.y};
    const double fuzz = 1.15;
    svg_line(&d, (point){-3.2, 0}, (point){4.2, 0}, OBJECT);
    svg_circle(&d, out, fuzz, HELP, NO_FILL);
    svg_arrow(&d, (point){-u.x, -u.y}, zero, RAY);
    svg_arrow(&d, zero, out, RAY);
    enum { RAYS = 7 };
    for (int i = 0; i < RAYS; i++) {
        const double angle = 2 * PI * i / RAYS + 0.35;
        const point end = {out.x + 0.95 * fuzz * cos(angle), out.y + 0.95 * fuzz * sin(angle)};
        svg_arrow(&d, zero, end, end.y > 0 ? FAINT : LIGHT);
    }
    svg_vector(&d, (point){-u.x / 2, -u.y / 2}, -0.3, -0.9, "d");
    svg_vector(&d, out, 0.7, 0.3, "r");
    svg_end(&d);
}

// A ray that bounces between three balls until it leaves: each colour multiplies.
void loop_figure(const char *folder) {
    drawing d = svg_begin(folder, "loop", (point){-0.2, -0.5}, (point){6.6, 4.9}, 460);
    const sphere balls[] = {{{(real)3.1, (real)0.6, 0}, (real)0.9},
                            {{(real)2.3, (real)2.75, 0}, (real)0.45},
                            {{(real)5.6, (real)2.2, 0}, (real)0.8}};
    const char *fills[] = {"#f2b8b5", "#c7d7f5", "#bfe3c0"};
    const char *names[] = {"F_1", "F_2", "F_3"};
    for (int i = 0; i < 3; i++) {
        const point c = {(double)balls[i].c.x, (double)balls[i].c.y};
        svg_circle(&d, c, (double)balls[i].r, OBJECT, fills[i]);
        svg_symbol(&d, c, 0, 0, names[i]);
    }
    ray r = {{0, (real)1.2, 0}, normalize((vec3){1, (real)0.025, 0})};
    for (int bounces = 0; bounces < 6; bounces++) {
        int which = -1;
        real t = NO_HIT;
        for (int i = 0; i < 3; i++) {
            const real ti = sphere_hit(balls[i], r, (real)1e-3, t);
            if (ti < t) t = ti, which = i;
        }
        const vec3 at = ray_at(r, which < 0 ? (real)1.7 : t);
        const point end = {(double)at.x, (double)at.y};
        svg_arrow(&d, (point){(double)r.O.x, (double)r.O.y}, end, RAY);
        if (which < 0) {
            svg_symbol(&d, end, 0, 0.8, "F_B");
            break;
        }
        r = (ray){at, reflect(r.d, sphere_surface(balls[which], r, t).n)};
    }
    svg_dot(&d, (point){0, 1.2}, OBJECT);
    svg_end(&d);
}
