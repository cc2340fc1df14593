// obj_text.c: see obj_inside.h.
#include <stdio.h>
#include <string.h>

#include "chapters/12-bvh/obj_inside.h"

static bool is_newline(char c) {
    return c == '\n' || c == '\r';
}

static bool is_blank(char c) {
    return c == ' ' || c == '\t';
}

// Does the line go on in the next?
static bool is_continuation(const char *at, const char *end) {
    return *at == '\\' && (at + 1 == end || is_newline(at[1]));
}

static void to_line_end(obj_text *t) {
    while (t->at < t->end && !is_newline(*t->at)) t->at++;
}

void obj_next_line(obj_text *t) {
    to_line_end(t);
    if (t->at == t->end) return;
    const bool two = *t->at == '\r' && t->end - t->at > 1 && t->at[1] == '\n';
    t->at += two ? 2 : 1;
    t->line++;
}

static void skip_blanks(obj_text *t) {
    while (t->at < t->end) {
        if (is_continuation(t->at, t->end))
            obj_next_line(t);
        else if (is_blank(*t->at))
            t->at++;
        else
            return;
    }
}

static bool ends_word(const char *at, const char *end) {
    return is_blank(*at) || is_newline(*at) || is_continuation(at, end);
}

obj_word obj_next_word(obj_text *t) {
    skip_blanks(t);
    if (t->at < t->end && *t->at == '#') to_line_end(t);
    const char *begin = t->at;
    while (t->at < t->end && !ends_word(t->at, t->end)) t->at++;
    return (obj_word){begin, t->at};
}

bool obj_is(obj_word w, const char *name) {
    const size_t length = (size_t)(w.end - w.begin);
    return strlen(name) == length && memcmp(w.begin, name, length) == 0;
}

obj_quote obj_quoted(obj_word w) {
    obj_quote q = {""};
    const size_t length = (size_t)(w.end - w.begin), shown = sizeof q.chars - sizeof "...";
    for (size_t i = 0; i < length && i < shown; i++)
        q.chars[i] = w.begin[i] >= ' ' && w.begin[i] <= '~' ? w.begin[i] : '?';
    if (length > shown) strcpy(q.chars + shown, "...");
    return q;
}

int obj_begin_error(char error[OBJ_ERROR], const char *name, long line) {
    enum { SHOWN = 100 }; // bytes of the name
    const size_t length = strlen(name);
    const bool fits = length <= SHOWN;
    char at_line[32] = "";
    if (line > 0) snprintf(at_line, sizeof at_line, "%ld:", line);
    const int used = snprintf(error, OBJ_ERROR, "%s%s:%s ", fits ? "" : "...",
                              fits ? name : name + length - SHOWN, at_line);
    for (char *c = error; *c; c++)
        if ((unsigned char)*c < ' ' || *c == 127) *c = '?';
    return used;
}
