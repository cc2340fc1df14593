// check_inside.h: what the files of the test runner say to each other. Tests
// include check.h alone.
//
//     check.c            the table of tests: filter, loop, exit status
//     check_process.c    starts a test's process and watches it from outside
//     check_child.c      what happens inside that process: limits, crashes
//     check_verdict.c    what its end means: passed, failed, missing
//     check_report.c     people, TAP, JUnit, tally
//     check_values.c     the checks and their allowances
//     check_suspects.c   what is given, and what wrong answers a test foresees
//     check_diagnosis.c  what a wrong answer looks like otherwise
//     check_text.c       text that grows, numbers as text
#ifndef TESTS_CHECK_INSIDE_H
#define TESTS_CHECK_INSIDE_H

#include "tests/check.h"

#include <stddef.h>

// ---- check_text.c ---------------------------------------------------------

// Text that grows up to a limit; what does not fit is cut off.
typedef struct {
    size_t length;
    char chars[8192];
} text;

void text_add(text *t, const char *format, ...) __attribute__((format(printf, 2, 3)));

// One aligned line of a message: label, then words. Further lines are indented.
void text_row(text *t, const char *label, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

// A short text that lives until eight more are made: longer than any one check.
const char *text_kept(const char *format, ...) __attribute__((format(printf, 1, 2)));

typedef struct {
    char chars[96];
} short_text;

// As few digits as give the same number again.
short_text text_number(double x);
short_text text_vec3(vec3 v);

// ---- check.c --------------------------------------------------------------

typedef enum { PASSED, FAILED, MISSING } verdict; // MISSING: a TODO was reached

typedef struct {
    const test *test;
    int cpu_limit; // seconds of processor time that it may take
    verdict verdict;
    bool stuck;   // FAILED: it did not come back and was stopped
    bool skipped; // FAILED: not run, since a test of its exercise got stuck before
    double seconds;
    text message; // FAILED: the rows; MISSING: what is missing and where
} result;

typedef struct {
    const char *suite;
    result *results;
    int count, tally[3]; // tally[verdict]
} summary;

// The length of the exercise's name, with which a test's name begins.
int exercise_length(const test *t);
bool same_exercise(const test *a, const test *b);

// The environment's value, or NULL when it is unset or empty.
const char *runner_setting(const char *name);
// Whether it is set, not empty and not 0.
bool runner_flag(const char *name);
// Ends the runner: "error: the test runner cannot WHAT: " and the reason in errno.
_Noreturn void runner_die(const char *what);

// ---- check_process.c ------------------------------------------------------

enum { OUTPUT_LIMIT = 64 * 1024 }; // bytes
enum { WALL_PER_CPU = 6 };         // of the time limits; generous: the machine may be busy
enum { PRINTED, VERDICT };         // the two pipes from a test's process

// What a test's process left behind.
typedef struct {
    int status;                                      // from waitpid
    enum { NOT_STOPPED, FLOODED, TOO_LONG } stopped; // by the runner
    struct {
        size_t size;
        char data[OUTPUT_LIMIT + 1]; // ends with a 0
    } got[2];                        // from each pipe
} ending;

// Runs r->test in a process of its own and fills in the rest of r.
void process_run(result *r);
// From now on ctrl-C ends the test that runs, too.
void process_catch_interrupts(void);

// ---- check_child.c --------------------------------------------------------

// A verdict is one letter and a message:
//     p        passed
//     f rows   failed
//     t what   a TODO was reached
//     c crash  crashed: the struct, then what was given
typedef struct {
    int signal;
    void *address;
} crash;

enum { STACK_LIMIT = 8 << 20 }; // bytes; the usual default, for all

// Seconds of processor time that a test may take; less once another got stuck,
// since both may call the same function.
int child_cpu_limit(bool stuck_before);
// The whole life of a test's process; the pipes' ends to write to.
_Noreturn void child_run(const result *r, int printed_end, int verdict_end);

// Ends the test that runs in this process as failed: `rows` say what was given,
// called, expected and got. file may be NULL.
_Noreturn void test_failed(text *rows, const char *file, int line);

// ---- check_verdict.c ------------------------------------------------------

// Fills in the verdict and the message.
void verdict_judge(result *r, const ending *e);
// The same for a test that is not run, since its exercise got stuck.
void verdict_skip(result *r);

// ---- check_report.c -------------------------------------------------------

void report_start(const summary *s);
void report_test(const summary *s, const result *r); // r: one of s->results
// The closing line, JUNIT's and TALLY's files; false when one cannot be written.
bool report_end(const summary *s, bool all_right);
// The same when there was no test to run.
bool report_none(const summary *s);

// ---- check_values.c -------------------------------------------------------

// How far an answer of this size may be off.
double allowance_slack(allowance allowed, double size);

// |v| and |a - b| in double: the square of a large float must not overflow.
double length_in_double(vec3 v);
double distance_in_double(vec3 a, vec3 b);

// ---- check_suspects.c -----------------------------------------------------

// What was given last, "" when nothing was. Safe in a signal handler.
const char *given_text(void);
const char *hint_given(void);     // NULL: the test's own
const char *likeness_given(void); // NULL: none

// How near a guess must be to count.
typedef struct {
    double far;   // |got - expected|
    double slack; // relative
} aim;

// What the suspect that fits is called, or NULL.
const char *suspected_real(double got, double expected, aim a);
const char *suspected_vec3(vec3 got, vec3 expected, aim a);
const char *suspected_int(long got);

// ---- check_diagnosis.c ----------------------------------------------------

// Whether a guess of this size, at this distance from got, is near enough.
bool aim_hits(aim a, double distance, double size);

// What the wrong answer `got` looks like, or NULL: better silent than wrong.
const char *diagnose_real(double got, double expected, allowance allowed);
const char *diagnose_vec3(vec3 got, vec3 expected, allowance allowed);
const char *diagnose_int(long got, long expected);
// The same for NaN and infinities alone.
const char *diagnose_odd(double got, double expected);

#endif
