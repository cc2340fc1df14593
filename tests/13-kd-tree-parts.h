// 13-kd-tree-parts.h: the part of 13-kd-tree.c about one plane: the order of the children, the
// sides of a primitive, the cost, the bounds of what is in a cell.
#ifndef TESTS_13_KD_TREE_PARTS_H
#define TESTS_13_KD_TREE_PARTS_H

#include <stdarg.h>
#include <stdio.h>

#include "chapters/13-kd-tree/kd_leaf.h"
#include "common/exact3.h"
#include "tests/check-generic.h"
#include "tests/check.h"

// As CHECK, with what is so instead printed in words.
static void check_words(int line, bool holds, const char *claim, const char *format, ...)
    __attribute__((format(printf, 4, 5)));
static void check_words(int line, bool holds, const char *claim, const char *format, ...) {
    char words[200];
    if (holds) return;
    va_list args;
    va_start(args, format);
    vsnprintf(words, sizeof words, format, args);
    va_end(args);
    check_that(__FILE__, line, words, false, claim);
}

// ---- kd_children -------------------------------------------------------------------------

// Three roundings stand behind t, and KD_LATER allows six more.
static const double t_slack = 8 * (double)REAL_EPSILON;
static const char *const t_why = "spans may reach further by a few roundings (8 REAL_EPSILON)";

typedef struct {
    span below, above;
    int first;
} sides_of_ray;

static bool visited(span s) {
    return s.t0 <= s.t1;
}

static sides_of_ray asked(real split, real O, real d, span in) {
    const kd_order o = kd_children(split, O, 1 / d, in);
    return (sides_of_ray){o.first ? o.far : o.near, o.first ? o.near : o.far, o.first};
}

static void given_plane(real split, real O, real d, span in) {
    given("the plane at %.9g; along its axis O = %.9g, d = %.9g; in the cell for t = %.9g to "
          "%.9g",
          (double)split, (double)O, (double)d, (double)in.t0, (double)in.t1);
}

#define NEAR_PART "kd_children(plane, O, 1 / d, in).near"
#define FAR_PART "kd_children(plane, O, 1 / d, in).far"

// The same, with the answer: what is below the plane and what above.
static void given_answer(real split, real O, real d, span in, sides_of_ray s) {
    given("the plane at %.9g; along its axis O = %.9g, d = %.9g; in the cell for t = %.9g to "
          "%.9g\nyour answer: below for t = %.9g to %.9g, above for t = %.9g to %.9g",
          (double)split, (double)O, (double)d, (double)in.t0, (double)in.t1, (double)s.below.t0,
          (double)s.below.t1, (double)s.above.t0, (double)s.above.t1);
}

// Is x, or x / size, 0.01, 0.001 … 1e-7, as somebody would write it?
static bool is_epsilon(double x, double size) {
    for (double e = 1e-2; e > 5e-8; e /= 10)
        if (fabs(fabs(x) / e - 1) < 0.02 || fabs(fabs(x / size) / e - 1) < 0.02) return true;
    return false;
}

static const char *const an_epsilon =
    "Rounding is off by less than KD_EARLIER and KD_LATER say: no epsilon besides.";

// Where a part ends or begins at the plane, and got is not t.
static void suspect_at_plane(double got, double t) {
    const double off = got - t;
    if (fabs(off) <= t_slack * fabs(t)) return;
    if (is_epsilon(off, t)) {
        suspect_value("t and an epsilon", got);
        hint_instead(an_epsilon);
    } else if (fabs(off) < 1e-4 * fabs(t)) {
        suspect_value("t, moved by more than KD_EARLIER or KD_LATER", got);
    }
}

static const char *const no_signbit = "first is 0 or 1, and signbit gives 0 or any other "
                                      "number: a comparison, inverse < 0, gives "
                                      "0 or 1.";
static const char *const near_and_far =
    "near is the part in the child that comes first, so it ends at the plane: [in.t0, min(t, "
    "in.t1)], whatever the sign of d. far begins there: [max(t, in.t0), in.t1]. The sign only "
    "says which child comes first.";

// Is it t but for rounding?
static bool is_at(real got, double t) {
    return fabs((double)got - t) <= t_slack * fabs(t);
}
static void suspect_at(real got, double t, const char *what) {
    if (is_at(got, t)) suspect_value(what, (double)got);
}

// Both children, the one below first (0) or the one above (1), parted at t.
static void check_both(real split, real O, real d, span in, int first, double t) {
    const kd_order o = kd_children(split, O, 1 / d, in);
    given_plane(split, O, d, in);
    if (o.first != 0 && o.first != 1) hint_instead(no_signbit);
    suspect_value("the order of another ray: which child does it come to first?", 1 - first);
    check_int(__FILE__, __LINE__, "kd_children(plane, O, 1 / d, in).first", o.first, first);
    given_plane(split, O, d, in);
    if (is_at(o.near.t0, t) || is_at(o.far.t1, t)) hint_instead(near_and_far);
    suspect_at(o.near.t0, t, "t: the part behind the plane. near is the one before it");
    check_real(__FILE__, __LINE__, NEAR_PART ".t0", (double)o.near.t0, (double)in.t0,
               exactly());
    suspect_at(o.far.t1, t, "t: the part before the plane. far is the one behind it");
    check_real(__FILE__, __LINE__, FAR_PART ".t1", (double)o.far.t1, (double)in.t1, exactly());
    suspect_value("minus t: (plane - O) / d", -t);
    suspect_value("the end of the cell: the near part ends at the plane", (double)in.t1);
    suspect_value("divided by inverse, which is 1 / d",
                  ((double)split - (double)O) * (double)d);
    suspect_at_plane((double)o.near.t1, t);
    check_real(__FILE__, __LINE__, NEAR_PART ".t1", (double)o.near.t1, t,
               relative_to(t_slack, t_why));
    given_plane(split, O, d, in);
    suspect_value("the start in the cell: the far part begins at the plane", (double)in.t0);
    suspect_at_plane((double)o.far.t0, t);
    check_real(__FILE__, __LINE__, FAR_PART ".t0", (double)o.far.t0, t,
               relative_to(t_slack, t_why));
}

static void children_by_hand(void) {
    check_both(3, 1, 0.5f, (span){1, 10}, 0, 4);
    check_both(3, 5, -0.5f, (span){1, 10}, 1, 4);
    check_both(-2, -7, 2, (span){0, 3}, 0, 2.5);
    check_both(-2, 6, -4, (span){0.5f, 3}, 1, 2);
}

static const char *const not_cut =
    "A part ends with the cell: its end is the smaller of t and in.t1, its beginning the "
    "larger "
    "of t and in.t0. Else the walk goes on into cells that the ray has left.";

// What is said of a child's part: where it is, or that it is empty.
static void check_part(int line, bool holds, const char *claim, const char *child, span s) {
    check_words(line, holds, claim,
                visited(s) ? "%s for t = %.9g to %.9g"
                           : "%s for t = %.9g to %.9g, which is empty",
                child, (double)s.t0, (double)s.t1);
}

// A part that is visited lies in the cell but for roundings.
static void check_in_cell(span part, span in, const char *child) {
    const double slack = t_slack;
    if (!visited(part)) return;
    hint_instead(not_cut);
    check_part(__LINE__, part.t1 <= in.t1 * (1 + slack),
               "no part reaches beyond the cell's end (in.t1)", child, part);
    check_part(__LINE__, part.t0 >= in.t0 * (1 - slack),
               "no part begins before the cell (in.t0)", child, part);
}

// Only one child, below (0) or above (1), for all of the span.
static void check_one(real split, real O, real d, span in, int which, const char *why) {
    const sides_of_ray s = asked(split, O, d, in);
    const span yes = which ? s.above : s.below, no = which ? s.below : s.above;
    const char *const all = which ? "above" : "below", *const none = which ? "below" : "above";
    given("the plane at %.9g; along its axis O = %.9g, d = %.9g; in the cell for t = %.9g to "
          "%.9g\n%s\nyour answer: below for t = %.9g to %.9g, above for t = %.9g to %.9g",
          (double)split, (double)O, (double)d, (double)in.t0, (double)in.t1, why,
          (double)s.below.t0, (double)s.below.t1, (double)s.above.t0, (double)s.above.t1);
    if (s.first != 0 && s.first != 1) hint_instead(no_signbit);
    check_part(__LINE__, yes.t0 <= in.t0 && yes.t1 >= in.t1,
               which ? "the whole span is above the plane"
                     : "the whole span is below the plane",
               all, yes);
    check_part(__LINE__, !visited(no),
               which ? "nothing of it is below" : "nothing of it is above", none, no);
    check_in_cell(yes, in, all);
}

static void children_one(void) {
    const span in = {1, 10};
    check_one(3, 1, 0.125f, in, 0, "the plane is met behind the cell, at t = 16");
    check_one(3, 5, -0.125f, in, 1, "the plane is met behind the cell, at t = 16");
    check_one(3, 1, 4, in, 1, "the plane is met before the cell, at t = 0.5");
    check_one(3, 5, -4, in, 0, "the plane is met before the cell, at t = 0.5");
    check_one(3, 5, 0.5f, in, 1, "the plane lies behind O, at t = -4: O's side is not below");
    check_one(3, 1, -0.5f, in, 0, "the plane lies behind O, at t = -4: O's side is not above");
}

static void children_along(void) {
    const span in = {1, 10};
    for (int i = 0; i < 2; i++) {
        const real d = i ? -(real)0.0 : (real)0.0;
        check_one(3, 1, d, in, 0, "along the plane, below it");
        check_one(3, 5, d, in, 1, "along the plane, above it");
        const sides_of_ray s = asked(3, 3, d, in);
        given_answer(3, 3, d, in, s);
        const char *const both = "a ray in the plane is in both children all the way";
        check_part(__LINE__, s.below.t0 <= in.t0 && s.below.t1 >= in.t1, both, "below",
                   s.below);
        check_part(__LINE__, s.above.t0 <= in.t0 && s.above.t1 >= in.t1, both, "above",
                   s.above);
        check_in_cell(s.below, in, "below");
        check_in_cell(s.above, in, "above");
    }
}

// From the plane itself: at t > 0 it is on one side only.
static void children_on_plane(void) {
    for (int i = 0; i < 2; i++) {
        const real d = i ? (real)-0.3 : (real)0.3;
        const sides_of_ray s = asked((real)1.7, (real)1.7, d, (span){0, 9});
        const span yes = i ? s.below : s.above, no = i ? s.above : s.below;
        given_answer((real)1.7, (real)1.7, d, (span){0, 9}, s);
        const char *const to = i ? "below" : "above", *const from = i ? "above" : "below";
        check_part(__LINE__, yes.t0 <= 0 && yes.t1 >= 9,
                   "from t = 0 on it is on the side that d points to", to, yes);
        check_part(__LINE__, visited(no) && no.t0 <= 0 && no.t1 >= 0,
                   "t = 0 is in the plane, which belongs to both sides", from, no);
        if (is_epsilon((double)no.t1, 1)) hint_instead(an_epsilon);
        check_part(__LINE__, !visited(no) || no.t1 <= 0, "and at no t > 0 on the other", from,
                   no);
        check_in_cell(yes, (span){0, 9}, to);
    }
}

static const char *const no_part =
    "There the ray has no part of the cell. For d > 0 it is below until t and above from t on, "
    "for d < 0 the other way round; t times KD_LATER or KD_EARLIER, and no more besides.";
static const char *const cut_short =
    "By a rounding: what lies before the plane ends a little later, what lies behind begins a "
    "little earlier (KD_LATER, KD_EARLIER).";
static const char *const misplaced =
    "More than rounding. For d > 0 the ray is below until t and above from t on, for d < 0 the "
    "other way round; and never outside in.t0 to in.t1.";

static const char *const too_early =
    "The plane lies at an end of the cell, but for rounding: t was compared with in.t0 or "
    "in.t1 "
    "before it was widened. First KD_LATER and KD_EARLIER, then the comparisons.";

// A part ends or begins at `got`, and should at `want`: what does the difference look like?
static const char *about_span(real got, exact want) {
    const double off = (double)((exact)got - want), size = fabs((double)want);
    if (!(fabs(off) > t_slack * size)) return cut_short;
    return is_epsilon(off, size) ? an_epsilon : misplaced;
}

static bool is_beside(exact t, exact limit) {
    return fabs((double)(t - limit)) <= t_slack * fabs((double)limit);
}

// The parts of a ray that meets the plane at t.
typedef struct {
    span in, early, late;
    const char *before, *behind; // the children in words
    exact t;
} parting;

static void check_early(parting p) {
    const exact t0 = p.in.t0, t1 = p.in.t1, slack = t_slack;
    if (p.t >= t0) {
        const exact end = p.t < t1 ? p.t : t1;
        const bool lost =
            !visited(p.early) && is_beside(p.t, t0) && !is_beside(p.early.t1, p.t);
        hint_instead(lost                   ? too_early
                     : p.early.t0 > p.in.t0 ? misplaced
                                            : about_span(p.early.t1, end));
        check_part(__LINE__, p.early.t0 <= p.in.t0 && p.early.t1 >= end,
                   "the part before the plane is not cut short", p.before, p.early);
    } else {
        hint_instead(is_epsilon((double)(p.early.t1 - p.t), (double)p.t) ? an_epsilon
                                                                         : no_part);
        check_part(__LINE__, !visited(p.early) || p.t >= t0 * (1 - slack),
                   "the part before the plane is empty", p.before, p.early);
    }
    hint_instead(about_span(p.early.t1, p.t));
    if (visited(p.early) && p.t < t1)
        check_part(__LINE__, p.early.t1 <= p.t * (1 + slack),
                   "the part before the plane ends at it", p.before, p.early);
    check_in_cell(p.early, p.in, p.before);
}

static void check_late(parting p) {
    const exact t0 = p.in.t0, t1 = p.in.t1, slack = t_slack;
    if (p.t <= t1) {
        const exact begin = p.t > t0 ? p.t : t0;
        const bool lost = !visited(p.late) && is_beside(p.t, t1) && !is_beside(p.late.t0, p.t);
        hint_instead(lost                  ? too_early
                     : p.late.t1 < p.in.t1 ? misplaced
                                           : about_span(p.late.t0, begin));
        check_part(__LINE__, p.late.t0 <= begin && p.late.t1 >= p.in.t1,
                   "the part behind the plane is not cut short", p.behind, p.late);
    } else {
        hint_instead(is_epsilon((double)(p.late.t0 - p.t), (double)p.t) ? an_epsilon : no_part);
        check_part(__LINE__, !visited(p.late) || p.t <= t1 * (1 + slack),
                   "the part behind the plane is empty", p.behind, p.late);
    }
    hint_instead(about_span(p.late.t0, p.t));
    if (visited(p.late) && p.t > t0)
        check_part(__LINE__, p.late.t0 >= p.t * (1 - slack),
                   "the part behind the plane begins at it", p.behind, p.late);
    check_in_cell(p.late, p.in, p.behind);
}

// The reference: where is O + t d <= split, where >=, without rounding.
static void check_spans(real split, real O, real d, span in) {
    const exact t = ((exact)split - O) / d;
    const exact t0 = in.t0, t1 = in.t1, slack = t_slack;
    const sides_of_ray s = asked(split, O, d, in);
    const parting p = {in,
                       d > 0 ? s.below : s.above,
                       d > 0 ? s.above : s.below,
                       d > 0 ? "below" : "above",
                       d > 0 ? "above" : "below",
                       t};
    given_answer(split, O, d, in, s);
    check_early(p);
    check_late(p);
    hint_instead(s.first == 0 || s.first == 1 ? "The sign of d says which child comes first."
                                              : no_signbit);
    if (t > t0 * (1 + slack) && t < t1 * (1 - slack))
        check_words(__LINE__, s.first == (d > 0 ? 0 : 1),
                    d > 0 ? "first = 0: the child below comes first"
                          : "first = 1: the child above comes first",
                    "first = %d", s.first);
}

// Right for the planes by hand: then another test's failure is not its fault.
static bool children_are_right(void) {
    static const real rows[][4] = {{3, 1, 0.5f, 4},     {3, 5, -0.5f, 4}, {3, 1, 0.125f, 16},
                                   {3, 5, -0.125f, 16}, {3, 1, 4, 0.5f},  {3, 5, -4, 0.5f},
                                   {3, 5, 0.5f, -4},    {3, 1, -0.5f, -4}};
    for (int i = 0; i < COUNT(rows); i++) {
        const real d = rows[i][2], t = rows[i][3];
        const sides_of_ray s = asked(rows[i][0], rows[i][1], d, (span){1, 10});
        const span early = d > 0 ? s.below : s.above, late = d > 0 ? s.above : s.below;
        const bool both = t > 1 && t < 10;
        if (visited(early) != (t > 1) || visited(late) != (t < 10)) return false;
        if (both && !(is_at(early.t1, (double)t) && is_at(late.t0, (double)t))) return false;
        if (both && s.first != (d > 0 ? 0 : 1)) return false;
    }
    const sides_of_ray in = asked(3, 3, -(real)0.0, (span){1, 10});
    return in.below.t0 <= 1 && in.below.t1 >= 10 && in.above.t0 <= 1 && in.above.t1 >= 10;
}

static void children_generic(void) {
    rng g = check_rng(1301);
    for (int i = 0; i < 200000; i++) {
        const real size = (real)pow(10, between(&g, -4, 6));
        const real split = (real)between(&g, -1, 1) * size, O = (real)between(&g, -1, 1) * size;
        const real d = (real)(between(&g, -1, 1) * pow(10, between(&g, -6, 6)));
        if (d == 0 || O == split) continue;
        const real t = fabs((split - O) / d), a = (real)between(&g, 0, 2) * t;
        // Cells as thin as a rounding, and cells that begin or end in the plane.
        const real width = (real)pow(10, between(&g, -9, 1)) * t;
        span in = {a, a + width};
        if (i % 4 == 1) in = (span){t, t + width};
        if (i % 4 == 2) in = (span){fmax(0, t - width), t};
        if (i % 40 == 3) in = (span){t, t};
        check_spans(split, O, d, in);
    }
}

// ---- kd_sides ------------------------------------------------------------------------------

static aabb slab_of(int axis, real low, real high) {
    aabb box = {{-3, -5, -7}, {11, 13, 17}};
    (&box.min.x)[axis] = low;
    (&box.max.x)[axis] = high;
    return box;
}

// What an answer other than `want` means. Flat and in the plane: `flat`.
static void about_sides(int got, int want, bool flat) {
    const int both = KD_BELOW | KD_ABOVE;
    if (got == want) return;
    if (got == 0) {
        suspect_value("in no child: the primitive is lost", 0);
        hint_instead(
            flat ? "It is neither below nor above: one of the comparisons must let it "
                   "in. Flat ones go below."
                 : "Some part of the box lies on a side of the plane: below it when low "
                   "< plane, above it when high > plane.");
    } else if (got == both) {
        suspect_value("in both: a reference more than needed", both);
        hint_instead(
            "What only touches the plane has no part behind it. Is there a <= or >= too "
            "many?");
    } else if (got != KD_BELOW && got != KD_ABOVE) {
        suspect_value("no answer: KD_BELOW, KD_ABOVE or both (|), that is 1, 2 or 3", got);
    } else if (want == both) {
        suspect_value(got == KD_BELOW ? "only in the child below: its part above is lost"
                                      : "only in the child above: its part below is lost",
                      got);
        hint_instead("The plane cuts it: each child holds a part, so both list it. Where it "
                     "begins or where its centre is does not decide.");
    } else {
        suspect_value(flat ? "in the child above: flat ones go below" : "in the other child",
                      got);
        if (!flat)
            hint_instead("Below is where the coordinate is smaller. Which of low and high "
                         "is compared with the plane for which child?");
    }
}

static void sides_by_hand(void) {
    static const struct {
        real low, high;
        int sides;
        const char *what;
    } rows[] = {
        {1, 2, KD_BELOW, "the box ends before the plane"},
        {4, 6, KD_ABOVE, "the box begins behind the plane"},
        {1, 6, KD_BELOW | KD_ABOVE, "the plane cuts the box"},
        {1, 3, KD_BELOW, "the box touches the plane from below"},
        {3, 6, KD_ABOVE, "the box touches the plane from above"},
        {3, 3, KD_BELOW, "the box is flat and lies in the plane"},
        {2, 2, KD_BELOW, "the box is flat and lies below the plane"},
        {4, 4, KD_ABOVE, "the box is flat and lies above the plane"},
    };
    for (int axis = 0; axis < 3; axis++)
        for (int i = 0; i < COUNT(rows); i++) {
            const int got = kd_sides(slab_of(axis, rows[i].low, rows[i].high), axis, 3);
            given("the plane at 3 across axis %d; a box from %g to %g along it\n%s", axis,
                  (double)rows[i].low, (double)rows[i].high, rows[i].what);
            about_sides(got, rows[i].sides, rows[i].low == 3 && rows[i].high == 3);
            check_int(__FILE__, __LINE__, "kd_sides(box, axis, 3)", got, rows[i].sides);
        }
}

static void sides_generic(void) {
    rng g = check_rng(1302);
    for (int i = 0; i < 20000; i++) {
        const int axis = i % 3;
        real low = (real)between(&g, -1, 1), high = (real)between(&g, -1, 1);
        if (low > high) {
            const real swap = low;
            low = high, high = swap;
        }
        const real split = (real)between(&g, -1, 1);
        const int want = (low < split ? KD_BELOW : 0) | (high > split ? KD_ABOVE : 0);
        given("the plane at %.9g across axis %d; a box from %.9g to %.9g along it",
              (double)split, axis, (double)low, (double)high);
        const int got = kd_sides(slab_of(axis, low, high), axis, split);
        about_sides(got, want, false);
        check_int(__FILE__, __LINE__, "kd_sides(box, axis, plane)", got, want);
    }
}

// ---- kd_cost -------------------------------------------------------------------------------

static void given_cost(aabb c, int axis, real split, int below, int above, kd_options how) {
    given("a cell from " VEC " to " VEC
          "\nthe plane at %.9g across axis %d; %d below, %d above; "
          "step = %.9g, bonus = %.9g",
          ARG(c.min), ARG(c.max), (double)split, axis, below, above, (double)how.step,
          (double)how.bonus);
}

// Sides 3, 4, 2: area 2 (12 + 8 + 6) = 52. No two of the wrong answers foreseen are near each
// other.
static const aabb cost_cell = {{1, 2, 3}, {4, 6, 5}};
static const kd_options cost_how = {.step = (real)0.6, .bonus = (real)0.3};
#define COST_CALL "kd_cost(cell, axis, plane, n_below, n_above, how)"
static const char *const hand_first =
    "It fails by hand, too: that one first (\"kd_cost: by hand\").";

// 6 below, where the sides are 2, 4, 2: area 40; 4 above, 1, 4, 2: 28.
static double cost_hand_hits(void) {
    return (6 * 40 + 4 * 28) / 52.0;
}
static bool cost_is_right_by_hand(void) {
    const double want = (double)cost_how.step + cost_hand_hits();
    return fabs((double)kd_cost(cost_cell, 0, 3, 6, 4, cost_how) - want) <= 1e-5 * want;
}

static void cost_by_hand(void) {
    const double step = (double)cost_how.step, bonus = (double)cost_how.bonus;
    const double hits = cost_hand_hits();
    given_cost(cost_cell, 0, 3, 6, 4, cost_how);
    suspect_value("no step", hits);
    suspect_value("C_STEP, the BVH's: here a plane costs how.step", C_STEP + hits);
    suspect_value("C_STEP besides how.step", C_STEP + step + hits);
    suspect_value("not divided by the area of the cell", step + 52 * hits);
    suspect_value("the step divided by the area of the cell, too", (step + 52 * hits) / 52);
    suspect_value("the bonus, though no child is empty", step + (1 - bonus) * hits);
    suspect_value("the bonus, though no child is empty", (1 - bonus) * (step + hits));
    suspect_value("below and above exchanged", step + (6 * 28 + 4 * 40) / 52.0);
    suspect_value("areas without their factor 2 over A with it", step + hits / 2);
    suspect_value("split and cell.max as sides: a side is a difference",
                  step + (6 * 52 + 4 * 64) / 52.0);
    suspect_value("split as a side: it is measured from cell.min",
                  step + (6 * 52 + 4 * 28) / 52.0);
    suspect_value("cell.max as a side: it is measured from split",
                  step + (6 * 40 + 4 * 64) / 52.0);
    suspect_value("volumes, not areas", step + (6 * 16 + 4 * 8) / 24.0);
    suspect_value("the counts alone, no areas", step + 10);
    suspect_value("whole numbers divided: areas are real", step + floor(hits));
    check_real(__FILE__, __LINE__, COST_CALL, (double)kd_cost(cost_cell, 0, 3, 6, 4, cost_how),
               step + hits, roundings(16, "a handful of operations"));
}

// One child is empty, 13 are in the other, of area A; the empty one's is `other`.
static void cost_of_empty(int below, int above, double A, double other) {
    const double step = (double)cost_how.step, bonus = (double)cost_how.bonus;
    const double hits = 13 * A / 52;
    given_cost(cost_cell, 1, 5, below, above, cost_how);
    if (!cost_is_right_by_hand()) hint_instead(hand_first);
    suspect_value("without the bonus: one child is empty", step + hits);
    suspect_value("the bonus was subtracted, not multiplied: 1 - bonus", step + hits - bonus);
    suspect_value("the bonus was added, not multiplied: 1 - bonus", step + hits + bonus);
    suspect_value("multiplied by the bonus: 1 - bonus is what is left", step + bonus * hits);
    suspect_value("the bonus on the step too", (1 - bonus) * (step + hits));
    suspect_value("the bonus on the step, not on the hits' part", (1 - bonus) * step + hits);
    suspect_value("the cost grew: 1 + bonus", step + (1 + bonus) * hits);
    suspect_value("divided by 1 + bonus", step + hits / (1 + bonus));
    suspect_value("divided by 1 - bonus: multiplied, it is cheaper", step + hits / (1 - bonus));
    suspect_value("nothing but the step: the child that is not empty costs, too", step);
    suspect_value("no step", (1 - bonus) * hits);
    suspect_value("C_STEP, the BVH's: here a plane costs how.step",
                  C_STEP + (1 - bonus) * hits);
    suspect_value("below and above exchanged", step + (1 - bonus) * 13 * other / 52);
    suspect_value("the counts alone, no areas", step + (1 - bonus) * 13);
    suspect_value("whole numbers divided: areas are real", step + (1 - bonus) * floor(hits));
    check_real(__FILE__, __LINE__, COST_CALL,
               (double)kd_cost(cost_cell, 1, 5, below, above, cost_how),
               step + (1 - bonus) * hits, roundings(16, "a handful of operations"));
}

static void cost_empty(void) {
    cost_of_empty(0, 13, 22, 42); // sides 3, 1, 2 and 3, 3, 2
    cost_of_empty(13, 0, 42, 22);
}

static double area_of(const double e[3]) {
    return 2 * (e[0] * e[1] + e[1] * e[2] + e[2] * e[0]);
}

static void cost_generic(void) {
    rng g = check_rng(1303);
    for (int i = 0; i < 3000; i++) {
        const real size = (real)pow(10, between(&g, -5, 5));
        const vec3 low = scale(size, in_cube(&g)),
                   e = scale(size, add(in_cube(&g), (vec3){1.5f, 1.5f, 1.5f}));
        const aabb cell = {low, add(low, e)};
        const int axis = i % 3, below = i % 5 ? (int)between(&g, 0, 90) : 0,
                  above = i % 7 ? (int)between(&g, 0, 9000) : 0;
        const real split = along(low, axis) + rng_real(&g) * along(e, axis);
        const kd_options how = {.step = (real)between(&g, 0, 2), .bonus = rng_real(&g)};
        double part[3][3]; // the sides of the cell, below and above
        for (int k = 0; k < 3; k++)
            part[0][k] = part[1][k] = part[2][k] =
                (double)along(cell.max, k) - (double)along(cell.min, k);
        part[1][axis] = (double)split - (double)along(cell.min, axis);
        part[2][axis] = (double)along(cell.max, axis) - (double)split;
        const double hits =
            (below * area_of(part[1]) + above * area_of(part[2])) / area_of(part[0]);
        const bool empty = below == 0 || above == 0;
        given_cost(cell, axis, split, below, above, how);
        if (empty)
            hint_instead("Here a child is empty, or both are. Does \"kd_cost: one child is "
                         "empty\" fail, too? That one first.");
        if (!cost_is_right_by_hand()) hint_instead(hand_first);
        suspect_value("without the bonus: one child is empty", (double)how.step + hits);
        suspect_value("C_STEP, the BVH's: here a plane costs how.step",
                      C_STEP + (empty ? 1 - (double)how.bonus : 1) * hits);
        suspect_value("the bonus, though no child is empty",
                      (double)how.step + (1 - (double)how.bonus) * hits);
        check_real(__FILE__, __LINE__, COST_CALL,
                   (double)kd_cost(cell, axis, split, below, above, how),
                   (double)how.step + (empty ? 1 - (double)how.bonus : 1) * hits,
                   roundings(24, "a handful of operations"));
    }
}

// ---- kd_clip -------------------------------------------------------------------------------

static void given_clip(triangle T, aabb cell) {
    given("T = " VEC ", " VEC ", " VEC "\nthe cell from " VEC " to " VEC, ARG(T.p1), ARG(T.p2),
          ARG(T.p3), ARG(cell.min), ARG(cell.max));
}

static bool box_is_empty(aabb a) {
    return !(a.min.x <= a.max.x && a.min.y <= a.max.y && a.min.z <= a.max.z);
}

static allowance clip_allowance(double size) {
    return absolute_of(64 * DBL_EPSILON * size + 2 * (double)REAL_EPSILON * size,
                       "outwards by a few roundings of the coordinates at most");
}

static void check_clip(triangle T, aabb cell, vec3 min, vec3 max) {
    const aabb whole = aabb_of(T);
    const real size = fmax(length(whole.min), length(whole.max));
    given_clip(T, cell);
    suspect_vec3("the bounds of T itself, cut at the cell: the part of T in it is smaller",
                 (vec3){greater(whole.min.x, cell.min.x), greater(whole.min.y, cell.min.y),
                        greater(whole.min.z, cell.min.z)});
    suspect_vec3("the bounds of the corners in the cell: where edges leave it is missing",
                 whole.min);
    CHECK_VEC3(kd_clip(T, cell).min, min, clip_allowance((double)size));
    given_clip(T, cell);
    suspect_vec3("the bounds of T itself, cut at the cell: the part of T in it is smaller",
                 (vec3){lesser(whole.max.x, cell.max.x), lesser(whole.max.y, cell.max.y),
                        lesser(whole.max.z, cell.max.z)});
    CHECK_VEC3(kd_clip(T, cell).max, max, clip_allowance((double)size));
}

#define P(x, y, z) ((vec3){(real)(x), (real)(y), (real)(z)})

static void clip_by_hand(void) {
    const triangle T = {P(0, 0, 1), P(8, 0, 5), P(0, 4, 3)}; // z = 1 + x / 2 + y / 2
    check_clip(T, (aabb){P(-9, -9, -9), P(9, 9, 9)}, P(0, 0, 1), P(8, 4, 5));
    check_clip(T, (aabb){P(4, -9, -9), P(9, 9, 9)}, P(4, 0, 3), P(8, 2, 5));
    check_clip(T, (aabb){P(-9, -9, -9), P(2, 9, 9)}, P(0, 0, 1), P(2, 4, 3.5));
    check_clip(T, (aabb){P(1, 1, 0), P(2, 2, 9)}, P(1, 1, 2), P(2, 2, 3));
    check_clip(T, (aabb){P(-9, -9, 4), P(9, 9, 9)}, P(4, 0, 4), P(8, 2, 5));
    // No corner in the cell, and only one edge through it.
    check_clip(T, (aabb){P(3, 1.5, -9), P(9, 2, 9)}, P(3, 1.5, 3.25), P(5, 2, 4.25));
}

// Near a corner of the cell the bounds of T overlap it, and T itself does not.
static void clip_nothing(void) {
    const triangle T = {P(0, 0, 1), P(8, 0, 5), P(0, 4, 3)};
    const aabb outside[] = {
        {P(6, 3, -9), P(9, 9, 9)}, {P(-9, -9, -9), P(9, 9, 0.5)}, {P(9, 9, 9), P(10, 10, 10)}};
    for (int i = 0; i < COUNT(outside); i++) {
        given_clip(T, outside[i]);
        CHECK(box_is_empty(kd_clip(T, outside[i])), "no part of T is in the cell");
    }
}

// A corner or an edge in a side of the cell, which is closed; flat triangles in one.
static void clip_touching(void) {
    const triangle T = {P(0, 0, 1), P(8, 0, 5), P(0, 4, 3)},
                   flat = {P(2, 0, 1), P(2, 3, 1), P(2, 0, 5)};
    check_clip(T, (aabb){P(8, -9, -9), P(9, 9, 9)}, P(8, 0, 5), P(8, 0, 5));
    check_clip(T, (aabb){P(-9, -9, -9), P(9, 0, 9)}, P(0, 0, 1), P(8, 0, 5));
    check_clip(T, (aabb){P(-9, 4, -9), P(0, 9, 9)}, P(0, 4, 3), P(0, 4, 3));
    check_clip(flat, (aabb){P(2, 1, -9), P(9, 9, 9)}, P(2, 1, 1), P(2, 3, 11.0 / 3));
    check_clip(flat, (aabb){P(-9, -9, -9), P(2, 9, 2)}, P(2, 0, 1), P(2, 3, 2));
}

typedef struct {
    exact x[3];
} exact_point;

// Sutherland and Hodgman without rounding to speak of, in a cell larger by `grown`. Returns how
// many corners are left.
static int exact_clip(triangle T, aabb cell, double grown, exact_point *p) {
    int n = 3;
    const vec3 corners[] = {T.p1, T.p2, T.p3};
    for (int i = 0; i < 3; i++)
        p[i] = (exact_point){{corners[i].x, corners[i].y, corners[i].z}};
    for (int side = 0; side < 6; side++) {
        const int axis = side / 2, sign = side % 2 ? 1 : -1;
        const exact at = along(sign > 0 ? cell.max : cell.min, axis) + (exact)sign * grown;
        exact_point q[16];
        int m = 0;
        for (int i = 0; i < n; i++) {
            const exact_point a = p[i], b = p[(i + 1) % n];
            const exact da = sign * (at - a.x[axis]), db = sign * (at - b.x[axis]);
            if (da >= 0) q[m++] = a;
            if ((da >= 0) == (db >= 0)) continue;
            for (int k = 0; k < 3; k++) q[m].x[k] = a.x[k] + da / (da - db) * (b.x[k] - a.x[k]);
            q[m++].x[axis] = at;
        }
        for (int i = 0; i < m; i++) p[i] = q[i];
        n = m;
    }
    return n;
}

static void exact_bounds(const exact_point *p, int n, int axis, exact *low, exact *high) {
    *low = *high = p[0].x[axis];
    for (int i = 1; i < n; i++) {
        if (p[i].x[axis] < *low) *low = p[i].x[axis];
        if (p[i].x[axis] > *high) *high = p[i].x[axis];
    }
}

// Larger by roundings: what is in a cell larger by some, and then some more. A steep triangle
// leaves a slightly larger cell far from where it leaves the cell.
static void check_clip_exactly(triangle T, aabb cell) {
    const aabb box = kd_clip(T, cell), whole = aabb_of(T);
    const double size = wide_length(whole.min) + wide_length(whole.max);
    const double slack = (64 * DBL_EPSILON + 2 * (double)REAL_EPSILON) * size;
    const exact least = (exact)1e-30 * size; // the reference is rounded in its 33rd digit
    exact_point part[16], more[16];
    const int n = exact_clip(T, cell, 0, part), m = exact_clip(T, cell, slack, more);
    given_clip(T, cell);
    hint_instead(
        "The cell is closed. Is it larger by the margin before T is cut, and all in double?");
    CHECK(n == 0 || !box_is_empty(box), "a part of T is in the cell: the bounds are not empty");
    hint_instead("When no corner of the polygon is left: aabb_empty. Is the margin a few "
                 "roundings of double, not of real?");
    CHECK(m > 0 || box_is_empty(box), "no part of T is near the cell: the bounds are empty");
    if (box_is_empty(box)) return;
    for (int k = 0; k < 3; k++) {
        exact low, high;
        const exact min = along(box.min, k), max = along(box.max, k);
        hint_instead("Rounding outwards comes before the last step, the cell's own sides.");
        CHECK(along(box.min, k) >= along(cell.min, k) &&
                  along(box.max, k) <= along(cell.max, k),
              "the bounds stay in the cell");
        if (n > 0) {
            exact_bounds(part, n, k, &low, &high);
            hint_instead(min - low > slack || high - max > slack
                             ? "By more than rounding: is every corner kept that lies in the "
                               "cell, and every crossing?"
                             : "A crossing is rounded. Which way must the bounds go so that "
                               "nothing is lost? Is all of it in double?");
            CHECK(min <= low + least && max >= high - least,
                  "nothing of the part in the cell lies outside the bounds");
        }
        exact_bounds(more, m, k, &low, &high);
        hint_instead("Is T cut at all six planes? Is the margin a few roundings of double, not "
                     "of real?");
        CHECK(min >= low - slack && max <= high + slack,
              "the bounds are larger than the part of T in the cell by roundings at most");
    }
}

static void clip_generic(void) {
    rng g = check_rng(1304);
    for (int i = 0; i < 60000; i++) {
        const real size = (real)pow(10, between(&g, -4, 4));
        const vec3 at = scale(size * (real)pow(10, between(&g, -2, 3)), in_cube(&g));
        const vec3 p1 = add(at, scale(size, in_cube(&g))),
                   p2 = add(at, scale(size, in_cube(&g)));
        vec3 p3 = add(at, scale(size, in_cube(&g)));
        if (i % 5 == 1)
            p3 = add(lerp(p1, p2, (real)0.3), scale((real)1e-5 * size, in_cube(&g)));
        const vec3 a = add(at, scale(size, in_cube(&g))), b = add(at, scale(size, in_cube(&g)));
        aabb cell = aabb_with((aabb){a, a}, b);
        if (i % 7 == 2) cell = aabb_with((aabb){a, a}, p1); // a corner in the cell's corner
        check_clip_exactly((triangle){p1, p2, p3}, cell);
    }
}

#endif
