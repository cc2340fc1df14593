// check.h: the test runner. Its messages are part of the teaching.
//
// A suite is a table of tests; every test runs in a process of its own, so a
// crash, an endless loop, endless recursion or a flood of output is one failed
// test with one clear message, and the rest still runs.
//
//     static void touches(void) {
//         given("sphere c = (0, 0, -3), r = 1; ray O = 0, d = (0, 0, -1)");
//         suspect_value("the far side", 4);
//         CHECK_REAL(sphere_hit(s, r, 0, NO_HIT), 2, roundings(2, "one rounding out"));
//     }
//     int main(void) {
//         static const test tests[] = {
//             {"sphere_hit: straight ahead", touches, "The smallest root above t_min."},
//         };
//         return run_tests("04-sphere", tests, COUNT(tests));
//     }
//
// A test's name begins with the exercise that it judges, then a colon. The first
// failed check ends its test. Once a test did not come back, the others of its
// exercise are not run and count as failed. Environment: T=text runs only the tests
// of the exercise text, or else those whose name contains it, TAP=1 prints TAP,
// JUNIT=file writes JUnit XML, TALLY=file appends "passed failed todo", TEST_SECONDS=n
// changes the limit, SEED=n the random numbers. What fails like an earlier test of its
// exercise is told in short; FULL=1 tells all.
#ifndef TESTS_CHECK_H
#define TESTS_CHECK_H

#include "common/rng.h"
#include "common/vec3.h"

typedef struct {
    const char *name;
    void (*run)(void);
    const char *hint; // shown when the answer is wrong, not when there is none
} test;

// A generator for a test's data and its draws, one for each stream. SEED=n in the
// environment gives other numbers: what a test claims must hold for any.
rng check_rng(uint64_t stream);

// Runs the suite and prints a line per test, then "N passed, N failed". Returns
// the exit status: 0 when all passed, 1 otherwise (a todo is not a pass).
int run_tests(const char *suite, const test *tests, int count);

// What the next checks are about; replaces what was given before and forgets
// the suspects. printf's format; VEC and ARG(v) print a vec3.
void given(const char *format, ...) __attribute__((format(printf, 1, 2)));
#define VEC "(%.9g, %.9g, %.9g)"
#define ARG(v) (double)(v).x, (double)(v).y, (double)(v).z

// Tell-tale answers, also of CHECK_AT_MOST (within 2 %): when got equals `value`, or expected times `factor`, the
// message says that it looks like `what`. Signs, 2, π, cosine-free factors and
// swapped axes are known without asking.
void suspect_value(const char *what, double value);
void suspect_vec3(const char *what, vec3 value);
void suspect_factor(const char *what, double factor);

// A hint in place of the test's own, until something else is given: about this failure.
void hint_instead(const char *hint);

// What a wrong answer to the next CHECK_BOOL or CHECK looks like, since no number tells; until
// something else is given.
void suspect_slip(const char *what);

// How far got may lie from expected, and why that is fair.
typedef struct {
    double absolute, relative;
    const char *why;
} allowance;

allowance exactly(void);
allowance roundings(double n,
                    const char *why); // n roundings of real: relative n REAL_EPSILON / 2
allowance relative_to(double relative, const char *why);
allowance absolute_of(double absolute, const char *why);
// z standard errors; says the false-alarm rate 2 (1 - Φ(z)) in the message.
allowance standard_errors(double z, double standard_error);

// The checks. `call` is printed as written; a vec3 is judged by |got - expected|
// against absolute + relative |expected|. NaN never passes, unless expected.
#define CHECK_REAL(call, expected, allowed) \
    check_real(__FILE__, __LINE__, #call, (double)(call), (double)(expected), allowed)
#define CHECK_VEC3(call, expected, allowed) \
    check_vec3(__FILE__, __LINE__, #call, call, expected, allowed)
#define CHECK_INT(call, expected) \
    check_int(__FILE__, __LINE__, #call, (long)(call), (long)(expected))
#define CHECK_BOOL(call, expected) check_bool(__FILE__, __LINE__, #call, call, expected)
// got <= bound, and a reason for the bound: for counts, worst errors, chi².
#define CHECK_AT_MOST(call, bound, why) \
    check_at_most(__FILE__, __LINE__, #call, (double)(call), (double)(bound), why)
// Anything else: `holds` must be true; `claim` says in words what must hold.
#define CHECK(holds, claim) check_that(__FILE__, __LINE__, #holds, holds, claim)

void check_real(const char *file, int line, const char *call, double got, double expected,
                allowance allowed);
void check_vec3(const char *file, int line, const char *call, vec3 got, vec3 expected,
                allowance allowed);
void check_int(const char *file, int line, const char *call, long got, long expected);
void check_bool(const char *file, int line, const char *call, bool got, bool expected);
void check_at_most(const char *file, int line, const char *call, double got, double bound,
                   const char *why);
void check_that(const char *file, int line, const char *text, bool holds, const char *claim);

// The chi² value that `dof` degrees of freedom exceed with probability
// `false_alarm` (Wilson-Hilferty; better than 1 % for dof >= 3).
double chi2_limit(int dof, double false_alarm);

#endif
