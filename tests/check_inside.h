// check_inside.h: what check.c and check_values.c say to each other. Tests
// include check.h alone.
#ifndef TESTS_CHECK_INSIDE_H
#define TESTS_CHECK_INSIDE_H

#include <stddef.h>

// Text that grows up to a limit; what does not fit is cut off.
typedef struct {
    size_t length;
    char chars[8192];
} text;

void text_add(text *t, const char *format, ...) __attribute__((format(printf, 2, 3)));

// One aligned line of a message: label, then words. Further lines are indented.
void text_row(text *t, const char *label, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

// Ends the test that runs in this process as failed: `rows` say what was given,
// called, expected and got.
_Noreturn void test_failed(text *rows, const char *file, int line);

// What was given last, "" when nothing was. Safe in a signal handler.
const char *given_text(void);

#endif
