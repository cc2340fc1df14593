// 12-bvh-build.h: the part of 12-bvh.c about dividing, building, refitting and inspecting.
#ifndef TESTS_12_BVH_BUILD_H
#define TESTS_12_BVH_BUILD_H

#include <stdlib.h>

#include "tests/12-bvh-walk.h"

// ---- items -----------------------------------------------------------------------------

typedef real made_centre(int i, int count, rng *g);

static real in_no_order(int i, int count, rng *g) {
    (void)i, (void)count;
    return 2 * rng_real(g) - 1;
}
static real all_equal(int i, int count, rng *g) {
    (void)i, (void)count, (void)g;
    return (real)0.375;
}
static real upwards(int i, int count, rng *g) {
    (void)count, (void)g;
    return (real)i / 4;
}
static real downwards(int i, int count, rng *g) {
    (void)g;
    return (real)(count - i) / 4;
}
static real organ_pipes(int i, int count, rng *g) {
    (void)g;
    return (real)(i < count / 2 ? i : count - i) / 4;
}
static real valley(int i, int count, rng *g) {
    return -organ_pipes(i, count, g);
}
static real two_values(int i, int count, rng *g) {
    (void)i, (void)count;
    return (real)(rng_bits(g) % 2);
}
static real one_larger(int i, int count, rng *g) {
    (void)g;
    return i == count / 3 ? 2 : 1;
}
static real saw(int i, int count, rng *g) {
    (void)count, (void)g;
    return (real)(i % 1000);
}
static real powers(int i, int count, rng *g) {
    (void)count, (void)g;
    return (real)ldexp(1, i * 37 % 250 - 125);
}

static const struct {
    const char *name;
    made_centre *make;
} orders[] = {
    {"in no order", in_no_order}, {"all equal", all_equal},     {"upwards", upwards},
    {"downwards", downwards},     {"organ pipes", organ_pipes}, {"a valley", valley},
    {"two values", two_values},   {"one larger", one_larger},   {"a saw", saw},
    {"powers of two", powers},
};

// Boxes whose centres along `axis` are as asked; along the others they are something else.
static bvh_item *items_of(int count, int axis, made_centre *make, rng *g) {
    bvh_item *items = mesh_room(count, sizeof *items);
    for (int i = 0; i < count; i++) {
        const real c = make(i, count, g);
        real at[3] = {rng_real(g), rng_real(g), rng_real(g)};
        at[axis] = c;
        const vec3 p = {at[0], at[1], at[2]}, half = {1, 2, (real)0.5};
        items[i] = (bvh_item){{sub(p, half), add(p, half)}, i};
        if (make == powers) items[i].box = (aabb){p, p};
    }
    return items;
}

// Is every item still there, once, as it was?
static bool same_items(const bvh_item *before, const bvh_item *after, int count) {
    char *seen = mesh_room(count, 1);
    bool same = true;
    for (int i = 0; i < count && same; i++) {
        const int k = after[i].triangle;
        same = k >= 0 && k < count && !seen[k] && !memcmp(&before[k], &after[i], sizeof *after);
        if (same) seen[k] = 1;
    }
    free(seen);
    return same;
}

static real centre_of(const bvh_item *item, int axis) {
    return along(aabb_centre(item->box), axis);
}

typedef struct {
    real low, high;
} bounds12;

static bounds12 bounds_of(const bvh_item *items, int from, int to, int axis) {
    bounds12 b = {INFINITY, -INFINITY};
    for (int i = from; i < to; i++) {
        b.low = lesser(b.low, centre_of(&items[i], axis));
        b.high = greater(b.high, centre_of(&items[i], axis));
    }
    return b;
}

// ---- split_median ------------------------------------------------------------------------

static void check_median(int count, int axis, int order, rng *g) {
    bvh_item *before = items_of(count, axis, orders[order].make, g);
    bvh_item *after = mesh_room(count, sizeof *after);
    memcpy(after, before, (size_t)count * sizeof *after);
    given("%d items, centres along axis %d %s", count, axis, orders[order].name);
    split_median(after, count, axis);
    CHECK(same_items(before, after, count), "every item is there once, as it was");
    const bounds12 low = bounds_of(after, 0, count / 2, axis),
                   high = bounds_of(after, count / 2, count, axis);
    given("%d items, centres along axis %d %s\nthe first %d reach up to %.9g, the others down "
          "to %.9g",
          count, axis, orders[order].name, count / 2, (double)low.high, (double)high.low);
    CHECK(low.high <= high.low, "no centre of the first count / 2 lies above one of the rest");
    free(before);
    free(after);
}

static void median_small(void) {
    rng g = check_rng(1250);
    for (int count = 2; count <= 40; count++)
        for (int k = 0; k < 30; k++) check_median(count, k % 3, k % COUNT(orders), &g);
}

static void median_large(void) {
    rng g = check_rng(1251);
    for (int k = 0; k < COUNT(orders); k++) check_median(200000, k % 3, k, &g);
}

// ---- split_at ------------------------------------------------------------------------------

static void check_split_at(int count, int axis, int order, real middle, rng *g) {
    bvh_item *before = items_of(count, axis, orders[order].make, g);
    bvh_item *after = mesh_room(count, sizeof *after);
    memcpy(after, before, (size_t)count * sizeof *after);
    int below = 0;
    for (int i = 0; i < count; i++) below += centre_of(&before[i], axis) < middle;
    const int left = split_at(after, count, axis, middle);
    given("%d items, centres along axis %d %s; middle = %.9g, and %d of them are below", count,
          axis, orders[order].name, (double)middle, below);
    CHECK(same_items(before, after, count), "every item is there once, as it was");
    suspect_value("how many are not below", count - below);
    CHECK_INT(left, below);
    const bounds12 low = bounds_of(after, 0, left, axis),
                   high = bounds_of(after, left, count, axis);
    CHECK(low.high < middle, "the first ones lie below the middle");
    CHECK(high.low >= middle, "the others do not: those at the middle are among them");
    free(before);
    free(after);
}

// At generic places, at a centre itself, below and above all.
static void split_at_small(void) {
    rng g = check_rng(1252);
    for (int count = 1; count <= 40; count++) {
        for (int k = 0; k < 40; k++) {
            const real centres[] = {(real)0.375, 1, 0, (real)0.3, (real)2.5, -1000, 1000};
            check_split_at(count, k % 3, k % COUNT(orders), centres[k % COUNT(centres)], &g);
        }
    }
}

static void split_at_large(void) {
    rng g = check_rng(1253);
    for (int k = 0; k < COUNT(orders); k++) {
        check_split_at(200000, k % 3, k, (real)0.375, &g);
        check_split_at(200000, k % 3, k, 500, &g);
    }
}

// ---- sah_cost ------------------------------------------------------------------------------

static exact exact_area(aabb a) {
    const exact3 e = exact_sub(a.max, a.min);
    return 2 * (e.x * e.y + e.y * e.z + e.z * e.x);
}

static void check_cost(aabb box, int n_l, aabb l, int n_r, aabb r, double want) {
    const double A = (double)exact_area(box), A_l = (double)exact_area(l),
                 A_r = (double)exact_area(r);
    given("box of area %.9g; left %d triangles, area %.9g; right %d, area %.9g", A, n_l, A_l,
          n_r, A_r);
    suspect_value("the counts exchanged: n_l belongs to l",
                  C_STEP + C_HIT * (n_r * A_l + n_l * A_r) / A);
    suspect_value("the slide's c alone: not divided by A", n_l * A_l + n_r * A_r);
    const double hits = C_HIT * (n_l * A_l + n_r * A_r) / A;
    if (hits < 100) { // among more one step is lost
        suspect_value("C_step is missing", hits);
        suspect_value("C_step twice: it is for the pair of boxes", 2 * C_STEP + hits);
    }
    suspect_value("not divided by A", C_STEP + C_HIT * (n_l * A_l + n_r * A_r));
    suspect_value("the areas are missing", C_STEP + C_HIT * (n_l + n_r));
    suspect_value("the counts are missing", C_STEP + C_HIT * (A_l + A_r) / A);
    // Sums of positive terms: lengths, products, areas, counts, the quotient, the sum.
    CHECK_REAL(sah_cost(box, n_l, l, n_r, r), want,
               roundings(24, "positive terms: roundings do not grow"));
}

static void cost_by_hand(void) {
    const aabb box = {{0, 0, 0}, {4, 2, 1}}, l = {{0, 0, 0}, {1, 2, 1}},
               r = {{2, 1, 0}, {4, 2, 1}};
    // A = 28, A_l = 10, A_r = 10: with other counts than areas
    check_cost(box, 3, l, 5, r, 1 + 80.0 / 28);
    const aabb small = {{3, 1, 0}, {4, 2, 1}}; // 6
    check_cost(box, 7, l, 2, small, 1 + 82.0 / 28);
    check_cost(box, 1, small, 9, l, 1 + 96.0 / 28);
    const aabb flat = {{0, 0, 1}, {4, 2, 1}}; // 16: both sides of a sheet
    check_cost(box, 2, flat, 3, l, 1 + 62.0 / 28);
}

static aabb box_inside(aabb box, rng *g) {
    const vec3 e = sub(box.max, box.min);
    const vec3 a = {rng_real(g), rng_real(g), rng_real(g)};
    const vec3 b = {rng_real(g), rng_real(g), rng_real(g)};
    const vec3 p = add(box.min, mul(a, e)), q = add(box.min, mul(b, e));
    return aabb_join((aabb){p, p}, (aabb){q, q});
}

static void cost_generic(void) {
    rng g = check_rng(1254);
    for (int i = 0; i < 20000; i++) {
        const real size = (real)pow(10, i % 13 - 6);
        const vec3 p = scale(size, in_cube(&g)), q = scale(size, in_cube(&g));
        const aabb box = aabb_join((aabb){p, p}, (aabb){q, q}), l = box_inside(box, &g),
                   r = box_inside(box, &g);
        const int n_l = (int)whole_between(&g, 1, 100000),
                  n_r = (int)whole_between(&g, 1, 100000);
        const exact hits = n_l * exact_area(l) + n_r * exact_area(r);
        check_cost(box, n_l, l, n_r, r, (double)(C_STEP + C_HIT * hits / exact_area(box)));
    }
}

// ---- builds --------------------------------------------------------------------------------

static bool same_trees(const bvh *a, const bvh *b) {
    const size_t nodes = (size_t)a->node_count * sizeof *a->nodes, count = (size_t)a->count;
    if (a->node_count != b->node_count || a->count != b->count) return false;
    return count == 0 || (!memcmp(a->nodes, b->nodes, nodes) &&
                          !memcmp(a->order, b->order, count * sizeof *a->order) &&
                          !memcmp(a->triangles, b->triangles, count * sizeof *a->triangles));
}

static int finite_count(const mesh *m) {
    int count = 0;
    for (int i = 0; i < m->count; i++) {
        const triangle T = mesh_triangle(m, i);
        count += is_finite(T.p1) && is_finite(T.p2) && is_finite(T.p3);
    }
    return count;
}

static void check_build(const char *name, const mesh *m, bvh_options how) {
    bvh b = bvh_build(m, how), again = bvh_build(m, how);
    const char *flaw = bvh_flaw(&b);
    given("%s: %d triangles; %s, leaves of at most %d, %d bins%s%s", name, m->count,
          rule_names[how.rule], how.leaf_size, how.bins, flaw ? "\nbvh_flaw says: " : "",
          flaw ? flaw : "");
    CHECK(!flaw, "a sound tree");
    CHECK(same_trees(&b, &again), "built twice it is the same, bit for bit");
    CHECK_INT(b.count, finite_count(m));
    const bvh_figures f = bvh_measure(&b);
    CHECK_AT_MOST(f.largest_leaf, how.leaf_size, "leaf_size");
    CHECK_AT_MOST(f.depth, BVH_DEPTH, "BVH_DEPTH");
    CHECK_INT(b.node_count, b.count ? 2 * f.leaves : 0);
    bvh_free(&b);
    bvh_free(&again);
}

static void check_builds(const char *name, const mesh *m) {
    static const int leaf_sizes[] = {1, 4, 100}, bins[] = {2, 16, BVH_BINS};
    for (int rule = 0; rule < RULES; rule++)
        for (int i = 0; i < COUNT(leaf_sizes); i++)
            for (int k = 0; k < COUNT(bins); k++)
                if (k == 0 || rule == SPLIT_SAH)
                    check_build(name, m,
                                (bvh_options){(split_rule)rule, leaf_sizes[i], bins[k],
                                              TEST_WATERTIGHT});
}

static void builds_of_scenes(void) {
    static const tree_scene largest = {"coordinates up to the largest number", 200,
                                       tree_largest, true};
    rng g = check_rng(1255);
    for (int i = 0; i <= COUNT(tree_scenes); i++) {
        const tree_scene *s = i < COUNT(tree_scenes) ? &tree_scenes[i] : &largest;
        mesh m = tree_soup(s->count, s->make, &g);
        check_builds(s->name, &m);
        mesh_free(&m);
    }
}

static void builds_of_shapes(void) {
    for (const shape *s = shapes; s->name; s++) {
        mesh m = s->make(2000);
        check_builds(s->name, &m);
        mesh_free(&m);
    }
}

// A cloud's median tree is balanced; and what the SAH is for: it costs less than the others.
static void build_figures(void) {
    mesh m = shape_stadium(20000);
    double cost[RULES];
    for (int rule = 0; rule < RULES; rule++) {
        bvh b = tree_of(&m, (split_rule)rule, 4);
        const bvh_figures f = bvh_measure(&b);
        cost[rule] = f.cost;
        given("stadium of %d triangles by %s: %d leaves, depth %d, cost %.3f", m.count,
              rule_names[rule], f.leaves, f.depth, f.cost);
        CHECK(f.leaves >= m.count / 4 && f.leaves <= m.count, "leaves of 1 to 4 triangles");
        if (rule == SPLIT_MEDIAN) {
            const int depth = (int)ceil(log2(m.count / 4.0));
            CHECK_INT(f.depth, depth);
        }
        bvh_free(&b);
    }
    given("expected costs of the stadium: median %.2f, midpoint %.2f, SAH %.2f, sweep %.2f",
          cost[0], cost[1], cost[2], cost[3]);
    CHECK(cost[SPLIT_SAH] < cost[SPLIT_MEDIAN], "the SAH's tree costs less than the median's");
    CHECK(cost[SPLIT_SWEEP] < cost[SPLIT_MEDIAN], "and so does the sweep's");
    CHECK_REAL(cost[SPLIT_SWEEP], cost[SPLIT_SAH],
               relative_to(0.1, "16 bins find nearly the best plane of all"));
    mesh_free(&m);
}

static void figures_by_hand(void) {
    rng g = check_rng(1256);
    mesh m = tree_soup(4, of_stack, &g);
    bvh b = tree_of(&m, SPLIT_MEDIAN, 1), leaf = tree_of(&m, SPLIT_MEDIAN, 4);
    given("four triangles across z, the median, leaves of 1");
    const bvh_figures f = bvh_measure(&b), whole = bvh_measure(&leaf);
    CHECK_INT(f.leaves, 4);
    CHECK_INT(f.depth, 2);
    CHECK_INT(f.largest_leaf, 1);
    // Boxes 5 x 7 and 3, 1, 1, 0, 0, 0, 0 deep: their areas are 142, 94, 94 and four times 70.
    CHECK_REAL(f.cost, 1 + 2 * 94.0 / 142 + 4 * 70.0 / 142, roundings(16, "areas in real"));
    given("the same, leaves of 4");
    CHECK_INT(whole.leaves, 1);
    CHECK_INT(whole.depth, 0);
    CHECK_REAL(whole.cost, 4, exactly());
    bvh_free(&b);
    bvh_free(&leaf);
    mesh_free(&m);
}

// ---- bvh_flaw ------------------------------------------------------------------------------

static int some_leaf(const bvh *b) {
    int n = b->node_count / 2;
    while (!b->nodes[n].count) n++;
    return n;
}
static int some_inner(const bvh *b) {
    int n = b->node_count / 3;
    while (b->nodes[n].count) n++;
    return n;
}

static void leave_out(bvh *b) {
    b->nodes[some_leaf(b)].count--;
}
static void take_another(bvh *b) {
    b->nodes[some_leaf(b)].first--;
}
static void take_too_many(bvh *b) {
    b->nodes[some_leaf(b)].count++;
}
static void beyond_the_end(bvh *b) {
    b->nodes[some_leaf(b)].first = b->count;
}
static void before_the_start(bvh *b) {
    b->nodes[some_leaf(b)].first = -1;
}
static void far_before_the_start(bvh *b) {
    b->nodes[some_leaf(b)].first = -2000000000;
}
static void huge_count(bvh *b) {
    b->nodes[some_leaf(b)].count = 2000000000;
}
static void negative_count(bvh *b) {
    b->nodes[some_leaf(b)].count = -1;
}
static void twice_in_order(bvh *b) {
    b->order[b->count / 2] = b->order[b->count / 2 + 1];
}
static void other_order(bvh *b) {
    const int k = b->order[3];
    b->order[3] = b->order[b->count - 5];
    b->order[b->count - 5] = k;
}
static void no_such_triangle(bvh *b) {
    b->order[b->count / 2] = b->m->count;
}
static void negative_triangle(bvh *b) {
    b->order[b->count / 2] = -1;
}
static void moved_copy(bvh *b) {
    real *x = &b->triangles[b->count / 2].p2.x;
    *x = nextafter(*x, NO_HIT);
}
static void turned_copy(bvh *b) {
    triangle *T = &b->triangles[b->count / 2];
    *T = (triangle){T->p2, T->p3, T->p1};
}
static void wider_leaf(bvh *b) {
    real *x = &b->nodes[some_leaf(b)].box.max.x;
    *x = nextafter(*x, NO_HIT);
}
static void smaller_leaf(bvh *b) {
    real *x = &b->nodes[some_leaf(b)].box.max.y;
    *x = nextafter(*x, -NO_HIT);
}
static void wider_inner(bvh *b) {
    real *x = &b->nodes[some_inner(b)].box.min.z;
    *x = nextafter(*x, -NO_HIT);
}
static void smaller_root(bvh *b) {
    b->nodes[0].box.max.z -= (real)0.01;
}
static void nan_box(bvh *b) {
    b->nodes[some_inner(b)].box.min.x = NAN;
}
static void endless(bvh *b) {
    b->nodes[some_inner(b)].first = 0;
}
static void itself(bvh *b) {
    const int n = some_inner(b);
    b->nodes[n].first = n;
}
static void odd_children(bvh *b) {
    b->nodes[some_inner(b)].first++;
}
static void children_beyond(bvh *b) {
    b->nodes[some_inner(b)].first = b->node_count;
}
static void children_before(bvh *b) {
    b->nodes[some_inner(b)].first = -4;
}
static void shared_children(bvh *b) {
    b->nodes[2].first = b->nodes[3].first;
}
static void leaf_for_inner(bvh *b) {
    b->nodes[some_inner(b)].count = 1;
}
static void inner_for_leaf(bvh *b) {
    b->nodes[some_leaf(b)].count = 0;
}
static void siblings_swapped(bvh *b) {
    const bvh_node n = b->nodes[2];
    b->nodes[2] = b->nodes[3];
    b->nodes[3] = n;
}
static void unused_nodes(bvh *b) {
    b->node_count -= 2;
}
static void fewer_places(bvh *b) {
    b->count--;
}
static void no_tree(bvh *b) {
    b->count = b->node_count = 0;
}

static const struct {
    const char *what;
    void (*harm)(bvh *b);
} damages[] = {
    {"a leaf has lost a triangle", leave_out},
    {"a leaf has taken another's", take_another},
    {"a leaf has one too many", take_too_many},
    {"a leaf beyond the array's end", beyond_the_end},
    {"a leaf before its start", before_the_start},
    {"a leaf far before its start", far_before_the_start},
    {"a leaf of 2,000,000,000", huge_count},
    {"a leaf of -1", negative_count},
    {"order has a triangle twice", twice_in_order},
    {"order is not that of the triangles", other_order},
    {"order names a triangle beyond the mesh", no_such_triangle},
    {"order names triangle -1", negative_triangle},
    {"a corner of a copy is off by a rounding", moved_copy},
    {"the corners of a copy are turned", turned_copy},
    {"a leaf's box is too wide by a rounding", wider_leaf},
    {"a leaf's box is too small by a rounding", smaller_leaf},
    {"an inner box is too wide by a rounding", wider_inner},
    {"the root's box is too small", smaller_root},
    {"a box is NaN", nan_box},
    {"a node is its own child", itself},
    {"a node has the root as child", endless},
    {"children are not a pair", odd_children},
    {"children beyond the array", children_beyond},
    {"children before the array", children_before},
    {"two nodes share their children", shared_children},
    {"an inner node that is a leaf", leaf_for_inner},
    {"a leaf that is an inner node", inner_for_leaf},
    {"siblings have changed places", siblings_swapped},
    {"the last pair of nodes is not in the array", unused_nodes},
    {"the last triangle is not in the array", fewer_places},
    {"no tree over a mesh with triangles", no_tree},
};

static void flaw_finds(void) {
    mesh m = shape_knot(500);
    for (int i = 0; i < COUNT(damages); i++) {
        bvh b = tree_of(&m, SPLIT_SAH, 4), whole = b;
        CHECK(!bvh_flaw(&b), "the tree is sound before");
        damages[i].harm(&b);
        given("a knot's tree of %d triangles in which %s", whole.count, damages[i].what);
        CHECK(bvh_flaw(&b) != NULL, "bvh_flaw finds it");
        whole.count = b.count;
        bvh_free(&whole);
    }
    mesh_free(&m);
}

// A tree as a list: each inner node has one leaf and the rest.
static bvh long_tree(const mesh *m) {
    bvh b = tree_of(m, SPLIT_MEDIAN, 1);
    for (int i = 0; i < b.count; i++) {
        b.order[i] = i;
        b.triangles[i] = mesh_triangle(m, i);
    }
    for (int i = 0; i + 1 < b.count; i++) {
        const int inner = i == 0 ? 0 : 2 * i + 1;
        b.nodes[inner] = (bvh_node){aabb_empty, 2 * i + 2, 0};
        b.nodes[2 * i + 2] = (bvh_node){aabb_of(b.triangles[i]), i, 1};
    }
    const int last = b.count - 1;
    b.nodes[2 * last + 1] = (bvh_node){aabb_of(b.triangles[last]), last, 1};
    for (int i = last - 1; i >= 0; i--) {
        const int inner = i == 0 ? 0 : 2 * i + 1;
        b.nodes[inner].box = aabb_join(b.nodes[2 * i + 2].box, b.nodes[2 * i + 3].box);
    }
    return b;
}

static void flaw_depth(void) {
    rng g = check_rng(1257);
    for (int count = BVH_DEPTH; count <= BVH_DEPTH + 2; count++) {
        mesh m = tree_soup(count, tree_cloud, &g);
        bvh b = long_tree(&m);
        given("a list of %d triangles, the last at depth %d", count, count - 1);
        CHECK_BOOL(bvh_flaw(&b) == NULL, count - 1 <= BVH_DEPTH);
        bvh_free(&b);
        mesh_free(&m);
    }
}

static void flaw_not_finite(void) {
    rng g = check_rng(1258);
    mesh m = tree_soup(50, tree_cloud, &g);
    bvh b = tree_of(&m, SPLIT_SAH, 4);
    vec3 *points = (vec3 *)m.points;
    points[60].y = NAN;
    given("a corner becomes NaN after the tree was built");
    CHECK(bvh_flaw(&b) != NULL, "bvh_flaw finds it");
    bvh_free(&b);
    mesh_free(&m);
}

// ---- bvh_refit -----------------------------------------------------------------------------

// Moves all points by something smooth, or each by itself.
static void move_points(mesh *m, bool each, rng *g) {
    vec3 *points = (vec3 *)m->points;
    const int count = 3 * m->count;
    const vec3 s = scale(3, in_cube(g));
    for (int i = 0; i < count; i++) {
        const vec3 p = points[i];
        points[i] = (vec3){p.x + (real)0.3 * sin(s.x * p.y), 2 * p.y + s.z, p.z * s.y - p.x};
        if (each) points[i] = add(points[i], scale((real)0.5, in_cube(g)));
    }
}

static void check_refit(const char *name, mesh *m, bool each, rng *g) {
    forest f = forest_of(m);
    move_points(m, each, g);
    for (int rule = 0; rule < RULES; rule++) {
        bvh_refit(&f.b[rule]);
        const char *flaw = bvh_flaw(&f.b[rule]);
        given("%s: %d triangles, %s; all points moved, then bvh_refit\n%s%s", name, m->count,
              rule_names[rule], flaw ? "bvh_flaw says: " : "", flaw ? flaw : "");
        CHECK(!flaw, "a sound tree");
    }
    for (int aim = 0; aim < AIMS; aim++) check_aim(NEAREST, name, m, &f, (aim12)aim, 100, g);
    forest_free(&f);
}

static void refit_scenes(void) {
    static tree_triangle *const makes[] = {tree_cloud, tree_flat, tree_one_centre, tree_x_line,
                                           tree_bricks};
    rng g = check_rng(1259);
    for (int i = 0; i < COUNT(makes); i++) {
        for (int count = 1; count <= 256; count *= 2) {
            mesh m = tree_soup(count, makes[i], &g);
            check_refit("moved triangles", &m, i % 2 == 0, &g);
            mesh_free(&m);
        }
    }
}

static void refit_nothing(void) {
    rng g = check_rng(1260);
    mesh m = tree_soup(100, tree_cloud, &g), none = {0};
    bvh b = tree_of(&m, SPLIT_SAH, 4), again = tree_of(&m, SPLIT_SAH, 4),
        empty = tree_of(&none, SPLIT_SAH, 4);
    bvh_refit(&b);
    given("nothing has moved");
    CHECK(same_trees(&b, &again), "the tree is the same, bit for bit");
    bvh_refit(&empty);
    given("no triangle at all");
    CHECK_INT(empty.count, 0);
    bvh_free(&b);
    bvh_free(&again);
    mesh_free(&m);
}

#endif
