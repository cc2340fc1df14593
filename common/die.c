// die.c: one line that says why, and the exit status that says what kind.
#include "common/die.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

void die(int status, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    fflush(stdout); // what was printed before stands before the error
    fputs("error: ", stderr);
    vfprintf(stderr, format, arguments);
    fputc('\n', stderr);
    va_end(arguments);
    exit(status);
}
