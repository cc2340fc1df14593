// die.h: the one way in which a program gives up.
#ifndef COMMON_DIE_H
#define COMMON_DIE_H

#include <stdnoreturn.h>

enum { EXIT_RUN = 1, EXIT_USAGE = 2 }; // something failed; the command line is wrong

// Writes "error: " and the message in one line on stderr and exits with `status`.
noreturn void die(int status, const char *format, ...) __attribute__((format(printf, 2, 3)));

#endif
