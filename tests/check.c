// check.c: the table of tests: which of them run, the loop, the exit status.
// check_inside.h lists the files that do the rest.
#define _POSIX_C_SOURCE 200809L

#include "tests/check.h"
#include "tests/check_inside.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char *runner_setting(const char *name) {
    const char *value = getenv(name);
    return value && *value ? value : NULL;
}

bool runner_flag(const char *name) {
    const char *value = runner_setting(name);
    return value && strcmp(value, "0") != 0;
}

rng check_rng(uint64_t stream) {
    const char *seed = runner_setting("SEED");
    return rng_seed(seed ? strtoull(seed, NULL, 10) : 1, stream);
}

_Noreturn void runner_die(const char *what) {
    fprintf(stderr, "error: the test runner cannot %s: %s\n", what, strerror(errno));
    exit(EXIT_FAILURE);
}

int exercise_length(const test *t) {
    return (int)strcspn(t->name, ":");
}

bool same_exercise(const test *a, const test *b) {
    const int length = exercise_length(a);
    return length == exercise_length(b) && strncmp(a->name, b->name, (size_t)length) == 0;
}

static bool belongs_to(const test *t, const char *exercise) {
    const size_t length = strlen(exercise);
    return (size_t)exercise_length(t) == length && strncmp(t->name, exercise, length) == 0;
}

// The tests of the exercise that `filter` names; else all whose name contains it.
static summary choose(const char *suite, const test *tests, int count, const char *filter) {
    summary s = {.suite = suite, .results = calloc((size_t)count + 1, sizeof *s.results)};
    if (!s.results) runner_die("get memory");
    bool named = false;
    for (int i = 0; filter && i < count; i++) named |= belongs_to(&tests[i], filter);
    for (int i = 0; i < count; i++)
        if (!filter ||
            (named ? belongs_to(&tests[i], filter) : strstr(tests[i].name, filter) != NULL))
            s.results[s.count++].test = &tests[i];
    return s;
}

// What does not come back costs its time once, not with every test.
static void run_one(const summary *s, result *r) {
    bool stuck_before = false;
    for (const result *before = s->results; before < r; before++) {
        if (!before->stuck) continue;
        stuck_before = true;
        r->skipped |= same_exercise(before->test, r->test);
    }
    r->cpu_limit = child_cpu_limit(stuck_before);
    if (r->skipped)
        verdict_skip(r);
    else
        process_run(r);
}

static void run_all(summary *s) {
    for (result *r = s->results; r < s->results + s->count; r++) {
        run_one(s, r);
        s->tally[r->verdict]++;
        report_test(s, r);
    }
}

int run_tests(const char *suite, const test *tests, int count) {
    summary s = choose(suite, tests, count, runner_setting("T"));
    process_catch_interrupts();
    report_start(&s);
    run_all(&s);
    const bool all_right = s.count > 0 && s.tally[PASSED] == s.count;
    const bool written = s.count > 0 ? report_end(&s, all_right) : report_none(&s);
    free(s.results);
    return all_right && written ? EXIT_SUCCESS : EXIT_FAILURE;
}
