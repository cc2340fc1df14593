// slabs.h: what measure.c needs of slab tests: variants, and what each misses.
#ifndef CHAPTER_SLABS_H
#define CHAPTER_SLABS_H

#include "chapters/12-bvh/aabb.h"
#include "common/exact3.h"
#include "common/measure.h"

// ---- slab tests: the variants ----------------------------------------------------------

typedef bool slab_test(const aabb *box, const slab_ray *r, real t_min, real t_max, real *enter);

// As one writes it first: two quotients, exchanged when they are in the wrong order.
static bool divide_and_swap(const aabb *box, const slab_ray *r, real t_min, real t_max,
                            real *enter) {
    for (int axis = 0; axis < 3; axis++) {
        const real O = along(r->O, axis), d = along(r->d, axis);
        real near = (along(box->min, axis) - O) / d, far = (along(box->max, axis) - O) / d;
        if (near > far) {
            const real t = near;
            near = far;
            far = t;
        }
        if (near > t_min) t_min = near;
        if (far < t_max) t_max = far;
    }
    *enter = t_min;
    return t_min <= t_max;
}

// The same without branches, by 1/d.
static bool min_and_max(const aabb *box, const slab_ray *r, real t_min, real t_max,
                        real *enter) {
    const vec3 a = mul(sub(box->min, r->O), r->inverse),
               b = mul(sub(box->max, r->O), r->inverse);
    const aabb t = {{lesser(a.x, b.x), lesser(a.y, b.y), lesser(a.z, b.z)},
                    {greater(a.x, b.x), greater(a.y, b.y), greater(a.z, b.z)}};
    *enter = greater(t.min.z, greater(t.min.y, greater(t.min.x, t_min)));
    return *enter <= lesser(t.max.z, lesser(t.max.y, lesser(t.max.x, t_max)));
}

// Near and far faces by the signs of d; what was known stays when a NaN comes.
static real by_signs(const aabb *box, const slab_ray *r, real t_min, real t_max, real *enter) {
    const real *side = &box->min.x;
    real t[6];
    for (int axis = 0; axis < 3; axis++) {
        const real O = along(r->O, axis), inverse = along(r->inverse, axis);
        t[axis] = (side[r->near[axis]] - O) * inverse;
        t[3 + axis] = (side[r->far[axis]] - O) * inverse;
    }
    *enter = greater(t[2], greater(t[1], greater(t[0], t_min)));
    return lesser(t[5], lesser(t[4], lesser(t[3], t_max)));
}

static bool by_sign(const aabb *box, const slab_ray *r, real t_min, real t_max, real *enter) {
    return by_signs(box, r, t_min, t_max, enter) >= *enter;
}

// The exit moved outwards, as by Ize: not t_max.
static bool by_sign_exit(const aabb *box, const slab_ray *r, real t_min, real t_max,
                         real *enter) {
    const real exit = by_signs(box, r, t_min, INFINITY, enter) * (1 + 2 * rounding_bound(3));
    return lesser(exit, t_max) >= *enter;
}

static bool by_sign_both(const aabb *box, const slab_ray *r, real t_min, real t_max,
                         real *enter) {
    const real exit = by_signs(box, r, t_min, t_max, enter) * (1 + 2 * rounding_bound(3));
    *enter *= 1 - 2 * rounding_bound(3);
    return exit >= *enter;
}

static bool strictly(const aabb *box, const slab_ray *r, real t_min, real t_max, real *enter) {
    return by_signs(box, r, t_min, t_max, enter) > *enter;
}

static const struct {
    const char *name;
    slab_test *test;
} slabs[] = {{"divide and swap", divide_and_swap},    {"min and max", min_and_max},
             {"by sign, strictly less", strictly},    {"by sign", by_sign},
             {"by sign, exit widened", by_sign_exit}, {"by sign, both widened", by_sign_both},
             {"product and sum (aabb_hit)", aabb_hit}};

// ---- slab tests: the cases -------------------------------------------------------------

typedef struct {
    aabb box;
    slab_ray r;
    real t_max;
} slab_case;

static void set_along(vec3 *v, int axis, real x) {
    *(axis == 0 ? &v->x : axis == 1 ? &v->y : &v->z) = x;
}

static real either(rng *g, real a, real b) {
    return rng_real(g) < (real)0.5 ? a : b;
}

static vec3 inner_point(aabb box, rng *g) {
    const real x = rng_real(g), y = rng_real(g), z = rng_real(g);
    return add(box.min, mul((vec3){x, y, z}, sub(box.max, box.min)));
}

static aabb random_box(rng *g) {
    const vec3 p = in_cube(g);
    return aabb_with((aabb){p, p}, in_cube(g));
}

// The point p, moved into a face of the box along `axes` axes: a face, an edge, a corner.
static vec3 onto(aabb box, vec3 p, int axes, rng *g) {
    const int first = (int)(3 * rng_real(g));
    for (int i = first; i < first + axes; i++)
        set_along(&p, i % 3, either(g, along(box.min, i % 3), along(box.max, i % 3)));
    return p;
}

static slab_case aimed(aabb box, vec3 target, rng *g) {
    const vec3 O = scale(3, in_cube(g));
    const real stretch =
        (real)0.5 + rng_real(g); // the target is not at t = 1, without rounding
    return (slab_case){box, slab_ray_of((ray){O, scale(stretch, sub(target, O))}), INFINITY};
}

// In `axes` planes of faces at once, along them, and towards the box.
static slab_case in_faces(aabb box, int axes, rng *g) {
    const vec3 target = inner_point(box, g);
    vec3 O = scale(3, in_cube(g)), d = sub(target, O);
    const int first = (int)(3 * rng_real(g));
    for (int i = first; i < first + axes; i++) {
        set_along(&O, i % 3, either(g, along(box.min, i % 3), along(box.max, i % 3)));
        set_along(&d, i % 3, either(g, 0, -(real)0));
    }
    return (slab_case){box, slab_ray_of((ray){O, d}), INFINITY};
}

enum {
    GENERIC = 1,
    IN_A_FACE,
    ALONG_AN_EDGE,
    AT_EDGES,
    AT_CORNERS,
    FLAT,
    FLAT_AND_LAST,
    SLAB_KINDS
};

// A flat box that the ray crosses, with t_max the first number that is not before it.
static void end_there(slab_case *c, int axis) {
    const exact t =
        ((exact)along(c->box.min, axis) - along(c->r.O, axis)) / along(c->r.d, axis);
    c->t_max = (real)t;
    if (c->t_max < t) c->t_max = nextafter(c->t_max, (real)INFINITY);
}

static slab_case slab_case_of(int kind, rng *g) {
    aabb box = random_box(g);
    if (kind == IN_A_FACE || kind == ALONG_AN_EDGE) return in_faces(box, kind - GENERIC, g);
    if (kind == AT_EDGES || kind == AT_CORNERS)
        return aimed(box, onto(box, inner_point(box, g), kind - ALONG_AN_EDGE + 1, g), g);
    if (kind == GENERIC) return aimed(box, in_cube(g), g);
    const int axis = (int)(3 * rng_real(g));
    set_along(&box.max, axis, along(box.min, axis));
    slab_case c = aimed(box, inner_point(box, g), g);
    if (kind == FLAT_AND_LAST) end_there(&c, axis);
    return c;
}

// In 113 bits.
static bool exactly_hit(const slab_case *c) {
    exact t_min = 0, t_max = c->t_max < 1e30 ? c->t_max : 1e30;
    for (int axis = 0; axis < 3; axis++) {
        const exact O = along(c->r.O, axis), d = along(c->r.d, axis);
        const exact a = along(c->box.min, axis) - O, b = along(c->box.max, axis) - O;
        if (d == 0 && (a > 0 || b < 0)) return false;
        if (d == 0) continue;
        const exact near = d > 0 ? a / d : b / d, far = d > 0 ? b / d : a / d;
        if (near > t_min) t_min = near;
        if (far < t_max) t_max = far;
    }
    return t_min <= t_max;
}

enum { SLAB_CASES = 40000, SLAB_TIMED = 4096 };

static void slab_errors(int kind) {
    int hits = 0, missed[COUNT(slabs)] = {0};
    rng g = rng_seed(12, (uint64_t)kind);
    for (int i = 0; i < SLAB_CASES; i++) {
        const slab_case c = slab_case_of(kind, &g);
        const bool truth = exactly_hit(&c);
        hits += truth;
        for (int v = 0; v < COUNT(slabs); v++) {
            real enter;
            missed[v] += truth && !slabs[v].test(&c.box, &c.r, 0, c.t_max, &enter);
        }
    }
    for (int v = 0; v < COUNT(slabs); v++)
        csv_row("slab: missed", slabs[v].name, "case", kind, "share of hits missed",
                (double)missed[v] / hits, "ns", NAN);
}

typedef struct {
    slab_case c[SLAB_TIMED];
} slab_cases;

#define TIMED_SLAB(f)                                                            \
    static void run_##f(void *data) {                                            \
        const slab_cases *s = data;                                              \
        real sum = 0, enter;                                                     \
        for (int i = 0; i < SLAB_TIMED; i++)                                     \
            sum += f(&s->c[i].box, &s->c[i].r, 0, INFINITY, &enter) ? enter : 1; \
        keep(sum);                                                               \
    }
TIMED_SLAB(divide_and_swap)
TIMED_SLAB(min_and_max)
TIMED_SLAB(strictly)
TIMED_SLAB(by_sign)
TIMED_SLAB(by_sign_exit)
TIMED_SLAB(by_sign_both)
TIMED_SLAB(aabb_hit)

static void measure_slabs(void) {
    static const timed runs[] = {{"", run_divide_and_swap}, {"", run_min_and_max},
                                 {"", run_strictly},        {"", run_by_sign},
                                 {"", run_by_sign_exit},    {"", run_by_sign_both},
                                 {"", run_aabb_hit}};
    _Static_assert(COUNT(runs) == COUNT(slabs), "every variant is timed");
    static slab_cases s;
    double ns[COUNT(slabs)];
    rng g = rng_seed(12, 99);
    for (int kind = GENERIC; kind < SLAB_KINDS; kind++) slab_errors(kind);
    for (int i = 0; i < SLAB_TIMED; i++) s.c[i] = slab_case_of(GENERIC, &g);
    measure_ns(runs, COUNT(runs), &s, SLAB_TIMED, 9, ns);
    for (int v = 0; v < COUNT(slabs); v++)
        csv_row("slab: cost", slabs[v].name, "calls", SLAB_TIMED, "not measured", NAN, "ns",
                ns[v]);
}

#endif
