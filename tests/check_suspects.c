// check_suspects.c: what a test is about: what it gives to the student's function,
// and the wrong answers that it foresees.
#define _POSIX_C_SOURCE 200809L

#include "tests/check.h"
#include "tests/check_inside.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    enum { VALUE, VECTOR, FACTOR } kind;
    const char *what;
    double number; // the value or the factor
    vec3 vector;
} suspect;

static struct {
    char given[2048];
    suspect suspects[16];
    int count;
    const char *hint; // or NULL: the test's
    const char *like; // or NULL
} about;

void given(const char *format, ...) {
    va_list args;
    va_start(args, format);
    vsnprintf(about.given, sizeof about.given, format, args);
    va_end(args);
    for (char *minus; (minus = strstr(about.given, "-nan"));)
        memmove(minus, minus + 1, strlen(minus));
    about.count = 0;
    about.hint = about.like = NULL;
}

void hint_instead(const char *hint) {
    about.hint = hint;
}

void suspect_slip(const char *what) {
    about.like = what;
}

const char *likeness_given(void) {
    return about.like;
}

const char *hint_given(void) {
    return about.hint;
}

const char *given_text(void) {
    return about.given;
}

static void add_suspect(suspect s) {
    if (about.count == COUNT(about.suspects)) {
        fprintf(stderr, "check: more than %d suspects\n", about.count);
        abort();
    }
    about.suspects[about.count++] = s;
}

void suspect_value(const char *what, double value) {
    add_suspect((suspect){.kind = VALUE, .what = what, .number = value});
}

void suspect_vec3(const char *what, vec3 value) {
    add_suspect((suspect){.kind = VECTOR, .what = what, .vector = value});
}

void suspect_factor(const char *what, double factor) {
    add_suspect((suspect){.kind = FACTOR, .what = what, .number = factor});
}

// ---- Does one of them fit? -----------------------------------------------

const char *suspected_real(double got, double expected, aim a) {
    for (const suspect *s = about.suspects; s < about.suspects + about.count; s++) {
        const double guess = s->kind == FACTOR ? s->number * expected : s->number;
        if (s->kind == VECTOR || (s->kind == FACTOR && expected == 0)) continue;
        if (got == guess || aim_hits(a, fabs(got - guess), fabs(guess))) return s->what;
    }
    return NULL;
}

const char *suspected_vec3(vec3 got, vec3 expected, aim a) {
    for (const suspect *s = about.suspects; s < about.suspects + about.count; s++) {
        const bool factor = s->kind == FACTOR;
        const vec3 guess = factor ? scale((real)s->number, expected) : s->vector;
        const double distance = distance_in_double(got, guess);
        if (s->kind == VALUE || (factor && length_in_double(expected) == 0)) continue;
        if (distance == 0 || aim_hits(a, distance, length_in_double(guess))) return s->what;
    }
    return NULL;
}

const char *suspected_int(long got) {
    for (const suspect *s = about.suspects; s < about.suspects + about.count; s++)
        if (s->kind == VALUE && (double)got == s->number) return s->what;
    return NULL;
}
