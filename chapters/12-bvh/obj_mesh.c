// obj_mesh.c: see obj_inside.h. A corner of a file names a point and a normal; a corner of a
// mesh has one index for both.
#include <limits.h>
#include <stdlib.h>

#include "chapters/12-bvh/obj_inside.h"
#include "common/wide3.h"

static bool grow(obj_list *list) {
    enum { FIRST = 64 };
    if (list->room == INT_MAX) return false;
    const int twice = list->room > INT_MAX / 2 ? INT_MAX : 2 * list->room;
    const int room = list->room > 0 ? twice : FIRST;
    if ((size_t)room > SIZE_MAX / list->size) return false;
    void *items = realloc(list->items, (size_t)room * list->size);
    if (!items) return false;
    list->items = items;
    list->room = room;
    return true;
}

void *obj_add(obj_list *list) {
    if (list->count == list->room && !grow(list)) return NULL;
    return (char *)list->items + (size_t)list->count++ * list->size;
}

// ---- points with several normals ---------------------------------------------------------

// A point goes with the normal of its first use. Each other normal makes a twin of it.
enum { UNUSED = -2 };

typedef struct {
    int normal; // that of the first use, or UNUSED
    int number; // the point's index in the mesh
} first_use;

typedef struct {
    const obj_parts *parts;
    bool flat;
    first_use *first; // of each point
    int used;         // points that are
    obj_list twins;   // of obj_corner
    int *table;       // finds twins: index + 1, or 0, where the hash of the corner leads
    size_t mask;      // its size - 1; the size is a power of two
} splitter;

static obj_corner corner_of(const splitter *s, int i, int k) {
    const obj_corner c = ((const obj_corner(*)[3])s->parts->triangles.items)[i][k];
    return s->flat ? (obj_corner){c.point, OBJ_NO_NORMAL} : c;
}

// How many corners have another normal than that of the first use: as many twins, or fewer.
static size_t note_first_uses(splitter *s) {
    size_t others = 0;
    for (int i = 0; i < s->parts->points.count; i++) s->first[i].normal = UNUSED;
    for (int i = 0; i < s->parts->triangles.count; i++)
        for (int k = 0; k < 3; k++) {
            const obj_corner c = corner_of(s, i, k);
            int *normal = &s->first[c.point].normal;
            if (*normal == UNUSED) *normal = c.normal;
            if (*normal != c.normal) others++;
        }
    for (int i = 0; i < s->parts->points.count; i++)
        if (s->first[i].normal != UNUSED) s->first[i].number = s->used++;
    return others;
}

static bool make_table(splitter *s, size_t entries) {
    size_t size = 1;
    while (size / 2 < entries) size *= 2; // at most half full
    s->mask = size - 1;
    s->table = calloc(size, sizeof *s->table);
    return s->table;
}

static size_t hash(obj_corner c) {
    uint64_t h = (uint64_t)c.point << 32 | (uint32_t)c.normal;
    h = (h ^ h >> 31) * 0x9e3779b97f4a7c15; // 2^64 over the golden ratio, odd
    h = (h ^ h >> 29) * 0x9e3779b97f4a7c15;
    return (size_t)(h ^ h >> 32);
}

// The index of the corner among the twins, or -1: no room.
static int twin(splitter *s, obj_corner c) {
    const obj_corner *twins = s->twins.items;
    size_t i = hash(c) & s->mask;
    for (; s->table[i]; i = (i + 1) & s->mask) {
        const int old = s->table[i] - 1;
        if (twins[old].point == c.point && twins[old].normal == c.normal) return old;
    }
    if (s->twins.count >= INT_MAX - s->used) return -1;
    obj_corner *added = obj_add(&s->twins);
    if (!added) return -1;
    *added = c;
    s->table[i] = s->twins.count;
    return s->twins.count - 1;
}

static bool fill_corners(splitter *s, int (*corners)[3]) {
    for (int i = 0; i < s->parts->triangles.count; i++)
        for (int k = 0; k < 3; k++) {
            const obj_corner c = corner_of(s, i, k);
            const first_use first = s->first[c.point];
            const int t = c.normal == first.normal ? 0 : twin(s, c);
            if (t < 0) return false;
            corners[i][k] = c.normal == first.normal ? first.number : s->used + t;
        }
    return true;
}

// normals: NULL where the mesh is flat.
static void fill_points(const splitter *s, vec3 *points, vec3 *normals) {
    const vec3 *p = s->parts->points.items, *n = s->parts->normals.items;
    const obj_corner *twins = s->twins.items;
    for (int i = 0; i < s->parts->points.count; i++) {
        const first_use first = s->first[i];
        if (first.normal == UNUSED) continue;
        points[first.number] = p[i];
        if (normals) normals[first.number] = n[first.normal];
    }
    for (int t = 0; t < s->twins.count; t++) {
        points[s->used + t] = p[twins[t].point];
        normals[s->used + t] = n[twins[t].normal]; // a flat mesh has no twins
    }
}

// ---- the mesh ------------------------------------------------------------------------------

// Around the middle of the points' box, as wide as the farthest of them and some roundings of
// double and one of real. r = 0, unknown, where real overflows.
static sphere around(const vec3 *points, int count) {
    vec3 low = points[0], high = points[0];
    for (int i = 1; i < count; i++) {
        low = (vec3){fmin(low.x, points[i].x), fmin(low.y, points[i].y),
                     fmin(low.z, points[i].z)};
        high = (vec3){fmax(high.x, points[i].x), fmax(high.y, points[i].y),
                      fmax(high.z, points[i].z)};
    }
    const vec3 c = add(scale((real)0.5, low), scale((real)0.5, high));
    double farthest = 0;
    for (int i = 0; i < count; i++) {
        const wide3 v = wide_sub(points[i], c);
        farthest = fmax(farthest, hypot(hypot(v.x, v.y), v.z));
    }
    const real r = nextafter((real)((1 + 4 * DBL_EPSILON) * farthest), (real)INFINITY);
    return (sphere){c, isfinite(r) ? r : 0};
}

static void *room_for(int count, size_t size) {
    return (size_t)count > SIZE_MAX / size ? NULL : malloc((size_t)count * size);
}

static bool fill(splitter *s, mesh *m) {
    int(*corners)[3] = room_for(s->parts->triangles.count, sizeof *corners);
    *m = (mesh){.corners = (const int(*)[3])corners, .count = s->parts->triangles.count};
    if (!corners || !fill_corners(s, corners)) return false;
    const int count = s->used + s->twins.count;
    vec3 *points = room_for(count, sizeof *points);
    vec3 *normals = s->flat ? NULL : room_for(count, sizeof *normals);
    m->points = points;
    m->normals = normals;
    if (!points || (!normals && !s->flat)) return false;
    fill_points(s, points, normals);
    m->around = around(points, count);
    return true;
}

bool obj_make_mesh(const obj_parts *parts, bool flat, mesh *m) {
    splitter s = {.parts = parts, .flat = flat, .twins.size = sizeof(obj_corner)};
    s.first = room_for(parts->points.count, sizeof *s.first);
    const bool made = s.first && make_table(&s, note_first_uses(&s)) && fill(&s, m);
    free(s.first);
    free(s.table);
    free(s.twins.items);
    if (!made) mesh_free(m);
    return made;
}
