// truth.c: scenes 1 and 2 once more, in double, by themselves: nothing of the solution is used,
// so that the two check each other. Each can be drawn with a classic mistake, which is how a
// wrong picture gets its name.
#include "tests/homework/homework.h"

#include <string.h>

enum {
    NONE,
    BEHIND,
    FAR_ROOT,
    FAR_ROOT_OUTWARD,
    LAST_BODY,
    LAST_SPHERE,
    NO_INSIDE_TEST,
    NO_SUM_TEST,
    CORNER,
    CORNER_UPWARDS,
    ROW_LOW,
    ROW_HIGH,
    COLUMN_LEFT,
    COLUMN_RIGHT,
    UP_IS_Y,
    HALF_FOV,
    WIDE_FOV,
    NO_ASPECT,
    ALONG_VIEW,
    OUTWARD,
    AWAY,
    INTO_VIEW,
    CODED,
    ONE_REFLECTION,
    NO_REFLECTION,
    NO_TINT,
    TINT_OF_LAST,
    CHECKS_SWAPPED,
    CHECKS_TRUNCATED,
    CHECKS_REMAINDER,
    CHECKS_REMAINDER_SWAPPED,
    SKY_UPWARDS,
    REFLECT_PLUS,
    REFLECT_NEGATED,
};
enum { ANY = 1 << DEPTH | 1 << NORMAL | 1 << MIRROR };
const mistake mistakes[] = {
    {"", ANY, NONE},
    {"hits behind the camera count: t > 0 is missing", ANY, BEHIND},
    {"the far side of the spheres is seen: the larger root is taken", ANY, FAR_ROOT},
    {"the far side of the spheres is seen: the larger root is taken", 1 << NORMAL,
     FAR_ROOT_OUTWARD},
    {"the last body hit is seen, not the nearest", ANY, LAST_BODY},
    {"the last sphere hit is seen, not the nearest body", ANY, LAST_SPHERE},
    {"the triangle reaches too far: its inside test", 1 << DEPTH | 1 << NORMAL, NO_INSIDE_TEST},
    {"the triangle is a parallelogram: outside is also where u + w > 1, not only u > 1 or w > "
     "1",
     1 << DEPTH | 1 << NORMAL, NO_SUM_TEST},
    {"the rays go through the corners of the pixels, half a pixel off: (x + 0.5, y + 0.5) is a "
     "pixel's centre",
     ANY, CORNER},
    {"the rays go through the corners of the pixels, half a pixel off: (x + 0.5, y + 0.5) is a "
     "pixel's centre",
     ANY, CORNER_UPWARDS},
    {"all is one row too low: rows go from 0 to 95", ANY, ROW_LOW},
    {"all is one row too high: rows go from 0 to 95", ANY, ROW_HIGH},
    {"all is one column too far to the left: columns go from 0 to 127", ANY, COLUMN_LEFT},
    {"all is one column too far to the right: columns go from 0 to 127", ANY, COLUMN_RIGHT},
    {"the camera's upward axis is (0, 1, 0) itself: it must stand at right angles to the view, "
     "cross(right, forward)",
     ANY, UP_IS_Y},
    {"the field of view is twice too wide: the picture's upper edge is half the angle up", ANY,
     WIDE_FOV},
    {"the field of view is taken for the picture's width: it is that of its height", ANY,
     HALF_FOV},
    {"squeezed: the width of a pixel is not its height", ANY, NO_ASPECT},
    {"the depth along the view's axis: the distance from the eye is asked for", 1 << DEPTH,
     ALONG_VIEW},
    {"normals that are not turned to the side of the eye", 1 << NORMAL, OUTWARD},
    {"all normals point away from the eye", 1 << NORMAL, AWAY},
    {"the normals are in the camera's coordinates, not in the scene's", 1 << NORMAL, INTO_VIEW},
    {"the normals are coded as 0.5 n + 0.5: n itself is asked for", 1 << NORMAL, CODED},
    {"one reflection and no more: what a mirror shows in a mirror is black", 1 << MIRROR,
     ONE_REFLECTION},
    {"no reflection: the mirrors show their own colour", 1 << MIRROR, NO_REFLECTION},
    {"the mirrors' own colour is missing", 1 << MIRROR, NO_TINT},
    {"the colour of a mirror in a mirror is missing: C is replaced, not multiplied",
     1 << MIRROR, TINT_OF_LAST},
    {"the two colours of the checks are swapped", 1 << MIRROR, CHECKS_SWAPPED},
    {"the checks are wrong where x or z is negative: floor rounds down, (int) does not",
     1 << MIRROR, CHECKS_TRUNCATED},
    {"the checks are wrong where x or z is negative: -1 % 2 is -1, not 1", 1 << MIRROR,
     CHECKS_REMAINDER},
    {"the two colours of the checks are swapped, and -1 % 2 is -1, not 1", 1 << MIRROR,
     CHECKS_REMAINDER_SWAPPED},
    {"the sky takes d.y without making d a unit vector, or upside down", 1 << MIRROR,
     SKY_UPWARDS},
    {"the reflected direction is d + 2 (n·d) n: the sign is wrong, d - 2 (n·d) n mirrors",
     1 << MIRROR, REFLECT_PLUS},
    {"the reflected direction is 2 (n·d) n - d, which points into the mirror: d - 2 (n·d) n",
     1 << MIRROR, REFLECT_NEGATED},
};
const int mistake_count = COUNT(mistakes);

// ---- the scenes ----------------------------------------------------------------------

typedef struct {
    const char *name;
    enum { FLOOR, BALL, THREE } kind;
    wide3 p, q, r; // BALL: centre; THREE: corners
    double radius;
    bool mirror;
    double color[CHANNELS];
} thing;

static const thing shapes[] = {
    {.name = "the floor", .kind = FLOOR},
    {.name = "the sphere of radius 0.45", .kind = BALL, .p = {0.45, 0.5, 0.9}, .radius = 0.45},
    {.name = "the sphere of radius 0.9", .kind = BALL, .p = {-0.8, 0.9, -0.4}, .radius = 0.9},
    {.name = "the sphere behind the eye", .kind = BALL, .p = {2.5, 2.2, 8}, .radius = 1.2},
    {"the triangle",
     THREE,
     {0.3, 0.2, -1.2},
     {1.1, 2.3, -1.9},
     {2.4, 0.5, -1.6},
     0,
     false,
     {0}},
};
static const thing balls[] = {
    {.name = "the floor", .kind = FLOOR},
    {.name = "the large mirror",
     .kind = BALL,
     .p = {-1.05, 1, -0.3},
     .radius = 1,
     .mirror = true,
     .color = {0.9, 0.9, 0.9}},
    {.name = "the golden mirror",
     .kind = BALL,
     .p = {0.95, 0.7, 0.4},
     .radius = 0.7,
     .mirror = true,
     .color = {0.95, 0.75, 0.4}},
    {.name = "the red ball",
     .kind = BALL,
     .p = {0.1, 0.3, 1.3},
     .radius = 0.3,
     .color = {0.8, 0.15, 0.1}},
};
static const struct {
    const thing *things;
    int count;
    wide3 eye, target;
    double fov;
} views[] = {
    [DEPTH] = {shapes, COUNT(shapes), {1.2, 1.7, 4.1}, {-0.1, 0.6, 0}, 50},
    [NORMAL] = {shapes, COUNT(shapes), {1.2, 1.7, 4.1}, {-0.1, 0.6, 0}, 50},
    [MIRROR] = {balls, COUNT(balls), {0.4, 1.3, 5.2}, {0.1, 0.8, 0}, 42},
};

const char *truth_body(stage s, int body) {
    return body < 0 ? "the background" : views[s].things[body].name;
}

bool truth_is_mirror(stage s, int body) {
    return body >= 0 && views[s].things[body].mirror;
}

// ---- the rays ------------------------------------------------------------------------

typedef struct {
    wide3 O, d;
} line;

static wide3 minus(wide3 a, wide3 b) {
    return wide_along(a, -1, b);
}

typedef struct {
    wide3 right, up, forward;
} axes;

static axes axes_of(stage s) {
    const wide3 forward = wide_unit(minus(views[s].target, views[s].eye));
    const wide3 right = wide_unit(wide_cross(forward, (wide3){0, 1, 0}));
    return (axes){right, wide_cross(right, forward), forward};
}

// How far the picture is moved, in pixels.
static double shift_right(int wrong) {
    if (wrong == CORNER || wrong == CORNER_UPWARDS) return 0.5;
    return wrong == COLUMN_RIGHT ? 1 : wrong == COLUMN_LEFT ? -1 : 0;
}
static double shift_down(int wrong) {
    if (wrong == CORNER || wrong == CORNER_UPWARDS) return wrong == CORNER ? 0.5 : -0.5;
    return wrong == ROW_LOW ? 1 : wrong == ROW_HIGH ? -1 : 0;
}

static line line_through(stage s, double x, double y, int wrong) {
    const axes a = axes_of(s);
    const double angle = views[s].fov * PI / 180 * (wrong == WIDE_FOV ? 2 : 1);
    const double side = wrong == HALF_FOV ? WIDTH : HEIGHT, half = tan(angle / 2);
    const double right = shift_right(wrong), down = shift_down(wrong);
    const double wide = wrong == NO_ASPECT ? WIDTH : side;
    const double u = (2 * (x - right) - WIDTH) / wide * half,
                 v = (HEIGHT - 2 * (y - down)) / side * half;
    const wide3 up = wrong == UP_IS_Y ? (wide3){0, 1, 0} : a.up;
    const wide3 d = wide_along(wide_along(a.forward, u, a.right), v, up);
    return (line){views[s].eye, wide_unit(d)};
}

static double ball_t(const thing *b, line r, double t_min, int wrong) {
    const wide3 v = minus(r.O, b->p);
    const double half_b = wide_dot(v, r.d);
    const double D = half_b * half_b - wide_dot(v, v) + b->radius * b->radius;
    if (D < 0) return -1;
    const double near_t = -half_b - sqrt(D), far_t = -half_b + sqrt(D);
    const bool far_alone = wrong == FAR_ROOT || wrong == FAR_ROOT_OUTWARD;
    return near_t > t_min && !far_alone ? near_t : far_t;
}

// q = p + u (q - p) + w (r - p) with u > 1 or w > 1?
static bool beyond_parallelogram(wide3 point, const thing *T) {
    const wide3 a = minus(T->q, T->p), b = minus(T->r, T->p), s = minus(point, T->p);
    const double aa = wide_dot(a, a), ab = wide_dot(a, b), bb = wide_dot(b, b);
    const double as = wide_dot(a, s), bs = wide_dot(b, s), whole = aa * bb - ab * ab;
    return as * bb - bs * ab > whole || bs * aa - as * ab > whole;
}

static double three_t(const thing *T, line r, int wrong) {
    const wide3 n = wide_cross(minus(T->q, T->p), minus(T->r, T->p));
    const double t = wide_dot(minus(T->p, r.O), n) / wide_dot(r.d, n);
    const wide3 q = wide_along(r.O, t, r.d), corners[] = {T->p, T->q, T->r};
    if (wrong == NO_INSIDE_TEST) return t;
    for (int i = 0; i < 3; i++) {
        const wide3 a = corners[i], b = corners[(i + 1) % 3];
        if (wrong == NO_SUM_TEST && i == 1) continue;
        if (wide_dot(wide_cross(minus(b, a), minus(q, a)), n) < 0) return -1;
    }
    if (wrong == NO_SUM_TEST && beyond_parallelogram(q, T)) return -1;
    return t;
}

static double thing_t(const thing *b, line r, double t_min, int wrong) {
    if (b->kind == FLOOR) return -r.O.y / r.d.y;
    return b->kind == BALL ? ball_t(b, r, t_min, wrong) : three_t(b, r, wrong);
}

static wide3 normal_at(const thing *b, wide3 p) {
    if (b->kind == FLOOR) return (wide3){0, 1, 0};
    if (b->kind == BALL) return wide_unit(minus(p, b->p));
    return wide_unit(wide_cross(minus(b->q, b->p), minus(b->r, b->p)));
}

// Which body the ray meets and where; -1: none.
static int meet(stage s, line r, int skip, int wrong, double *t) {
    int body = -1;
    *t = INFINITY;
    for (int i = 0; i < views[s].count; i++) {
        const thing *b = &views[s].things[i];
        if (i == skip && b->kind != BALL) continue;
        const double t_min = i == skip ? 1e-6 : 0;
        double now = thing_t(b, r, t_min, wrong);
        if (wrong == BEHIND && skip < 0 && now == -1) continue;
        if (wrong == BEHIND && skip < 0) now = fabs(now);
        const bool last = wrong == LAST_BODY || (wrong == LAST_SPHERE && b->kind == BALL);
        if (!(now > t_min) || (now >= *t && !last)) continue;
        *t = now, body = i;
    }
    return body;
}

// ---- what is seen --------------------------------------------------------------------

static void put(seen *s, wide3 v) {
    s->value[0] = v.x, s->value[1] = v.y, s->value[2] = v.z;
}

static wide3 shown_normal(const thing *b, wide3 n, line r, const axes *a, int wrong) {
    const bool outward = wrong == OUTWARD || (wrong == FAR_ROOT_OUTWARD && b->kind == BALL);
    if (!outward && (wide_dot(n, r.d) > 0) != (wrong == AWAY)) n = minus((wide3){0}, n);
    if (wrong == INTO_VIEW)
        n = (wide3){wide_dot(n, a->right), wide_dot(n, a->up), -wide_dot(n, a->forward)};
    if (wrong == CODED) n = (wide3){(n.x + 1) / 2, (n.y + 1) / 2, (n.z + 1) / 2};
    return n;
}

static seen first_hit(stage s, line r, int wrong) {
    double t;
    seen got = {.body = meet(s, r, -1, wrong, &t)};
    got.history = (uint64_t)(got.body + 1);
    if (got.body < 0) return got;
    const axes a = axes_of(s);
    const thing *b = &views[s].things[got.body];
    const wide3 p = wide_along(r.O, t, r.d);
    if (s == NORMAL) {
        put(&got, shown_normal(b, normal_at(b, p), r, &a, wrong));
        return got;
    }
    if (wrong == ALONG_VIEW) t *= wide_dot(r.d, a.forward);
    put(&got, (wide3){t, t, t});
    return got;
}

static bool odd_check(wide3 p, int wrong) {
    if (wrong == CHECKS_TRUNCATED) return ((long)p.x + (long)p.z) % 2 != 0;
    const long sum = (long)(floor(p.x) + floor(p.z));
    if (wrong == CHECKS_REMAINDER) return sum % 2 == 1;
    if (wrong == CHECKS_REMAINDER_SWAPPED) return sum % 2 != 1;
    const bool odd = sum % 2 != 0;
    return odd != (wrong == CHECKS_SWAPPED);
}

static void sky(wide3 d, int wrong, double light[CHANNELS]) {
    static const double above[] = {0.25, 0.45, 0.9};
    const double up = wrong == SKY_UPWARDS ? (d.y + 1) / 2 : d.y > 0 ? d.y : 0;
    for (int c = 0; c < CHANNELS; c++) light[c] = 1 + up * (above[c] - 1);
}

static wide3 reflected(const thing *b, wide3 p, wide3 d, int wrong) {
    const wide3 n = normal_at(b, p);
    const wide3 v = wide_along(d, (wrong == REFLECT_PLUS ? 2 : -2) * wide_dot(d, n), n);
    return wide_unit(wrong == REFLECT_NEGATED ? minus((wide3){0}, v) : v);
}

static seen mirror_path(line r, int wrong) {
    static const double even[] = {0.9, 0.85, 0.7}, odd[] = {0.15, 0.2, 0.3};
    seen got = {.value = {1, 1, 1}, .body = -1};
    double light[CHANNELS] = {0};
    for (int bounce = 0, body = -1; bounce < 60; bounce++) {
        double t;
        body = meet(MIRROR, r, body, wrong, &t);
        if (bounce == 0) got.body = body;
        got.history = got.history * 7 + (uint64_t)(body + 1);
        if (body < 0) {
            sky(r.d, wrong, light);
            break;
        }
        const thing *b = &balls[body];
        const wide3 p = wide_along(r.O, t, r.d);
        if (b->kind == FLOOR) {
            got.history = got.history * 7 + odd_check(p, NONE);
            memcpy(light, odd_check(p, wrong) ? odd : even, sizeof light);
            break;
        }
        memcpy(light, b->color, sizeof light);
        if (!b->mirror || wrong == NO_REFLECTION) break;
        for (int c = 0; c < CHANNELS && wrong != NO_TINT; c++)
            got.value[c] = wrong == TINT_OF_LAST ? b->color[c] : got.value[c] * b->color[c];
        memset(light, 0, sizeof light);
        if (wrong == ONE_REFLECTION && bounce == 1) break;
        r = (line){p, reflected(b, p, r.d, wrong)};
    }
    for (int c = 0; c < CHANNELS; c++) got.value[c] *= light[c];
    return got;
}

seen truth_seen(stage s, double x, double y, int mistake_id) {
    const line r = line_through(s, x, y, mistake_id);
    return s == MIRROR ? mirror_path(r, mistake_id) : first_hit(s, r, mistake_id);
}
