// check-fixtures.c: tests that go wrong in every way the runner knows, one way
// each; wrong values stand in check-rows.h. check-self.c runs them and reads what
// the runner says.
#define _XOPEN_SOURCE 700 // POSIX 2008 with SIGXCPU

#include "common/todo.h"
#include "tests/check-rows.h"
#include "tests/check.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <unistd.h>

// ---- What students' code does to a process ---------------------------------

// Volatile: the optimiser must not see through them.
static int *volatile nowhere = NULL;
static volatile int zero = 0;
static volatile int depth = 0;

static void null_pointer(void) {
    given("a pointer to nothing");
    printf("just before the crash\n");
    *nowhere = 1;
}

static void loop(void) {
    given("a loop without end");
    while (zero == 0) depth = 1;
}

// A frame with a volatile array, used after the call: no tail call, no loop.
static int recurse(int n) { // NOLINT(misc-no-recursion)
    volatile char frame[1024];
    frame[n % 1024] = (char)n;
    if (zero) return n;
    return recurse(n + 1) + frame[n % 1024];
}

static void recursion(void) {
    depth = recurse(1);
}

static void division(void) {
    depth = (depth + 7) / zero;
    raise(SIGFPE); // ARM's division gives 0 and goes on
}

static void aborting(void) {
    abort();
}

static void leaving(void) {
    exit(3);
}

static void flood(void) {
    while (zero == 0) printf("the same line again and again\n");
}

// What the limit of processor time does, without the wait.
static void out_of_time(void) {
    given("a test that is out of time, %g", -NAN);
    raise(SIGXCPU);
}

static void asleep(void) {
    for (;;) sleep(1000);
}

// Seconds of processor time that this process may take.
static void time_limit(void) {
    struct rlimit r = {0};
    getrlimit(RLIMIT_CPU, &r);
    CHECK_INT(r.rlim_cur, zero);
}

static void printing(void) {
    for (int i = 1; i <= 12; i++) printf("line %d <&>\"\x01\xff\n", i);
    CHECK(zero == 1, "this < fails & \"prints\"");
}

static real stub(void) {
    TODO("stub");
    return 0;
}

static void todo_wrong(void) {
    CHECK_REAL(stub(), 3.7, exactly());
}

static void todo_right(void) {
    CHECK_REAL(stub(), 0, exactly());
}

static void todo_crash(void) {
    *nowhere = (int)stub();
}

static void passing(void) {
    given("3.7");
    CHECK_REAL(3.7, 3.7, exactly());
    CHECK_REAL(NAN, NAN, exactly());
    CHECK_REAL(INFINITY, INFINITY, roundings(2, "same infinity"));
    CHECK_VEC3(((vec3){1, 2, 3}), ((vec3){1, 2, 3}), exactly());
    CHECK_INT(zero, 0);
    CHECK_BOOL(zero == 0, true);
    CHECK_AT_MOST(2.5, 2.5, "the bound belongs to it");
    CHECK_REAL(1.0009, 1, standard_errors(4, 0.00025));
}

static void chi2(void) { // tables: NIST/SEMATECH e-Handbook, 1.3.6.7.4
    CHECK_REAL(chi2_limit(3, 0.01), 11.345, relative_to(1e-2, "Wilson-Hilferty"));
    CHECK_REAL(chi2_limit(10, 0.001), 29.588, relative_to(1e-2, "Wilson-Hilferty"));
    CHECK_REAL(chi2_limit(100, 0.05), 124.342, relative_to(1e-3, "Wilson-Hilferty"));
}

// ---- Wrong values ----------------------------------------------------------

#define REAL_TEST(name, got, words)                               \
    static void real_##name(void) {                               \
        CHECK_REAL(got, REAL_EXPECTED, roundings(4, "a reason")); \
    }
#define REAL_ENTRY(name, got, words) {"real: " #name ".", real_##name, NULL},
REAL_ROWS(REAL_TEST)

#define VEC3_TEST(name, x, y, z, words)                                         \
    static void vec3_##name(void) {                                             \
        const vec3 got = {(real)x, (real)y, (real)z}, expected = VEC3_EXPECTED; \
        CHECK_VEC3(got, expected, roundings(4, "a reason"));                    \
    }
#define VEC3_ENTRY(name, x, y, z, words) {"vec3: " #name ".", vec3_##name, NULL},
VEC3_ROWS(VEC3_TEST)

static void suspect_first(void) {
    given("the value that the test foresaw, %d", 7);
    suspect_value("the far side", 7.4);
    CHECK_REAL(7.4, 3.7, exactly());
}

static void suspect_times(void) {
    suspect_factor("the cosine is missing", 1 / 0.6);
    CHECK_REAL(3.7 / 0.6, 3.7, roundings(4, "a reason"));
}

static void suspect_vector(void) {
    suspect_vec3("the other side", (vec3){7, 8, 9});
    CHECK_VEC3(((vec3){7, 8, 9}), ((vec3){1, 2, 3}), exactly());
}

static void suspects_forgotten(void) {
    suspect_value("an old suspicion", 5.55);
    given("something else");
    CHECK_REAL(5.55, 3.7, exactly());
}

static void slip(void) {
    given("an answer that no number tells");
    suspect_slip("a well-known slip");
    CHECK_BOOL(1 > 2, true);
}

static void slip_of_claim(void) {
    given("another such answer");
    suspect_slip("a well-known slip");
    CHECK(1 > 2, "a claim");
}

static void slip_and_print(void) {
    printf("something to look at\n");
    slip();
}

static void other_slip(void) {
    suspect_slip("another slip");
    slip_of_claim(); // forgets it
}

static void suspect_nearly(void) {
    suspect_value("what the cheap formula gives", 3.7001);
    CHECK_REAL(3.7001, 3.7, exactly());
}

static void in_double(void) {
    CHECK_REAL(3.7 * (1 + 1e-13), 3.7, exactly());
}

static void statistics(void) {
    CHECK_REAL(1.00009, 1, standard_errors(4, 1e-5));
}

static void zero_expected(void) {
    CHECK_REAL(1.5, 0, absolute_of(1e-6, "a reason"));
}

static void one_expected(void) { // its square, root and reciprocal are itself
    CHECK_REAL(1.0005, 1, exactly());
}

static void miss_expected(void) {
    CHECK_REAL(4.5, INFINITY, roundings(4, "a reason"));
}

static void one_too_many(void) {
    CHECK_INT(8, 7);
}

static void wrong_bool(void) {
    CHECK_BOOL(zero == 1, true);
}

static void too_much(void) {
    CHECK_AT_MOST(5.5, 2.5, "chi², 3 degrees of freedom");
}

static void nan_at_most(void) {
    CHECK_AT_MOST(NAN, 2.5, "a reason");
}

int main(void) {
    static const test tests[] = {
        {"crash: null pointer", null_pointer, "a hint"},
        {"crash: exit", leaving, "a hint"},
        {"crash: flood", flood, "a hint"},
        {"crash: recursion", recursion, "a hint"},
        {"crash: division", division, "a hint"},
        {"crash: abort", aborting, "a hint"},
        {"loop: without end", loop, "a hint"},
        {"stuck: first", out_of_time, "a hint"},
        {"unstuck: passes", passing, NULL},
        {"stuck: second", passing, NULL},
        {"unstuck: time limit", time_limit, NULL},
        {"stuck: third", passing, NULL},
        {"asleep", asleep, NULL}, // without a colon: T=: leaves it out, it takes seconds
        {"asleep", passing, NULL},
        {"print: <tag> & #1", printing, "a hint"},
        {"todo: wrong", todo_wrong, NULL},
        {"todo: right", todo_right, NULL},
        {"todo: crash", todo_crash, NULL},
        {"stub: wrong", todo_wrong, NULL},
        {"stub: right", todo_right, NULL},
        {"pass: everything", passing, NULL},
        {"pass: chi2", chi2, NULL},
        REAL_ROWS(REAL_ENTRY) VEC3_ROWS(VEC3_ENTRY){"suspect: first", suspect_first, NULL},
        {"suspect: factor", suspect_times, NULL},
        {"suspect: vector", suspect_vector, NULL},
        {"suspect: nearly", suspect_nearly, NULL},
        {"suspect: forgotten", suspects_forgotten, NULL},
        {"again: first", slip, "a hint"},
        {"again: the same", slip_of_claim, "a hint"},
        {"again: printed", slip_and_print, "a hint"},
        {"again: another hint", slip, "another hint"},
        {"again: forgotten", other_slip, "a hint"},
        {"anew: in another exercise", slip, "a hint"},
        {"fallen: first", aborting, NULL},
        {"fallen: too", aborting, NULL},
        {"fallen: otherwise", leaving, NULL},
        {"nearly: in double", in_double, NULL},
        {"statistics: not nearly", statistics, NULL},
        {"zero: expected", zero_expected, NULL},
        {"one: expected", one_expected, NULL},
        {"miss: expected", miss_expected, NULL},
        {"int: one too many", one_too_many, NULL},
        {"bool: wrong", wrong_bool, NULL},
        {"bound: too much", too_much, NULL},
        {"bound: nan", nan_at_most, NULL},
    };
    return run_tests("check-fixtures", tests, COUNT(tests));
}
