// kd_split.c: candidate planes and what lies on their sides.
#include "chapters/13-kd-tree/kd_split.h"

static void try_plane(kd_plane *best, aabb cell, int axis, real split, int below, int above,
                      kd_options how) {
    if (!(split > along(cell.min, axis) && split < along(cell.max, axis))) return;
    const real cost = kd_cost(cell, axis, split, below, above, how);
    if (cost < best->cost) *best = (kd_plane){cost, axis, split};
}

// ---- all of few ------------------------------------------------------------------------

// Where an item ends, lies flat or begins along the axis.
typedef struct {
    real at;
    enum { END, FLAT, BEGIN } what;
} event;

// Which of `count` bins, each 1 / per_length wide, x lies in.
static int bin_of(real x, real low, real per_length, int count) {
    const real i = (x - low) * per_length;
    if (!(i > 0)) return 0; // NaN too
    return i < (real)count ? (int)i : count - 1;
}

// Each event into the bin where it lies, as many bins as events: nearly all are
// then in order, and to insert one after the other takes few steps. qsort takes five times as
// long.
static void sort(event *e, int n, real low, real high) {
    event rough[2 * KD_FEW];
    int next[2 * KD_FEW + 1]; // where the next event of a bin goes
    const real per_length = (real)n / (high - low);
    for (int i = 0; i <= n; i++) next[i] = 0;
    for (int i = 0; i < n; i++) next[bin_of(e[i].at, low, per_length, n) + 1]++;
    for (int i = 1; i < n; i++) next[i] += next[i - 1];
    for (int i = 0; i < n; i++) rough[next[bin_of(e[i].at, low, per_length, n)]++] = e[i];
    for (int i = 0; i < n; i++) {
        int j = i;
        for (; j > 0 && rough[i].at < e[j - 1].at; j--) e[j] = e[j - 1];
        e[j] = rough[i];
    }
}

// How many items lie below and above a plane that moves along.
typedef struct {
    int below, above;
} sides;

// The events inside the cell, in order. The others are no candidates and only count: what begins
// where the cell does is below all planes, what ends there above none.
static int events_of(event *e, sides *now, const bvh_item *items, int count, real from, real to,
                     int axis) {
    int n = 0;
    *now = (sides){0, count};
    for (int i = 0; i < count; i++) {
        const real low = along(items[i].box.min, axis), high = along(items[i].box.max, axis);
        const bool flat = low == high;
        now->below += low <= from;
        now->above -= high <= from;
        if (low > from && low < to) e[n++] = (event){low, flat ? FLAT : BEGIN};
        if (high > from && high < to && !flat) e[n++] = (event){high, END};
    }
    sort(e, n, from, to);
    return n;
}

// A plane goes through all events at one place. What ends there is no longer above, what
// begins not yet below, and what is flat below (kd_sides).
static void sweep(kd_plane *best, const bvh_item *items, int count, aabb cell, int axis,
                  kd_options how) {
    event e[2 * KD_FEW];
    sides now;
    const real from = along(cell.min, axis), to = along(cell.max, axis);
    const int n = events_of(e, &now, items, count, from, to, axis);
    for (int i = 0; i < n;) {
        const real split = e[i].at;
        int begin = 0;
        for (; i < n && e[i].at == split; i++) {
            now.above -= e[i].what != BEGIN;
            now.below += e[i].what == FLAT;
            begin += e[i].what == BEGIN;
        }
        try_plane(best, cell, axis, split, now.below, now.above, how);
        now.below += begin;
    }
}

// ---- some of many ------------------------------------------------------------------------

// How many items begin and end between two planes.
typedef struct {
    int begin[KD_BINS], end[KD_BINS];
} bins;

static void bin_planes(kd_plane *best, const bvh_item *items, int count, aabb cell, int axis,
                       kd_options how) {
    const real low = along(cell.min, axis), width = along(cell.max, axis) - low,
               per_length = KD_BINS / width;
    if (!isfinite(per_length)) return;
    bins b = {{0}, {0}};
    real first = INFINITY, last = -INFINITY;
    for (int i = 0; i < count; i++) {
        const real from = along(items[i].box.min, axis), to = along(items[i].box.max, axis);
        b.begin[bin_of(from, low, per_length, KD_BINS)]++;
        b.end[bin_of(to, low, per_length, KD_BINS)]++;
        first = lesser(first, from);
        last = greater(last, to);
    }
    int below = 0, above = count;
    for (int i = 1; i < KD_BINS; i++) {
        below += b.begin[i - 1];
        above -= b.end[i - 1];
        try_plane(best, cell, axis, low + (real)i * width / KD_BINS, below, above, how);
    }
    try_plane(best, cell, axis, first, 0, count, how);
    try_plane(best, cell, axis, last, count, 0, how);
}

kd_plane kd_best_plane(const bvh_item *items, int count, aabb cell, kd_options how) {
    kd_plane best = {(real)C_HIT * (real)count, -1, 0};
    if (!(aabb_area(cell) > 0)) return best;
    for (int axis = 0; axis < 3; axis++) {
        if (count <= KD_FEW)
            sweep(&best, items, count, cell, axis, how);
        else
            bin_planes(&best, items, count, cell, axis, how);
    }
    return best;
}
