// check_text.c: the words of the runner's messages: text that grows, aligned
// rows, numbers with as many digits as they need.
#define _POSIX_C_SOURCE 200809L

#include "tests/check_inside.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void add_v(text *t, const char *format, va_list args) {
    const size_t room = sizeof t->chars - t->length;
    const int n = vsnprintf(t->chars + t->length, room, format, args);
    if (n > 0) t->length += (size_t)n < room ? (size_t)n : room - 1;
}

void text_add(text *t, const char *format, ...) {
    va_list args;
    va_start(args, format);
    add_v(t, format, args);
    va_end(args);
}

static void add_indented(text *t, const char *words) {
    for (const char *line = words;;) {
        const int length = (int)strcspn(line, "\n");
        text_add(t, "%.*s\n", length, line);
        if (!line[length]) return;
        line += length + 1;
        text_add(t, "%11s", "");
    }
}

void text_row(text *t, const char *label, const char *format, ...) {
    text words = {0};
    va_list args;
    va_start(args, format);
    add_v(&words, format, args);
    va_end(args);
    text_add(t, "%-10s ", label);
    add_indented(t, words.chars);
}

const char *text_kept(const char *format, ...) {
    static char kept[8][200];
    static int next;
    char *k = kept[next++ % COUNT(kept)];
    va_list args;
    va_start(args, format);
    vsnprintf(k, sizeof kept[0], format, args);
    va_end(args);
    return k;
}

short_text text_number(double x) {
    if (isnan(x)) return (short_text){"nan"}; // printf may say -nan
    if (isinf(x)) return x > 0 ? (short_text){"infinity"} : (short_text){"-infinity"};
    short_text s;
    const int most = sizeof(real) == sizeof(float) ? 9 : 17;
    for (int digits = 1; digits <= most; digits++) {
        snprintf(s.chars, sizeof s.chars, "%.*g", digits, x);
        if (digits >= 6 && (real)strtod(s.chars, NULL) == (real)x) break;
    }
    return s;
}

short_text text_vec3(vec3 v) {
    short_text s;
    const short_text x = text_number((double)v.x), y = text_number((double)v.y),
                     z = text_number((double)v.z);
    snprintf(s.chars, sizeof s.chars, "(%.29s, %.29s, %.29s)", x.chars, y.chars, z.chars);
    return s;
}
