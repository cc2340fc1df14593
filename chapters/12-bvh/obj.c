// obj.c: see obj.h. The statements v, vn and f; obj_inside.h names the reader's other files.
#include <inttypes.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "chapters/12-bvh/obj_inside.h"
#include "common/wide3.h"

typedef struct {
    const char *name;
    obj_text text;
    long line; // where the statement begins
    obj_parts parts;
    long with_normal, without; // corners
    obj_report report;
    char *error;
} reader;

static bool fail(reader *r, const char *format, ...) __attribute__((format(printf, 2, 3)));
static bool fail(reader *r, const char *format, ...) {
    va_list arguments;
    const int used = obj_begin_error(r->error, r->name, r->line);
    va_start(arguments, format);
    vsnprintf(r->error + used, (size_t)(OBJ_ERROR - used), format, arguments);
    va_end(arguments);
    return false;
}

static bool no_room(reader *r, int count, const char *what) {
    r->line = 0;
    return fail(r, "no memory for more than %d %s", count, what);
}

// ---- points and normals ----------------------------------------------------------------

// Three numbers; more may follow.
static bool read_vec3(reader *r, const char *statement, vec3 *v) {
    real x[3] = {0}, more;
    int count = 0;
    for (obj_word w = obj_next_word(&r->text); !obj_is_empty(w); w = obj_next_word(&r->text)) {
        real *to = count < 3 ? &x[count++] : &more;
        if (!obj_number(w, to))
            return fail(r, "%s: expected a number, got \"%s\"", statement, obj_quoted(w).chars);
        if (!isfinite(*to))
            return fail(r, "%s: %s is too large for " REAL_NAME, statement,
                        obj_quoted(w).chars);
    }
    if (count < 3) return fail(r, "%s: expected three numbers, got %d", statement, count);
    *v = (vec3){x[0], x[1], x[2]};
    return true;
}

static bool read_point(reader *r) {
    vec3 p;
    if (!read_vec3(r, "v", &p)) return false;
    vec3 *added = obj_add(&r->parts.points);
    if (!added) return no_room(r, r->parts.points.count, "points");
    *added = p;
    return true;
}

// n / |n|, n not 0. One that is unit already, but for its rounding, stays as it is: what a
// program wrote comes back bit for bit. Divided by its largest component first, no square
// overflows.
static vec3 unit(vec3 n) {
    const double nn = wide_dot(widen(n), widen(n));
    if (fabs(nn - 1) <= 8 * REAL_EPSILON) return n;
    const double most = fmax(fmax(fabs(n.x), fabs(n.y)), fabs(n.z));
    const wide3 w = {n.x / most, n.y / most, n.z / most};
    const double length_of_w = sqrt(wide_dot(w, w));
    return narrow((wide3){w.x / length_of_w, w.y / length_of_w, w.z / length_of_w});
}

static bool read_normal(reader *r) {
    vec3 n;
    if (!read_vec3(r, "vn", &n)) return false;
    if (n.x == 0 && n.y == 0 && n.z == 0) return fail(r, "vn: a normal of length 0");
    vec3 *added = obj_add(&r->parts.normals);
    if (!added) return no_room(r, r->parts.normals.count, "normals");
    *added = unit(n);
    return true;
}

// ---- faces -----------------------------------------------------------------------------

// From 1, or from the last back with -1, -2 … to from 0. Only what stands above may be named.
static bool resolve(reader *r, obj_index i, int count, const char *what, int *from_0) {
    const int64_t k = i.value < 0 ? count + i.value : i.value - 1;
    if (i.value == 0) return fail(r, "f: there is no %s 0, the first is 1", what);
    if (k < 0 || k >= count)
        return fail(r, "f: there is no %s %s (%ss above: %d)", what, obj_quoted(i.word).chars,
                    what, count);
    *from_0 = (int)k;
    return true;
}

static bool read_corner(reader *r, obj_word w, obj_corner *c) {
    obj_index point, normal;
    if (!obj_split_corner(w, &point, &normal))
        return fail(r, "f: expected a corner like 1, 1/2, 1//3 or 1/2/3, got \"%s\"",
                    obj_quoted(w).chars);
    c->normal = OBJ_NO_NORMAL;
    if (!resolve(r, point, r->parts.points.count, "point", &c->point)) return false;
    if (obj_is_empty(normal.word)) {
        r->without++;
        return true;
    }
    r->with_normal++;
    return resolve(r, normal, r->parts.normals.count, "normal", &c->normal);
}

static bool add_triangle(reader *r, const obj_corner c[3]) {
    const vec3 *p = r->parts.points.items;
    if (!triangle_has_area((triangle){p[c[0].point], p[c[1].point], p[c[2].point]})) {
        r->report.degenerate++;
        return true;
    }
    obj_corner *added = obj_add(&r->parts.triangles);
    if (!added) return no_room(r, r->parts.triangles.count, "triangles");
    memcpy(added, c, 3 * sizeof *added);
    return true;
}

// A fan: the first corner, the one before and this one.
static bool read_face(reader *r) {
    obj_corner c[3];
    int count = 0; // up to 4: many
    for (obj_word w = obj_next_word(&r->text); !obj_is_empty(w); w = obj_next_word(&r->text)) {
        if (count >= 3) c[1] = c[2];
        if (!read_corner(r, w, &c[count < 3 ? count : 2])) return false;
        if (count < 4) count++;
        if (count >= 3 && !add_triangle(r, c)) return false;
    }
    if (count < 3) return fail(r, "f: expected three corners or more, got %d", count);
    r->report.polygons += count > 3;
    return true;
}

// ---- the text --------------------------------------------------------------------------

static bool read_statement(reader *r) {
    const obj_word w = obj_next_word(&r->text);
    if (obj_is_empty(w)) return true;
    if (obj_is(w, "v")) return read_point(r);
    if (obj_is(w, "vn")) return read_normal(r);
    if (obj_is(w, "f")) return read_face(r);
    r->report.skipped++;
    while (!obj_is_empty(obj_next_word(&r->text))) continue;
    return true;
}

// No text has a byte 0; pictures and programs soon have one.
static bool check_is_text(reader *r) {
    const char *zero = memchr(r->text.at, 0, (size_t)(r->text.end - r->text.at));
    if (!zero) return true;
    obj_text before = {r->text.at, zero, 1};
    while (before.at < before.end) obj_next_line(&before);
    r->line = before.line;
    return fail(r, "a byte 0: this is no text");
}

static void skip_byte_order_mark(obj_text *t) {
    static const char mark[] = "\xef\xbb\xbf";
    if (t->end - t->at >= 3 && memcmp(t->at, mark, 3) == 0) t->at += 3;
}

static bool read_text(reader *r) {
    if (!check_is_text(r)) return false;
    skip_byte_order_mark(&r->text);
    while (r->text.at < r->text.end) {
        r->line = r->text.line;
        if (!read_statement(r)) return false;
        obj_next_line(&r->text);
    }
    r->line = 0;
    if (r->parts.triangles.count > 0) return true;
    return fail(r, "no triangle (points: %d, triangles without area: %ld)",
                r->parts.points.count, r->report.degenerate);
}

static bool make_mesh(reader *r, mesh *m) {
    const bool flat = r->without > 0 || r->with_normal == 0;
    r->report.bare = r->with_normal > 0 ? r->without : 0;
    return obj_make_mesh(&r->parts, flat, m) || fail(r, "no memory for its mesh");
}

bool obj_parse(const char *text, size_t length, const char *name, mesh *m, obj_report *report,
               char error[OBJ_ERROR]) {
    if (length == 0) text = "";
    reader r = {.name = name,
                .text = {text, text + length, 1},
                .parts = {{.size = sizeof(vec3)},
                          {.size = sizeof(vec3)},
                          {.size = sizeof(obj_corner[3])}},
                .error = error};
    *m = (mesh){0};
    *error = '\0';
    const bool done = read_text(&r) && make_mesh(&r, m);
    *report = r.report;
    free(r.parts.points.items);
    free(r.parts.normals.items);
    free(r.parts.triangles.items);
    return done;
}
