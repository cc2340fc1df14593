// measure.c: the k-d tree beside the BVH: steps, tests, memory, time to build and to ask; the
// bonus, clipping and mailboxes.
#include <stdlib.h>
#include <string.h>

#include "chapters/06-bounce/bounce.h"
#include "chapters/12-bvh/shapes.h"
#include "chapters/13-kd-tree/kd_leaf.h"
#include "chapters/13-kd-tree/searcher.h"
#include "common/measure.h"

enum { RAYS = 4096, ROUNDS = 5 };

static bool errors_only(void) {
    const char *set = getenv("ERRORS_ONLY");
    return set && *set;
}

static mesh (*const scenes[])(long) = {shape_knot, shape_cloud, shape_stadium, shape_cave};

static const shape *shape_of(mesh (*make)(long)) {
    const shape *s = shapes;
    while (s->make != make) s++;
    return s;
}

// ---- rays --------------------------------------------------------------------------------

typedef struct {
    ray rays[RAYS];
    const searcher *by;
    const void *tree;
} work;

// Half of them from the eye, half from what these meet, in a random direction.
static void fill(work *w, const shape *s, const mesh *m) {
    rng g = rng_seed(13, 1);
    const camera cam = camera_look_at(s->eye, s->target, (vec3){0, 1, 0}, 40, 100, 100);
    for (int i = 0; i < RAYS; i += 2) {
        const real x = 100 * rng_real(&g), y = 100 * rng_real(&g);
        const ray r = camera_ray(&cam, x, y);
        const vec3 d = unit_vector(&g);
        int index = 0;
        const triangle_point q = w->by->nearest(w->tree, r, 0, NO_HIT, &index, NULL);
        w->rays[i] = w->rays[i + 1] = r;
        if (q.t == NO_HIT) continue;
        const hit h = triangle_surface(mesh_triangle(m, index), r, q);
        const vec3 n = h.front ? h.n : neg(h.n), out = dot(d, n) < 0 ? neg(d) : d;
        w->rays[i + 1] = (ray){offset_origin(h.p, h.error, n, n), out};
    }
}

static effort effort_of(const work *w) {
    effort spent = {0, 0};
    int index = 0;
    for (int i = 0; i < RAYS; i++)
        w->by->nearest(w->tree, w->rays[i], 0, NO_HIT, &index, &spent);
    return spent;
}

static void ask(const work *w) {
    int index = 0;
    double sum = 0;
    for (int i = 0; i < RAYS; i++)
        sum += (double)w->by->nearest(w->tree, w->rays[i], 0, 1000, &index, NULL).u;
    keep(sum);
}

// Two that are compared take turns.
static void run_first(void *two) {
    ask(two);
}
static void run_second(void *two) {
    ask((work *)two + 1);
}

static void times_of(work two[2], double ns[2]) {
    const timed turns[] = {{two[0].by->name, run_first}, {two[1].by->name, run_second}};
    measure_ns(turns, 2, two, RAYS, ROUNDS, ns);
}

// ---- BVH and k-d tree --------------------------------------------------------------------

static double build_ns(const searcher *by, const mesh *m, void **tree) {
    const double start = clock_seconds();
    *tree = by->build(m);
    return errors_only() ? 0 : 1e9 * (clock_seconds() - start) / m->count;
}

static void compare_row(const work *w, const shape *s, int count, long wanted, double building,
                        double ns) {
    const double n = (double)wanted;
    const effort e = effort_of(w);
    char table[80];
    snprintf(table, sizeof table, "steps: %s", s->name);
    csv_row(table, w->by->name, "triangles", n, "steps per ray", (double)e.steps / RAYS, "ns",
            ns);
    snprintf(table, sizeof table, "tests: %s", s->name);
    csv_row(table, w->by->name, "triangles", n, "tests per ray", (double)e.tests / RAYS, "ns",
            NAN);
    snprintf(table, sizeof table, "memory: %s", s->name);
    csv_row(table, w->by->name, "triangles", n, "bytes per triangle",
            (double)w->by->bytes(w->tree) / count, "build, ns per triangle", building);
}

// x is how many triangles were wanted. The same rays for all; the first one's hits decide
// where they go on.
static void compare_on(const shape *s, const mesh *m, long wanted) {
    static const searcher *const all[] = {&by_bvh_sah, &by_kd_tree};
    static work two[2];
    void *trees[2];
    double building[2], ns[2];
    for (int b = 0; b < 2; b++) {
        building[b] = build_ns(all[b], m, &trees[b]);
        two[b].by = all[b], two[b].tree = trees[b];
    }
    fill(&two[0], s, m);
    memcpy(two[1].rays, two[0].rays, sizeof two[1].rays);
    times_of(two, ns);
    for (int b = 0; b < 2; b++) {
        compare_row(&two[b], s, m->count, wanted, building[b], ns[b]);
        all[b]->free(trees[b]);
    }
}

static void compare(void) {
    static const long sizes[] = {100, 1000, 10000, 100000, 300000};
    const int count = errors_only() ? 3 : COUNT(sizes);
    for (int k = 0; k < COUNT(scenes); k++)
        for (int i = 0; i < count; i++) {
            const shape *s = shape_of(scenes[k]);
            mesh m = s->make(sizes[i]);
            compare_on(s, &m, sizes[i]);
            mesh_free(&m);
        }
}

// ---- options of the build ----------------------------------------------------------------

typedef triangle_point nearest_function(const void *tree, ray r, real t_min, real t_max,
                                        int *index, effort *spent);
static nearest_function plain, mailed;

static triangle_point plain(const void *tree, ray r, real t_min, real t_max, int *index,
                            effort *spent) {
    return kd_nearest(tree, r, t_min, t_max, index, spent);
}

typedef struct {
    const char *name;
    kd_options how;
    nearest_function *nearest;
} variant;

static void option_rows(const work *w, const kd_tree *k, const char *about, const char *x_name,
                        double x, double ns) {
    const effort e = effort_of(w);
    const char *name = w->by->name;
    char table[80];
    snprintf(table, sizeof table, "%s: steps", about);
    csv_row(table, name, x_name, x, "steps per ray", (double)e.steps / RAYS, "ns", ns);
    snprintf(table, sizeof table, "%s: tests", about);
    csv_row(table, name, x_name, x, "tests per ray", (double)e.tests / RAYS, "ns", NAN);
    snprintf(table, sizeof table, "%s: references", about);
    csv_row(table, name, x_name, x, "references per triangle", (double)k->list_count / k->count,
            "bytes", (double)kd_measure(k).bytes);
}

static void compare_two(const char *about, const shape *s, long wanted, const variant v[2]) {
    static work two[2];
    searcher by[2] = {{0}, {0}};
    kd_tree k[2];
    double ns[2];
    mesh m = s->make(wanted);
    for (int i = 0; i < 2; i++) {
        k[i] = kd_build(&m, v[i].how);
        by[i].name = v[i].name, by[i].nearest = v[i].nearest;
        two[i].by = &by[i], two[i].tree = &k[i];
        fill(&two[i], s, &m);
    }
    times_of(two, ns);
    for (int i = 0; i < 2; i++) {
        option_rows(&two[i], &k[i], about, "triangles", (double)wanted, ns[i]);
        kd_free(&k[i]);
    }
    mesh_free(&m);
}

static void bonus_rows(const shape *s, const mesh *m, double bonus) {
    static work w;
    const searcher by = {.name = s->name, .nearest = plain};
    kd_options how = kd_defaults;
    how.bonus = (real)bonus;
    kd_tree k = kd_build(m, how);
    w.by = &by, w.tree = &k;
    fill(&w, s, m);
    option_rows(&w, &k, "bonus", "bonus", bonus, NAN);
    kd_free(&k);
}

static void measure_bonus(void) {
    for (int k = 0; k < COUNT(scenes); k++) {
        const shape *s = shape_of(scenes[k]);
        mesh m = s->make(10000);
        for (int i = 0; i <= 8; i += 2) bonus_rows(s, &m, i / 10.0);
        mesh_free(&m);
    }
}

static const long few[] = {100, 1000, 10000};

static void measure_clip(void) {
    variant v[] = {{"clipped", kd_defaults, plain},
                   {"box cut at the plane", kd_defaults, plain}};
    v[1].how.clip = false;
    for (int i = 0; i < COUNT(few); i++) compare_two("clip", shape_of(shape_knot), few[i], v);
}

// ---- mailboxes -----------------------------------------------------------------------------

// The last triangles that a ray has tested. In the ray, not in the triangles: threads share
// these.
enum { BOXES = 8 };
typedef struct {
    uint32_t last[BOXES];
} mailbox;

// Has it been tested just now? Notes it.
static bool tested(mailbox *b, uint32_t j) {
    uint32_t *box = &b->last[j % BOXES];
    if (*box == j) return true;
    *box = j;
    return false;
}

static void mailed_leaf(const kd_tree *k, kd_node leaf, ray r, real t_min, bvh_found *found,
                        mailbox *b, effort *spent) {
    for (uint32_t i = leaf.first; i < leaf.first + kd_number(leaf); i++) {
        const uint32_t j = k->lists[i];
        if (tested(b, j)) continue;
        const kd_node one = {.first = i, .packed = KD_LEAF | 1 << 2};
        kd_leaf_nearest(k, one, r, t_min, found, spent);
    }
}

typedef struct {
    uint32_t node;
    span in;
} waiting;

// kd_nearest's walk with a mailbox.
static triangle_point mailed(const void *tree, ray r, real t_min, real t_max, int *index,
                             effort *spent) {
    const kd_tree *k = tree;
    const kd_ray q = kd_ray_of(r);
    bvh_found found = bvh_nothing_found(t_max);
    mailbox box;
    for (int i = 0; i < BOXES; i++) box.last[i] = UINT32_MAX;
    waiting stack[KD_DEPTH + 1];
    int top = 1;
    stack[0].node = 0;
    if (spent) spent->steps++;
    if (!kd_enter(k, &q, t_min, t_max, &stack[0].in)) return found.best;
    while (top > 0) {
        const waiting now = stack[--top];
        const kd_node n = k->nodes[now.node];
        const uint32_t axis = kd_kind(n);
        if (now.in.t0 > now.in.t1 || now.in.t0 > found.limit) continue;
        if (axis == KD_LEAF) {
            mailed_leaf(k, n, r, t_min, &found, &box, spent);
            continue;
        }
        if (spent) spent->steps++;
        const kd_order o = kd_children(n.split, q.O[axis], q.inverse[axis], now.in);
        stack[top++] = (waiting){o.first ? now.node + 1 : kd_number(n), o.far};
        stack[top++] = (waiting){o.first ? kd_number(n) : now.node + 1, o.near};
    }
    if (found.best.t != NO_HIT) *index = found.index;
    return found.best;
}

static void measure_mailbox(void) {
    const variant v[] = {{"none", kd_defaults, plain},
                         {"eight in the ray", kd_defaults, mailed}};
    for (int i = 0; i < COUNT(few); i++)
        compare_two("mailbox", shape_of(shape_knot), few[i], v);
}

int main(void) {
    if (errors_only() && sizeof(real) > sizeof(float))
        return 0; // the counts are nearly the same
    compare();
    measure_bonus();
    measure_clip();
    measure_mailbox();
}
