// check-obj.h: what holds of whatever the OBJ reader is given, for tests and for the fuzzer.
#ifndef TESTS_CHECK_OBJ_H
#define TESTS_CHECK_OBJ_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "chapters/12-bvh/obj_inside.h"

static inline bool obj_printable(const char *text) {
    for (; *text; text++)
        if (*text < ' ' || *text > '~') return false;
    return true;
}

static inline bool obj_same_vec3(vec3 a, vec3 b) {
    return memcmp(&a, &b, sizeof a) == 0;
}

// |n| = 1 but for its rounding. Kept: |n|² within 8 REAL_EPSILON; and the sum's own rounding.
static inline bool obj_is_unit(vec3 n) {
    const double nn = (double)n.x * n.x + (double)n.y * n.y + (double)n.z * n.z;
    return fabs(nn - 1) <= 12 * REAL_EPSILON;
}

static inline bool obj_is_inside(vec3 p, sphere S) {
    const double x = (double)p.x - S.c.x, y = (double)p.y - S.c.y, z = (double)p.z - S.c.z;
    return S.r == 0 || hypot(hypot(x, y), z) <= (1 + 4 * DBL_EPSILON) * S.r;
}

// What is wrong with a corner of m: NULL, nothing.
static inline const char *obj_corner_fault(const mesh *m, int point) {
    if (point < 0) return "an index below 0";
    if (!is_finite(m->points[point])) return "a point that is not finite";
    if (!obj_is_inside(m->points[point], m->around)) return "a point outside `around`";
    if (m->normals && !obj_is_unit(m->normals[point])) return "a normal that is not unit";
    return NULL;
}

// Points are numbered without a gap: the largest index tells how many there are, and a memory
// checker whether there are as many.
static inline int obj_points(const mesh *m) {
    int most = -1;
    for (int i = 0; i < m->count; i++)
        for (int k = 0; k < 3; k++)
            if (m->corners[i][k] > most) most = m->corners[i][k];
    return most + 1;
}

static inline bool obj_uses_all(const mesh *m) {
    const int count = obj_points(m);
    char *used = calloc((size_t)count, 1);
    for (int i = 0; i < m->count; i++)
        for (int k = 0; k < 3; k++) used[m->corners[i][k]] = 1;
    const bool all = !memchr(used, 0, (size_t)count);
    free(used);
    return all;
}

static inline const char *obj_mesh_fault(const mesh *m) {
    if (m->count < 1) return "no triangle";
    if (m->finder) return "a finder";
    if (!isfinite(m->around.r) || !is_finite(m->around.c)) return "an infinite `around`";
    for (int i = 0; i < m->count; i++) {
        for (int k = 0; k < 3; k++) {
            const char *fault = obj_corner_fault(m, m->corners[i][k]);
            if (fault) return fault;
        }
        if (!triangle_has_area(mesh_triangle(m, i))) return "a triangle without area";
    }
    return obj_uses_all(m) ? NULL : "a point that no triangle uses";
}

static inline const char *obj_report_fault(const mesh *m, const obj_report *about) {
    if (about->polygons < 0 || about->degenerate < 0 || about->bare < 0 || about->skipped < 0)
        return "a count below 0";
    return about->bare > 0 && m->normals ? "normals, though corners are bare" : NULL;
}

static inline const char *obj_error_fault(const mesh *m, const char *name, const char *error) {
    const size_t length = strlen(name);
    if (m->points || m->normals || m->corners || m->count || m->around.r != 0)
        return "an error, and a mesh that is not empty";
    if (strncmp(error, name, length) != 0 || error[length] != ':')
        return "an error that does not begin with the name";
    if (!obj_printable(error)) return "an error that is not printable ASCII";
    return strlen(error) > length + 3 ? NULL : "an error without words";
}

// What is wrong with the reader's answer: NULL, nothing. `name` is printable and short.
static inline const char *obj_fault(bool read, const mesh *m, const obj_report *about,
                                    const char *name, const char *error) {
    if (!read) return obj_error_fault(m, name, error);
    const char *fault = obj_mesh_fault(m);
    if (!fault) fault = obj_report_fault(m, about);
    return !fault && *error ? "a mesh, and an error" : fault;
}

static inline bool obj_same_mesh(const mesh *a, const mesh *b) {
    if (a->count != b->count || !a->normals != !b->normals) return false;
    if (a->count == 0) return true;
    if (memcmp(a->corners, b->corners, (size_t)a->count * sizeof *a->corners) != 0)
        return false;
    for (int i = 0, count = obj_points(a); i < count; i++) {
        if (!obj_same_vec3(a->points[i], b->points[i])) return false;
        if (a->normals && !obj_same_vec3(a->normals[i], b->normals[i])) return false;
    }
    return true;
}

// Does the reader take the same words for numbers as the C library, and for the same ones, bit
// by bit? For words of digits, signs, points and e: the library knows more ("inf", "0x1p3"). In
// the "C" locale. `word` ends with a 0.
static inline const char *obj_number_fault(const char *word) {
    real got = 0;
    char *end;
    const bool read = obj_number((obj_word){word, word + strlen(word)}, &got);
    const real expected =
        sizeof(real) == sizeof(float) ? (real)strtof(word, &end) : (real)strtod(word, &end);
    const bool is_number = *word && !*end;
    if (read != is_number) return read ? "no number, but read as one" : "a number, but refused";
    return !read || memcmp(&got, &expected, sizeof got) == 0 ? NULL : "another number";
}

#endif
