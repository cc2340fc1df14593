// obj_inside.h: what the files of the OBJ reader say to each other. Others include obj.h.
//
//     obj.c         the statements v, vn and f, and what is wrong with them
//     obj_file.c    a file, or a pipe, as one text
//     obj_text.c    lines and words
//     obj_number.c  a word as a number, correctly rounded
//     obj_index.c   a corner as its indices
//     obj_mesh.c    a mesh of what was read
#ifndef CHAPTER_OBJ_INSIDE_H
#define CHAPTER_OBJ_INSIDE_H

#include "chapters/12-bvh/obj.h"

// ---- obj_text.c ------------------------------------------------------------------------

// What is still to be read. A line ends with LF, CR LF or CR.
typedef struct {
    const char *at, *end;
    long line; // of `at`, from 1
} obj_text;

typedef struct {
    const char *begin, *end;
} obj_word;

// The next word of the statement; an empty one at its end. A backslash at the end of a line is
// a blank, so the statement goes on. A comment ends with its line, whatever stands at its end:
// often a path of Windows.
obj_word obj_next_word(obj_text *t);

// To where the next line begins, or to the end.
void obj_next_line(obj_text *t);

static inline bool obj_is_empty(obj_word w) {
    return w.begin == w.end;
}

bool obj_is(obj_word w, const char *name);

// The word's beginning for a message, each strange byte as "?".
typedef struct {
    char chars[44];
} obj_quote;
obj_quote obj_quoted(obj_word w);

// Writes "name:12: ", or "name: " of line 0; returns its length. Of a long name the end is
// shown, and a control character as "?", so that there is room for a message in one line.
int obj_begin_error(char error[OBJ_ERROR], const char *name, long line);

// ---- obj_number.c ----------------------------------------------------------------------

// "1", "-.5", "+5.e-3" as the nearest real; INFINITY when it is too large. false: not a number
// in decimal digits. The locale does not matter.
bool obj_number(obj_word w, real *x);

// ---- obj_index.c -----------------------------------------------------------------------

// As it stands in the file. The word is empty where there is none.
typedef struct {
    obj_word word;
    int64_t value;
} obj_index;

// point, point/texture, point//normal or point/texture/normal. false: nothing of these.
bool obj_split_corner(obj_word w, obj_index *point, obj_index *normal);

// ---- obj_mesh.c ------------------------------------------------------------------------

// An array that grows.
typedef struct {
    size_t size; // of an item
    void *items;
    int count, room;
} obj_list;

// A new last item, not set, or NULL: no memory, or already INT_MAX of them.
void *obj_add(obj_list *list);

enum { OBJ_NO_NORMAL = -1 };

// Indices from 0.
typedef struct {
    int point, normal;
} obj_corner;

typedef struct {
    obj_list points, normals, triangles; // of vec3, vec3 and obj_corner[3]
} obj_parts;

// Points keep their order, those of no triangle are left out; behind them stand the copies
// that further normals need, in the order of first use. `flat`: without normals. Changes the
// triangles' corners. false: no memory.
bool obj_make_mesh(const obj_parts *parts, bool flat, mesh *m);

#endif
