// 14-octree-walk.h: the part of 14-octree.c about the walk: agreement with brute force, ties, the
// stack, the effort. What a walk with a classic mistake finds and asks is worked out beside
// the student's, so that a failure can be told apart from others.
#ifndef TESTS_14_OCTREE_WALK_H
#define TESTS_14_OCTREE_WALK_H

#include <stdio.h>
#include <string.h>

#include "chapters/06-bounce/bounce.h"
#include "chapters/14-octree/cell.h"
#include "tests/14-octree-overlap.h"
#include "tests/14-octree-scenes.h"
#include "tests/check.h"

// ---- the exercises above -------------------------------------------------------------------

static int stored_before(unsigned mask, int i) {
    int count = 0;
    for (int k = 0; k < i; k++) count += is_stored(mask, k);
    return count;
}

static const char *wrong_above(void) {
    for (unsigned mask = 0; mask < 256; mask++)
        for (int i = 0; i < 8; i++)
            if (is_stored(mask, i) && child_index(mask, i) != stored_before(mask, i))
                return "child_index is wrong, and the walk needs it: mend that first.";
    for (int signs = 0; signs < 8; signs++) {
        int order[8];
        order_children((vec3){signs & 1 ? -1 : 1, signs & 2 ? -2 : 2, signs & 4 ? -3 : 3},
                       order);
        if (order[0] != signs || order[7] != 7 - signs)
            return "order_children is wrong, and the walk needs it: mend that first.";
    }
    if (!generic_goes_well())
        return "cell_overlaps is wrong, and the tree is built with it: triangles are not where "
               "they belong. Mend that first.";
    return NULL;
}

// Which exercise that the walk needs is wrong? Then its failures say nothing about the walk.
static const char *above(void) {
    static bool asked;
    static const char *wrong;
    if (!asked) asked = true, wrong = wrong_above();
    return wrong;
}

static void walk_hint(const char *hint) {
    hint_instead(above() ? above() : hint);
}

// ---- walks with a habit --------------------------------------------------------------------

typedef enum {
    BY_INDEX,
    BY_NUMBER,
    BY_PLACE,
    FROM_BEHIND,
    COUNTED_DOWN,
    COUNTED_UP
} node_habit;
typedef enum { NEAR_FIRST, FAR_FIRST, BY_RISING, BY_FALLING } order_habit;

typedef struct {
    const char *looks_like, *hint;
    node_habit node;
    order_habit order;
    bool ends;         // at the first leaf with a hit
    bool first_counts; // of equally near triangles the one met first stays
    bool whole_range;  // t_min is forgotten
    bool unlimited;    // t_max is forgotten
    bool not_popped;   // what waits is not asked again
    bool not_pushed;   // the limit is not asked when a cell is pushed
    bool all_eight;    // is_stored is not asked
    bool stored_k;     // is_stored(mask, k), and the rest is order[k]'s
    bool cell_k;       // cell_child(w.cell, k), and the rest is order[k]'s
} habit14;

#define SAME_CHILD                                                                            \
    "Three things belong to one child i = order[k]: is_stored(mask, i), the node n->first + " \
    "child_index(mask, i), and cell_child(w.cell, i)."

// What a wrong walk finds.
static const habit14 finding[] = {
    {.looks_like = "node n->first + order[k]: only stored children have a node",
     .hint =
         "Empty children are not stored: child i stands at n->first + child_index(mask, i).",
     .node = BY_NUMBER},
    {.looks_like = "node n->first + k: k counts the places in the order, not the nodes",
     .hint = "Child i = order[k] stands at n->first + child_index(mask, i).",
     .node = BY_PLACE},
    {.looks_like = "node n->first + 7 - k: k counts the places in the order, not the nodes",
     .hint = "Child i = order[k] stands at n->first + child_index(mask, i).",
     .node = FROM_BEHIND},
    {.looks_like = "child++ while k goes from 7 to 0: the nodes stand from 0 to 7",
     .hint =
         "Nodes stand in rising order of their children, and order[] is another one: child i "
         "stands at n->first + child_index(mask, i).",
     .node = COUNTED_DOWN},
    {.looks_like = "child++ along order[0] to order[7]: the nodes stand from 0 to 7",
     .hint =
         "Nodes stand in rising order of their children, and order[] is another one: child i "
         "stands at n->first + child_index(mask, i).",
     .node = COUNTED_UP,
     .order = FAR_FIRST},
    {.looks_like = "is_stored(mask, k) in place of order[k]",
     .hint = SAME_CHILD,
     .stored_k = true},
    {.looks_like = "cell_child(w.cell, k) in place of order[k]",
     .hint = SAME_CHILD,
     .cell_k = true},
    {.looks_like = "the walk ends at the first hit",
     .hint =
         "A triangle may be hit outside of the cell in whose list it stands: cells that begin "
         "before that hit must still be asked.",
     .ends = true},
    {.looks_like = "the walk ends at the first hit, and the farther children come first",
     .hint =
         "A triangle may be hit outside of the cell in whose list it stands: cells that begin "
         "before that hit must still be asked. And what is pushed last is looked into first.",
     .order = FAR_FIRST,
     .ends = true},
    {.looks_like = "t_min is not asked",
     .hint = "t_min < t: leaf_triangles (and triangle_hit) get t_min.",
     .whole_range = true},
    {.looks_like = "t_max is not asked",
     .hint = "t < t_max: a find begins with t_max, not with NO_HIT.",
     .unlimited = true},
    {.looks_like = "the one that the ray came to first: equally near ones with a smaller index "
                   "do not take its place",
     .hint =
         "Where t is equal the smaller index counts, also when its cell is looked into later. "
         "leaf_triangles compares the index; a loop of your own must too, and look as far "
         "as find_limit.",
     .first_counts = true},
};

// What a wrong walk spends.
static const habit14 spending[] = {
    {.looks_like =
         "every cell is looked into that the ray meets: the farther children come first, "
         "or what begins beyond the hit is not left out",
     .hint =
         "Nearest first: the last one pushed is looked into first. And is a popped cell left "
         "out whose w.t is beyond find_limit(&f) by now?",
     .not_popped = true,
     .not_pushed = true},
    {.looks_like = "the farther children come first",
     .hint = "The last one pushed is looked into first: push order[7] first and order[0] last.",
     .order = FAR_FIRST},
    {.looks_like = "children from 0 to 7, whatever d is",
     .hint = "order_children(r.d, order) says which child is nearer: look into order[0] first.",
     .order = BY_RISING},
    {.looks_like = "children from 7 to 0, whatever d is",
     .hint = "order_children(r.d, order) says which child is nearer: look into order[0] first.",
     .order = BY_FALLING},
    {.looks_like = "also children that are not stored are asked: is_stored is forgotten",
     .hint = "Only stored children have a node; what stands in the place of another is a "
             "different child's: if (!is_stored(mask, i)) continue.",
     .all_eight = true},
    {.looks_like = "what waits is not asked again when it is popped",
     .hint = "A cell that was pushed before the hit was found may begin beyond it: is w.t > "
             "find_limit(&f) by now?",
     .not_popped = true},
};

typedef struct {
    triangle_point best;
    int index;              // -7: none
    long asked, met, empty; // cells; and children that are not stored
} found14;

static int mirror_of(vec3 d) {
    return (d.x < 0) | (d.y < 0) << 1 | (d.z < 0) << 2;
}

static int child_looked_into(order_habit how, vec3 d, int place) {
    switch (how) {
    case NEAR_FIRST:
        return place ^ mirror_of(d);
    case FAR_FIRST:
        return 7 - (place ^ mirror_of(d));
    default:
        return how == BY_RISING ? place : 7 - place;
    }
}

// Where the walk takes the node of child i to be, the one at `place` in the order of looking,
// after `later` stored ones that are looked into later.
static int node_offset(node_habit how, unsigned mask, int i, int place, int later) {
    switch (how) {
    case BY_NUMBER:
        return i;
    case BY_PLACE:
        return place;
    case FROM_BEHIND:
        return 7 - place;
    case COUNTED_DOWN:
    case COUNTED_UP:
        return later;
    default:
        return stored_before(mask, i);
    }
}

static void leaf_with_habit(const octree *o, const octree_node *n, probe p, const habit14 *h,
                            real t_min, find *f) {
    const find before = *f;
    leaf_triangles(o, n, p.r, t_min, f, NULL);
    if (h->first_counts && before.best.t != NO_HIT && f->best.t == before.best.t) *f = before;
}

typedef struct {
    int node;
    real t;
    aabb cell;
} cell14;
enum { ROOM14 = 4000, MOST14 = 100000 }; // a wrong walk may go in circles

static found14 walk_with_habit(const octree *o, probe p, const habit14 *h) {
    static cell14 stack[ROOM14 + 8];
    const slab_ray s = slab_ray_of(p.r);
    const real t_min = h->whole_range ? 0 : p.t_min, t_max = h->unlimited ? NO_HIT : p.t_max;
    find f = {{NO_HIT, 0, 0}, -7, t_max};
    found14 a = {.asked = 1};
    int top = 0;
    real t;
    if (o->node_count && aabb_hit(&o->cube, &s, t_min, t_max, &t))
        stack[top++] = (cell14){0, t, o->cube}, a.met = 1;
    while (top > 0 && top < ROOM14 && a.asked < MOST14) {
        const cell14 w = stack[--top];
        const octree_node *n = &o->nodes[w.node];
        if (!h->not_popped && w.t > find_limit(&f)) continue;
        if (is_leaf(n)) {
            leaf_with_habit(o, n, p, h, t_min, &f);
            if (h->ends && f.best.t != NO_HIT) break;
            continue;
        }
        const unsigned mask = stored_children(n);
        for (int place = 7, later = 0; place >= 0; place--) {
            const int i = child_looked_into(h->order, p.r.d, place);
            a.empty += !is_stored(mask, i);
            if (!h->all_eight && !is_stored(mask, h->stored_k ? place : i)) continue;
            const int node = n->first + node_offset(h->node, mask, i, place, later++);
            const aabb cell = cell_child(w.cell, h->cell_k ? place : i);
            a.asked++;
            if (!aabb_hit(&cell, &s, t_min, h->not_pushed ? t_max : find_limit(&f), &t))
                continue;
            a.met++;
            if (node < o->node_count) stack[top++] = (cell14){node, t, cell};
        }
    }
    a.best = f.best;
    a.index = f.best.t == NO_HIT ? -7 : f.index;
    return a;
}

// ---- agreement with brute force ------------------------------------------------------------

#define NEAREST_CALL "octree_nearest(&tree, r, t_min, t_max, &index, &spent)"

typedef struct {
    const char *where;
    probe p;
    triangle_point want, got;
    int want_index, index; // -7: untouched
} search14;

// Searches in one tree: the first that went wrong, and which habits could have led to all answers.
static struct {
    const octree *o;
    char tree[120];
    const char *hint; // in place of the neutral one
    bool failed, dead[COUNT(finding)];
    search14 first;
    int after;              // searches since
    int plain, plain_wrong; // searches with no component of d 0: the right and the wrong ones
} trial;

enum { AFTER = 300 };

static void searches_begin(const octree *o) {
    const octree_figures f = octree_measure(o);
    trial.o = o;
    snprintf(trial.tree, sizeof trial.tree, "%d triangle%s in a tree of %d nodes, %d levels",
             o->m->count, o->m->count == 1 ? "" : "s", o->node_count, f.depth);
}

static void given_search(const search14 *s, const char *more) {
    char best[80] = "no hit (NO_HIT, infinity)";
    if (s->want.t != NO_HIT)
        snprintf(best, sizeof best, "triangle %d at t = %.9g", s->want_index,
                 (double)s->want.t);
    const bool no_direction = dot(s->p.r.d, s->p.r.d) == 0;
    given("%s: %s\n" PROBE "%s\nbrute force: %s%s", s->where, trial.tree, ARG_PROBE(s->p),
          no_direction ? "\n(d may be 0: such a ray hits nothing, but is asked all the same)"
                       : "",
          best, more);
}

// What is printed should the walk crash: the tree has nodes, and `spent` is not NULL.
#define SHOULD_IT_CRASH                                                                      \
    "\nLikely, should it crash: a node's number that is none (of a child that is not "       \
    "stored?), "                                                                             \
    "or more cells wait than the stack has room for (OCTREE_STACK).\nShould it not end: no " \
    "cell "                                                                                  \
    "is taken off the stack (stack[--top], not stack[top - 1])."

static bool has_zero(vec3 d) {
    return d.x == 0 || d.y == 0 || d.z == 0;
}
static bool has_minus_zero(vec3 d) {
    return (d.x == 0 && signbit(d.x)) || (d.y == 0 && signbit(d.y)) ||
           (d.z == 0 && signbit(d.z));
}

// Did all rays without a component 0 go well, and were there some?
static bool zero_spoils(void) {
    return trial.plain >= 50 && trial.plain_wrong == 0;
}

// The one habit that explains all answers, the wrong ones too; or NULL.
static const habit14 *likely_habit(void) {
    const habit14 *found = NULL;
    if (above()) return NULL;
    for (int k = 0; k < COUNT(finding); k++) {
        if (trial.dead[k]) continue;
        if (found) return NULL;
        found = &finding[k];
    }
    return found;
}

static const char *hint_about_t(const search14 *s) {
    const bool too_far = s->got.t > s->want.t;
    if (s->got.t <= s->p.t_min)
        return "t_min < t: leaf_triangles (and triangle_hit) get t_min.";
    if (s->got.t >= s->p.t_max && s->got.t != NO_HIT)
        return "t < t_max: a find begins with t_max, not with NO_HIT.";
    if (too_far && zero_spoils() && has_minus_zero(s->p.r.d))
        return "Rays without a component 0 went well. Did you write a slab test of your own? "
               "For "
               "-0 the comparison d < 0 is false, and 1/d is -infinity: aabb_hit knows.";
    if (too_far && zero_spoils() && has_zero(s->p.r.d))
        return "Rays without a component 0 went well. Did you write a slab test of your own? "
               "1/d "
               "is infinite for 0, and 0 times that is NaN: aabb_hit knows.";
    if (trial.hint) return trial.hint;
    if (s->got.t == NO_HIT)
        return "The cell with that triangle was not looked into. " SAME_CHILD;
    if (too_far)
        return "A nearer triangle was missed: its cell was not looked into, or the walk ended "
               "at "
               "a hit outside of its cell. " SAME_CHILD;
    return "Nothing is hit there. t, u and v are those of triangle_hit: f.best at the end.";
}

static void suspects_of_t(const search14 *s) {
    const bool too_far = s->got.t > s->want.t;
    if (too_far && zero_spoils() && has_minus_zero(s->p.r.d))
        suspect_value("a hit lost where a component of d is -0", (double)s->got.t);
    if (s->got.t == NO_HIT) suspect_value("a miss: a hit is lost", (double)NO_HIT);
    if (too_far) suspect_value("a hit further away: a nearer one is lost", (double)s->got.t);
    if (s->got.t <= s->p.t_min) suspect_value("a hit before t_min, or at it", (double)s->got.t);
    if (s->got.t >= s->p.t_max && s->got.t != NO_HIT)
        suspect_value("a hit at t_max, or behind it", (double)s->got.t);
}

static void check_t(const search14 *s, const habit14 *h) {
    given_search(s, "");
    if (h) suspect_value(h->looks_like, (double)s->got.t);
    walk_hint(h ? h->hint : hint_about_t(s));
    suspects_of_t(s);
    check_real(__FILE__, __LINE__, NEAREST_CALL ".t", (double)s->got.t, (double)s->want.t,
               exactly());
}

static bool is_tie(const search14 *s) {
    if (s->index < 0 || s->index >= trial.o->m->count) return false;
    const triangle T = mesh_triangle(trial.o->m, s->index);
    return triangle_hit(T, s->p.r, s->p.t_min, NO_HIT).t == s->want.t;
}

static void suspects_of_index(const search14 *s) {
    const octree *o = trial.o;
    suspect_value("*index was not set", -7);
    if (s->want_index < o->entry_count)
        suspect_value("o->lists[f.index]: f.index is the mesh's number already",
                      o->lists[s->want_index]);
    if (s->index >= 0 && s->index < o->entry_count && o->lists[s->index] == s->want_index)
        suspect_value("a place in o->lists: the mesh's number stands there", s->index);
}

static void check_index(const search14 *s, const habit14 *h) {
    given_search(s, "\nindex is -7 before");
    if (s->want.t == NO_HIT) {
        suspect_value("written though nothing was hit: a miss leaves *index untouched",
                      s->index);
        walk_hint("*index = f.index on a hit only: is f.best.t other than NO_HIT?");
    } else if (s->index == -7) {
        walk_hint("At the end, after a hit: *index = f.index.");
    } else if (is_tie(s)) {
        suspect_value(
            h ? h->looks_like
              : "another triangle at the same t: of two equally near triangles the one "
                "with the smaller index counts",
            s->index);
        walk_hint(h ? h->hint
                    : "Where t is equal the index must be compared, within a leaf and between "
                      "leaves: leaf_triangles does, if it is asked.");
    } else {
        walk_hint("The number of the triangle in the mesh, as in o->lists: f.index.");
    }
    suspects_of_index(s);
    check_int(__FILE__, __LINE__, "index, after " NEAREST_CALL, s->index, s->want_index);
}

static void searches_report(void) {
    const search14 *s = &trial.first;
    const habit14 *h = likely_habit();
    if (s->got.t != s->want.t) check_t(s, h);
    if (s->index != s->want_index) check_index(s, h);
    given_search(s, "");
    walk_hint("t, u and v come from one call of triangle_hit: f.best as a whole.");
    char uv[120];
    snprintf(uv, sizeof uv, "u = %.9g, v = %.9g, expected %.9g and %.9g", (double)s->got.u,
             (double)s->got.v, (double)s->want.u, (double)s->want.v);
    check_that(__FILE__, __LINE__, uv, !memcmp(&s->got, &s->want, sizeof s->got),
               "u and v as brute force, bit for bit");
}

static bool is_right(const search14 *s) {
    return !memcmp(&s->got, &s->want, sizeof s->got) && s->index == s->want_index;
}

static void rule_out(const search14 *s) {
    for (int k = 0; k < COUNT(finding); k++) {
        if (trial.dead[k]) continue;
        const found14 a = walk_with_habit(trial.o, s->p, &finding[k]);
        trial.dead[k] = a.best.t != s->got.t || (a.best.t != NO_HIT && a.index != s->index);
    }
}

// Should a ray crash after the first wrong one: what is known.
static void given_first(probe p) {
    const habit14 *h = likely_habit();
    char more[600];
    snprintf(more, sizeof more,
             "\nThe answer was wrong here: t = %.9g. The walk did not come back from a later "
             "ray:\n" PROBE "%s%s",
             (double)trial.first.got.t, ARG_PROBE(p), h ? "\nLikely: " : SHOULD_IT_CRASH,
             h ? h->looks_like : "");
    given_search(&trial.first, more);
}

// One search. After the first wrong one some more, to learn what they have in common.
static void check_nearest(probe p, const char *where) {
    search14 s = {.where = where, .p = p, .want_index = -7, .index = -7};
    effort spent = {0, 0};
    s.want = mesh_hit(trial.o->m, p.r, p.t_min, p.t_max, &s.want_index);
    if (trial.failed)
        given_first(p);
    else
        given_search(&s, SHOULD_IT_CRASH);
    s.got = octree_nearest(trial.o, p.r, p.t_min, p.t_max, &s.index, &spent);
    rule_out(&s);
    const bool right = is_right(&s);
    if (!has_zero(p.r.d)) trial.plain += right, trial.plain_wrong += !right;
    if (!trial.failed) {
        trial.failed = !right;
        trial.first = s;
    } else if (++trial.after > AFTER) {
        searches_report();
    }
}

static void searches_end(void) {
    if (trial.failed) searches_report();
}

// ---- the tests -----------------------------------------------------------------------------

static octree built(const mesh *m) {
    return octree_build(m, octree_defaults);
}

// Does a soup, a tree of few levels, go well? What fails in a deep one is then about depth.
static bool soup_goes_well(void) {
    rng g = check_rng(1411);
    mesh m = scene_soup(&g);
    octree o = built(&m);
    const aabb box = finite_box(&m);
    bool well = true;
    given("first a soup, a tree of few levels" SHOULD_IT_CRASH);
    for (int i = 0; i < 1000 && well; i++) {
        const probe p = random_probe(&m, box, &g);
        effort spent = {0, 0};
        search14 s = {.p = p, .want_index = -7, .index = -7};
        s.want = mesh_hit(&m, p.r, p.t_min, p.t_max, &s.want_index);
        s.got = octree_nearest(&o, p.r, p.t_min, p.t_max, &s.index, &spent);
        well = is_right(&s);
    }
    octree_free(&o);
    mesh_free(&m);
    return well;
}

#define SHALLOW_TOO "In a tree of few levels it goes wrong, too: the test \"a soup\" says more."

// Also where the cube is not what octree_build makes of no triangle.
static void nearest_empty(void) {
    const vec3 none[1] = {{0, 0, 0}};
    const int corners[1][3] = {{0, 0, 0}};
    const mesh m = {.points = none, .corners = corners, .count = 0};
    octree small = built(&m);
    const octree o = {.m = &m, .how = octree_defaults, .cube = {{-1, -1, -1}, {1, 1, 1}}};
    const octree *const both[] = {&small, &o};
    for (int i = 0; i < 2; i++) {
        const ray r = {{(real)0.3, (real)0.1, -2}, {(real)0.1, (real)0.2, 1}};
        int index = -7;
        effort spent = {0, 0};
        given(
            "a mesh without triangles: node_count = 0, nodes = NULL; there is no root\nLikely, "
            "should it crash: nodes[0] was looked into. Ask node_count first.");
        const triangle_point q = octree_nearest(both[i], r, 0, NO_HIT, &index, &spent);
        given("a mesh without triangles: node_count = 0, nodes = NULL; there is no root");
        walk_hint("Ask node_count before anything else.");
        CHECK_REAL(q.t, NO_HIT, exactly());
        walk_hint("*index = f.index on a hit only.");
        CHECK_INT(index, -7);
    }
    octree_free(&small);
}

static void nearest_in(int first, int last, int rays, uint64_t stream) {
    rng g = check_rng(stream);
    for (int k = first; k <= last; k++) {
        mesh m = scene_rows[k].make(&g);
        octree o = built(&m);
        const aabb box = finite_box(&m);
        searches_begin(&o);
        for (int i = 0; i < rays && !scene_rows[k].built_only; i++)
            check_nearest(random_probe(&m, box, &g), scene_rows[k].name);
        searches_end();
        octree_free(&o);
        mesh_free(&m);
    }
}

static void nearest_few(void) {
    nearest_in(1, 2, 1000, 1410);
}
static void nearest_soup(void) {
    nearest_in(3, 3, 4000, 1411);
}
static void nearest_adversarial(void) {
    nearest_in(4, COUNT(scene_rows) - 1, 1000, 1412);
}

// With a counter first: what fails then has nothing to do with NULL.
static void nearest_uncounted(void) {
    rng g = check_rng(1419);
    mesh m = scene_soup(&g);
    octree o = built(&m);
    const aabb box = finite_box(&m);
    searches_begin(&o);
    for (int i = 0; i < 1000; i++) {
        const probe p = random_probe(&m, box, &g);
        int counted = -7, index = -7;
        effort spent = {0, 0};
        given("a soup: %s\n" PROBE "\nspent points to a counter" SHOULD_IT_CRASH, trial.tree,
              ARG_PROBE(p));
        const real t = octree_nearest(&o, p.r, p.t_min, p.t_max, &counted, &spent).t;
        given("a soup: %s\n" PROBE "\nspent = NULL: nobody counts. With a counter this search "
              "came to an end.\nLikely, should it crash: not every spent-> stands behind "
              "if (spent).",
              trial.tree, ARG_PROBE(p));
        const real again = octree_nearest(&o, p.r, p.t_min, p.t_max, &index, NULL).t;
        given("a soup: %s\n" PROBE
              "\nspent = NULL: nobody counts; the same search with a counter "
              "gave index %d",
              trial.tree, ARG_PROBE(p), counted);
        walk_hint("Whether somebody counts must not change the answer.");
        check_real(__FILE__, __LINE__, "octree_nearest(&tree, r, t_min, t_max, &index, NULL).t",
                   (double)again, (double)t, exactly());
        CHECK_INT(index, counted);
    }
    octree_free(&o);
    mesh_free(&m);
}

static void nearest_minus_zero(void) {
    rng g = check_rng(1413);
    mesh m = scene_soup(&g);
    octree o = built(&m);
    searches_begin(&o);
    for (int i = 0; i < 3000; i++) {
        const int axis = i % 3;
        vec3 d = {(real)-0.0, (real)-0.0, (real)-0.0};
        *(axis == 0 ? &d.x : axis == 1 ? &d.y : &d.z) = i & 1 ? 1 : -1;
        if (i < 300) d = generic_unit(&g); // should these fail, it is not about -0
        const vec3 O = add(point_of(&m, &g), scale(-3, d));
        check_nearest((probe){{O, d}, 0, NO_HIT}, "a soup");
    }
    searches_end();
    octree_free(&o);
    mesh_free(&m);
}

static void nearest_inside(void) {
    rng g = check_rng(1414);
    mesh m = shape_cave(2000);
    octree o = built(&m);
    searches_begin(&o);
    for (int i = 0; i < 1000; i++) {
        const ray r = {scale((real)0.2, in_cube(&g)),
                       scale((real)between(&g, 0.1, 10), in_cube(&g))};
        check_nearest((probe){r, 0, NO_HIT}, "from inside a cave");
    }
    searches_end();
    octree_free(&o);
    mesh_free(&m);
}

// ---- ties ------------------------------------------------------------------------------------

// Two triangles in the plane z = 1: a large one across the four lower cells, a small one in
// child 1 alone. The ray hits both at t = 1, in child 1; it comes to child 0 first, in whose list
// the large one stands.
static void tie_by_hand(bool large_first) {
    static const vec3 points[] = {{0.5f, 0.5f, 1}, {7.5f, 0.5f, 1}, {4, 7.5f, 1},
                                  {4.5f, 1.5f, 1}, {6, 1.5f, 1},    {5, 3, 1}};
    const int large = large_first ? 0 : 1;
    const int corners[2][3] = {{3 * !large_first, 3 * !large_first + 1, 3 * !large_first + 2},
                               {3 * large_first, 3 * large_first + 1, 3 * large_first + 2}};
    const mesh m = {.points = points, .corners = corners, .count = 2};
    octree_node nodes[] = {{1, -15}, {0, 1}, {1, 2}, {0, 1}, {0, 1}};
    int lists[] = {large, 0, 1};
    const octree o = {.m = &m,
                      .how = octree_defaults,
                      .cube = {{0, 0, 0}, {8, 8, 8}},
                      .nodes = nodes,
                      .lists = lists,
                      .node_count = 5,
                      .entry_count = 3};
    searches_begin(&o);
    check_nearest((probe){{{1, 1, 0.5f}, {4, 1, 0.5f}}, 0, NO_HIT},
                  large_first ? "both hit at t = 1 in child 1, 0 met in child 0 already"
                              : "both hit at t = 1 in child 1, 1 met in child 0 already");
    searches_end(); // before they are gone
}

// Plates of all sizes in one plane: equally near wherever they overlap, and large ones stand in
// the lists of cells that the ray comes to earlier. Dust, so that there are cells.
static mesh plates(rng *g) {
    soup s = soup_new(260);
    while (s.count < 200) soup_around(&s, in_cube(g), (real)0.02, g);
    while (s.count < 260) {
        const real size = (real)pow(10, between(g, -1.5, 0.2));
        const vec3 c = in_cube(g), a = in_cube(g), b = in_cube(g);
        const real x = scale(size, a).x, y = scale(size, a).y, u = scale(size, b).x,
                   v = scale(size, b).y, z = (real)0.125;
        soup_add(&s, (vec3){c.x + x, c.y + y, z}, (vec3){c.x + u, c.y + v, z},
                 (vec3){c.x - x - u, c.y - y - v, z});
    }
    return soup_mesh(s);
}

static void ties_in(mesh m, const char *where, rng *g) {
    octree o = built(&m);
    const aabb box = finite_box(&m);
    searches_begin(&o);
    for (int i = 0; i < 3000; i++) check_nearest(random_probe(&m, box, g), where);
    searches_end();
    octree_free(&o);
    mesh_free(&m);
}

// Of equal triangles the first; also when the ray comes to another of them earlier.
static void nearest_ties(void) {
    rng g = check_rng(1415);
    ties_in(plates(&g), "plates in one plane, and dust", &g);
    tie_by_hand(true);
    tie_by_hand(false);
    ties_in(scene_coincident(&g), "the same triangles again", &g);
}

// In a closed mesh every ray from inside hits, also those through edges and corners.
static void nearest_closed(void) {
    rng g = check_rng(1416);
    mesh m = shape_cave(3000);
    octree o = built(&m);
    const bool well = soup_goes_well();
    for (int i = 0; i < 20000; i++) {
        const vec3 O = scale((real)0.1, in_cube(&g)), aim = point_of(&m, &g);
        int index = -1;
        effort spent = {0, 0};
        given("inside a cave of %d triangles; ray O = " VEC ", d = " VEC, m.count, ARG(O),
              ARG(sub(aim, O)));
        const real t = octree_nearest(&o, (ray){O, sub(aim, O)}, 0, NO_HIT, &index, &spent).t;
        walk_hint(well ? "A soup goes well, so it is rounding: a slab test or a limit of your "
                         "own that leaves no room for it, as aabb_hit and find_limit do?"
                       : "In a soup hits are lost, too: the test \"a soup\" says more.");
        check_that(__FILE__, __LINE__, "no hit (NO_HIT)", t != NO_HIT,
                   "a hit: no ray leaves a closed mesh, not through its edges either");
    }
    octree_free(&o);
    mesh_free(&m);
}

// ---- effort ----------------------------------------------------------------------------------

// Where nothing is hit every walk looks into the same cells, in whatever order, and what it counts
// is known exactly.
typedef struct {
    const char *looks_like, *hint;
    int root, met,
        empty; // counted too: the root once more; only cells that are met; empty ones
} count_habit;

#define COUNT_EACH "One step for each cell asked, just before aabb_hit: the root once, then "

static const count_habit counting[] = {
    {"the root counted twice", COUNT_EACH "each child as it is asked, not again when popped.",
     1, 0, 0},
    {"the root not counted", COUNT_EACH "the stored children. The root is asked, too.", -1, 0,
     0},
    {"only the cells that the ray meets are counted",
     COUNT_EACH "each stored child, also those that the ray passes by.", 0, 1, 0},
    {"only the cells that the ray meets are counted, without the root",
     COUNT_EACH "each stored child, also those that the ray passes by.", -1, 1, 0},
    {"children that are not stored are counted too",
     COUNT_EACH "the stored children: there is no other to ask.", 0, 0, 1},
    {"every cell is counted twice",
     COUNT_EACH "each child as it is asked, not again when popped.", 2, 0, 0},
    {"each cell is counted when it is asked, and once more when it is popped",
     COUNT_EACH "each child as it is asked, not again when popped.", 3, 0, 0},
    {"also children that are not stored are asked: is_stored is forgotten",
     "Only stored children have a node; what stands in the place of another is a different "
     "child's: if (!is_stored(mask, i)) continue.",
     4, 0, 0},
};

static long counted(const count_habit *c, const found14 *a, const found14 *all_eight) {
    if (c->root == 4) return all_eight->asked;
    if (c->root == 2) return 2 * a->asked;
    if (c->root == 3) return a->asked + a->met;
    return (c->met ? a->met : a->asked) + c->root + (c->empty ? a->empty : 0);
}

typedef struct {
    ray r;
    real t;
    long got, most;
    bool wrong;
} count14;

static struct {
    bool dead_count[COUNT(counting)], dead_order[COUNT(spending)];
    count14 miss, hit; // the first wrong ones
} work;

static void given_count(const count14 *c, const char *more) {
    if (c->t == NO_HIT)
        given("a cloud: %s; *spent held 1000 steps\nray O = " VEC ", d = " VEC
              "\nno hit, so every cell that the ray meets is looked into%s",
              trial.tree, ARG(c->r.O), ARG(c->r.d), more);
    else
        given("a cloud: %s; *spent held 1000 steps\nray O = " VEC ", d = " VEC
              "\nthe nearest hit is at t = %.9g, and was found%s",
              trial.tree, ARG(c->r.O), ARG(c->r.d), (double)c->t, more);
}

#define ADDED "the steps added to *spent: cells asked"

static void check_added(const count14 *c) {
    given_count(c, "");
    walk_hint("if (spent) spent->steps++; wherever a cell is asked.");
    check_at_most(__FILE__, __LINE__, "cells asked and not counted", c->got == 0, 0,
                  "a step is added to *spent for each cell asked; none was");
    walk_hint("spent->steps++ adds; = writes over what other rays have spent.");
    check_that(__FILE__, __LINE__, "*spent holds less than before", c->got > 0,
               "steps are added to what *spent held");
}

static void report_miss(void) {
    const count14 *c = &work.miss;
    check_added(c);
    given_count(c, "");
    walk_hint(COUNT_EACH "each stored child of a cell that is looked into.");
    for (int k = 0; k < COUNT(counting); k++) {
        if (above() || work.dead_count[k]) continue;
        suspect_value(counting[k].looks_like, (double)c->got);
        walk_hint(counting[k].hint);
        break;
    }
    check_int(__FILE__, __LINE__, ADDED, c->got, c->most);
}

static void report_hit(void) {
    const count14 *c = &work.hit;
    check_added(c);
    given_count(c, "");
    walk_hint("Which cells begin before the hit? Nearest first (what is pushed last is looked "
              "into first), and what begins beyond find_limit(&f) is left out, also if it was "
              "pushed before the hit was found.");
    for (int k = 0; k < COUNT(spending); k++) {
        if (above() || work.dead_order[k]) continue;
        suspect_value(spending[k].looks_like, (double)c->got);
        walk_hint(spending[k].hint);
        break;
    }
    check_at_most(__FILE__, __LINE__, ADDED, (double)c->got, (double)c->most,
                  "the cells that begin before the hit, and their brothers");
}

// Cells asked by a walk that knows t beforehand: those of each cell that the ray enters by t.
static long needed_steps(const octree *o, const octree_node *n, aabb cell, const slab_ray *s,
                         real t_max) {
    real t;
    if (!aabb_hit(&cell, s, 0, t_max, &t)) return 1;
    long steps = 1;
    if (is_leaf(n)) return steps;
    const octree_node *child = &o->nodes[n->first];
    for (int i = 0; i < 8; i++)
        if (is_stored(stored_children(n), i))
            steps += needed_steps(o, child++, cell_child(cell, i), s, t_max);
    return steps;
}

static void count_search(const octree *o, probe p) {
    const slab_ray s = slab_ray_of(p.r);
    int index = -7;
    effort spent = {1000, 1000};
    given_count(&(count14){p.r, NO_HIT, 0, 0, false}, SHOULD_IT_CRASH);
    count14 c = {.r = p.r};
    c.t = octree_nearest(o, p.r, 0, NO_HIT, &index, &spent).t;
    c.got = spent.steps - 1000;
    const real reach = c.t == NO_HIT ? c.t : c.t * (1 + 16 * REAL_EPSILON);
    c.most = needed_steps(o, o->nodes, o->cube, &s, reach);
    c.wrong = c.t == NO_HIT ? c.got != c.most : c.got > c.most || c.got <= 0;
    count14 *first = c.t == NO_HIT ? &work.miss : &work.hit;
    if (c.wrong && !first->wrong) *first = c;
    given_count(&c, "");
    walk_hint("Is it mesh_hit, which asks all triangles? Begin with octree_any, which asks "
              "cells.");
    check_that(__FILE__, __LINE__, "*spent is as it was",
               spent.steps != 1000 || spent.tests != 1000,
               "*spent tells what was asked: no cell was, and no triangle of a leaf");
    walk_hint("leaf_triangles counts the tests, if it gets spent; a loop of your own must.");
    check_at_most(__FILE__, __LINE__, "tests missing in *spent",
                  c.t != NO_HIT && spent.tests <= 1000, 0,
                  "one is added for each triangle asked, and one was hit");
    if (c.t == NO_HIT) {
        const found14 a = walk_with_habit(o, p, &(habit14){0});
        const found14 b = walk_with_habit(o, p, &(habit14){.all_eight = true});
        for (int k = 0; k < COUNT(counting); k++)
            work.dead_count[k] |= counted(&counting[k], &a, &b) != c.got;
    } else {
        for (int k = 0; k < COUNT(spending); k++)
            work.dead_order[k] |=
                !work.dead_order[k] && walk_with_habit(o, p, &spending[k]).asked != c.got;
    }
}

// What is found first; then how many cells were asked for it.
static void nearest_steps(void) {
    mesh m = shape_cloud(3000);
    octree o = built(&m);
    searches_begin(&o);
    for (int round = 0; round < 2; round++) {
        rng g = check_rng(1417);
        for (int i = 0; i < 2000; i++) {
            const vec3 O = scale(3, generic_unit(&g));
            const probe p = {{O, sub(scale((real)0.5, in_cube(&g)), O)}, 0, NO_HIT};
            if (round == 0)
                check_nearest(p, "a cloud");
            else
                count_search(&o, p);
        }
        searches_end();
    }
    if (work.miss.wrong) report_miss();
    if (work.hit.wrong) report_hit();
    octree_free(&o);
    mesh_free(&m);
}

// ---- depth -----------------------------------------------------------------------------------

static void nearest_deep(void) {
    rng g = check_rng(1418);
    soup s = soup_new(400);
    for (int k = 0; k < 100; k++)
        for (int i = 0; i < 4; i++)
            soup_around(&s, scale(ldexp((real)1, -k / 4), (vec3){1, 1, 1}),
                        ldexp((real)1, -k / 4 - 2), &g);
    mesh m = soup_mesh(s);
    octree o = octree_build(
        &m, (octree_options){.leaf_size = 1, .depth = OCTREE_DEPTH, .memory = 100});
    CHECK_INT(octree_measure(&o).depth, OCTREE_DEPTH);
    const aabb box = finite_box(&m);
    searches_begin(&o);
    trial.hint =
        soup_goes_well()
            ? "In a tree of few levels it goes well, so it is the depth: has your stack "
              "room for OCTREE_STACK cells?"
            : SHALLOW_TOO;
    for (int i = 0; i < 2000; i++) check_nearest(random_probe(&m, box, &g), "20 levels");
    for (int i = 0; i < 8; i++) {
        const vec3 d = {i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1};
        check_nearest((probe){{scale(-3, d), d}, 0, NO_HIT}, "20 levels, the diagonals");
    }
    searches_end();
    octree_free(&o);
    mesh_free(&m);
}

// A tree of 20 levels in which the child in corner c of each cell is divided again, and all eight
// are stored. The diagonal through c passes through the middle of each of these cells, where all
// eight children meet: none is left out.
typedef struct {
    octree_node nodes[1 + 8 * OCTREE_DEPTH];
    vec3 points[3];
    int lists[1];
    octree o;
    mesh m;
} corner_tree;

static const int only_corners[1][3] = {{0, 1, 2}};

static vec3 corner_of(aabb cell, int i) {
    return (vec3){i & 1 ? cell.max.x : cell.min.x, i & 2 ? cell.max.y : cell.min.y,
                  i & 4 ? cell.max.z : cell.min.z};
}

// The only triangle stands across the diagonal, in the deepest cell, or in the root's child at the
// other end.
static void corner_tree_make(corner_tree *k, int c, bool deep) {
    *k = (corner_tree){.lists = {0}};
    aabb cell = {{0, 0, 0}, {1, 1, 1}};
    const aabb cube = cell, other = cell_child(cell, 7 - c);
    int node = 0;
    for (int level = 0; level < OCTREE_DEPTH; level++) {
        k->nodes[node] = (octree_node){1 + 8 * level, -255};
        node = 1 + 8 * level + c;
        cell = cell_child(cell, c);
    }
    k->nodes[deep ? node : 1 + 7 - c] = (octree_node){0, 1};
    const int near = deep ? c : 7 - c;
    for (int axis = 0; axis < 3; axis++)
        k->points[axis] = corner_of(deep ? cell : other, near ^ 1 << axis);
    k->m = (mesh){.points = k->points, .corners = only_corners, .count = 1};
    k->o =
        (octree){.m = &k->m,
                 .how = {.leaf_size = 1, .depth = OCTREE_DEPTH, .memory = 200, .dense = true},
                 .cube = cube,
                 .nodes = k->nodes,
                 .lists = k->lists,
                 .node_count = COUNT(k->nodes),
                 .entry_count = 1};
}

static void nearest_full_stack(void) {
    static corner_tree k;
    const bool well = soup_goes_well();
    for (int i = 0; i < 32; i++) {
        const int c = i % 8;
        corner_tree_make(&k, c, i & 8);
        searches_begin(&k.o);
        trial.hint =
            well
                ? "In a tree of few levels it goes well, so it is the stack: at each level one "
                  "cell leaves it and eight enter it, 7 * OCTREE_DEPTH + 1 wait at the end. "
                  "That is OCTREE_STACK: has your stack as many?"
                : SHALLOW_TOO;
        const vec3 to = corner_of(k.o.cube, c), d = sub(scale(2, to), (vec3){1, 1, 1});
        const vec3 O = i & 16 ? add(to, scale(2, d)) : sub(to, scale(3, d));
        check_nearest((probe){{O, i & 16 ? neg(d) : d}, 0, NO_HIT},
                      "a diagonal: it meets all eight children on each level, 141 cells wait");
        searches_end();
    }
}

#endif
