// check-self.c: tests of the test runner. It runs the fixtures program, whose
// tests go wrong in known ways, and reads what is said about them.
//
// FIXTURES names that program; else it is build/check-fixtures.
#define _POSIX_C_SOURCE 200809L

#include "tests/check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

typedef struct {
    int status; // exit status
    char output[64 * 1024];
} outcome;

// Runs a shell command. Nothing in our own environment shall reach the fixtures.
static const outcome *shell(const char *command) {
    static outcome o;
    char line[8192];
    snprintf(line, sizeof line,
             "T= TAP= JUNIT= TALLY= QUIET= SOLUTIONS= TEST_SECONDS=1; "
             "export T TAP JUNIT TALLY QUIET SOLUTIONS TEST_SECONDS; %s 2>&1",
             command);
    FILE *f = popen(line, "r");
    if (!f) return &o;
    const size_t n = fread(o.output, 1, sizeof o.output - 1, f);
    o.output[n] = '\0';
    const int status = pclose(f);
    o.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    given("%s", command);
    return &o;
}

static const char *fixtures(void) {
    const char *path = getenv("FIXTURES");
    return path && *path ? path : "build/check-fixtures";
}

// Runs the fixtures whose name contains `filter`, with `settings` such as "TAP=1".
static const outcome *run(const char *settings, const char *filter) {
    char command[4096];
    snprintf(command, sizeof command, "%s T='%s' %s", settings, filter, fixtures());
    return shell(command);
}

// What a failed test prints is shown with it.
static void printed_beside(const outcome *o, const char *words) {
    fputs("words: ", stdout);
    puts(words);
    puts(o->output);
}

static void must_say(const outcome *o, const char *words) {
    const bool said = strstr(o->output, words) != NULL;
    if (!said) printed_beside(o, words);
    CHECK(said, "the runner says the words printed below");
}

static void must_not_say(const outcome *o, const char *words) {
    const bool said = strstr(o->output, words) != NULL;
    if (said) printed_beside(o, words);
    CHECK(!said, "the runner does not say the words printed below");
}

// ---- Each fixture gives its one clear message ------------------------------

typedef struct {
    const char *filter, *words;
} row;

static void check_rows(const row *rows, int count, int status) {
    for (int i = 0; i < count; i++) {
        const outcome *o = run("", rows[i].filter);
        CHECK_INT(o->status, status);
        must_say(o, rows[i].words);
    }
}

static void passes(void) {
    const outcome *o = run("", "pass: everything");
    CHECK_INT(o->status, 0);
    CHECK(strcmp(o->output, "ok    pass: everything\n\n1 passed, 0 failed\n") == 0,
          "a passing test gives its line, a blank line and the closing line");
}

static void chi2_passes(void) {
    CHECK_INT(run("", "pass: chi2")->status, 0);
}

static void crashes(void) {
    static const row rows[] = {
        {"crash: null", "crashed: bad pointer?"},
        {"crash: recursion", "crashed: endless recursion?"},
        {"crash: abort", "crashed: abort() or assert()"},
        {"crash: exit", "left the program by exit(3)"},
        {"crash: loop", "endless loop? stopped after 1 s"},
        {"crash: flood", "flood of output: stopped after 64 KiB"},
        {"crash: null", "hint       Look at the pointer."},
        {"crash: null", "printed    just before the crash\n"},
        {"crash: ", "0 passed, 7 failed"},
    };
    check_rows(rows, COUNT(rows), 1);
}

static void divisions(void) {
    const outcome *o = run("", "crash: division"); // a sanitizer words it otherwise
    CHECK(strstr(o->output, "division by zero") != NULL, "it says: division by zero");
}

static void todos(void) {
    static const row rows[] = {
        {"todo: wrong",
         "todo  todo: wrong   (stub is not written yet: tests/check-fixtures.c:"},
        {"todo: right", "0 passed, 0 failed, 1 todo\n"},
        {"todo: crash", "0 passed, 0 failed, 1 todo\n"},
    };
    check_rows(rows, COUNT(rows), 1);
}

static void factors(void) {
    static const row rows[] = {
        {"real: minus.", "the sign is wrong"},
        {"real: twice.", "looks like twice"},
        {"real: half.", "looks like half"},
        {"real: four.", "looks like 4 times"},
        {"real: quarter.", "looks like a quarter"},
        {"real: times_pi.", "looks like π times"},
        {"real: over_pi.", "divided by π\n"},
        {"real: times_2pi.", "looks like 2π times"},
        {"real: over_2pi.", "divided by 2π\n"},
        {"real: square.", "the square of"},
        {"real: root.", "the square root of"},
        {"real: reciprocal.", "the reciprocal of"},
        {"real: nothing.", "looks like nothing was computed?"},
        {"real: nan.", "looks like NaN"},
        {"real: infinity.", "reported as a miss"},
        {"real: minus_infinity.", "looks like minus infinity"},
        {"real: slightly.", "got        3.7001 (off by 0.0001)"},
        {"miss: expected", "a hit was reported where there is none"},
        {"int: one too many", "looks like one too many"},
        {"bound: too much", "expected   at most 2.5 (chi², 3 degrees of freedom)"},
        {"bound: nan", "looks like NaN"},
        {"bool: wrong", "expected   true\n      got        false"},
    };
    check_rows(rows, COUNT(rows), 1);
}

static void vectors(void) {
    static const row rows[] = {
        {"vec3: negated.", "the sign is wrong"},
        {"vec3: flip_x.", "the sign of x is wrong"},
        {"vec3: flip_y.", "the sign of y is wrong"},
        {"vec3: flip_z.", "the sign of z is wrong"},
        {"vec3: swap_xy.", "x and y are swapped"},
        {"vec3: swap_yz.", "y and z are swapped"},
        {"vec3: swap_xz.", "x and z are swapped"},
        {"vec3: shift.", "shifted: y, z, x"},
        {"vec3: longer.", "the right direction, but 2.5 times as long: not normalised?"},
        {"vec3: twice.", "looks like twice"},
        {"vec3: squared.", "each component squared"},
        {"vec3: nothing.", "nothing was computed?"},
        {"vec3: nan.", "looks like NaN"},
    };
    check_rows(rows, COUNT(rows), 1);
}

static void suspects(void) {
    static const row rows[] = {
        {"suspect: first", "looks like the far side"},
        {"suspect: factor", "looks like the cosine is missing"},
        {"suspect: vector", "looks like the other side"},
    };
    check_rows(rows, COUNT(rows), 1);
}

static void silence(void) {
    static const char *const filters[] = {
        "real: slightly.",    "real: no_idea.", "vec3: no_idea.",
        "suspect: forgotten", "zero: expected", "one: expected",
    };
    for (int i = 0; i < COUNT(filters); i++) {
        const outcome *o = run("", filters[i]);
        must_say(o, "0 passed, 1 failed");
        must_not_say(o, "looks like");
    }
}

static void block(void) {
    const outcome *o = run("", "suspect: first");
    static const char expected[] = "FAIL  suspect: first\n"
                                   "      given      the value that the test foresaw, 7\n"
                                   "      called     7.4\n"
                                   "      expected   3.7\n"
                                   "      got        7.4\n"
                                   "      allowed    exactly this\n"
                                   "      looks like the far side\n"
                                   "      at         tests/check-fixtures.c:";
    printf("%s", o->output);
    CHECK(strncmp(o->output, expected, strlen(expected)) == 0, "the rows stand aligned");
}

static void printed(void) {
    const outcome *o = run("", "print: ");
    must_say(o, "      printed    line 1 ");
    must_say(o, "                 line 10 ");
    must_not_say(o, "line 11 ");
}

// ---- Formats and settings --------------------------------------------------

static void no_match(void) {
    const outcome *o = run("", "no such test");
    CHECK_INT(o->status, 1);
    CHECK(strcmp(o->output, "check-fixtures: no test's name contains \"no such test\"\n") == 0,
          "one clear line");
}

static void quiet(void) {
    must_not_say(run("QUIET=1", "pass: "), "ok  ");
    must_say(run("QUIET=1", "int: one"), "FAIL  int: one too many");
}

static void solutions(void) {
    const char *words = "All right. Compare with solutions/04";
    must_say(run("SOLUTIONS=solutions/04", "pass: "), words);
    must_not_say(run("SOLUTIONS=solutions/04", "o"), words);
}

static void tap(void) {
    const outcome *o = run("TAP=1", "print: ");
    CHECK_INT(o->status, 1);
    CHECK(strncmp(o->output, "TAP version 13\n1..1\nnot ok 1 - print: <tag> & \\#1\n# ", 51) ==
              0,
          "version, plan, result, diagnostics");
    must_say(run("TAP=1", "pass: chi2"), "1..1\nok 1 - pass: chi2\n");
    must_say(run("TAP=1", "todo: right"), "not ok 1 - todo: right # TODO stub");
    const char *strays =
        "grep -v -e '^ok ' -e '^not ok ' -e '^#' -e '^TAP version 13$' -e '^1\\.\\.'";
    char command[4096];
    snprintf(command, sizeof command, "TAP=1 T=: %s | %s", fixtures(), strays);
    CHECK(shell(command)->output[0] == '\0', "no other line in a TAP stream");
}

// A name in the folder for temporary files.
static const char *temporary(void) {
    static char path[512];
    const char *folder = getenv("TMPDIR");
    snprintf(path, sizeof path, "%s/check-self.%ld", folder && *folder ? folder : "/tmp",
             (long)getpid());
    return path;
}

// What the fixtures write into the file that the setting `name` names.
static const outcome *file_of(const char *name, const char *filter) {
    char command[4096];
    snprintf(command, sizeof command, "%s=%s T='%s' %s >/dev/null; cat %s; rm -f %s", name,
             temporary(), filter, fixtures(), temporary(), temporary());
    return shell(command);
}

static void tally(void) {
    CHECK(strcmp(file_of("TALLY", "todo: ")->output, "0 0 3\n") == 0, "0 0 3");
    CHECK(strcmp(file_of("TALLY", "pass: ")->output, "2 0 0\n") == 0, "2 0 0");
    CHECK(strcmp(file_of("TALLY", "bool: ")->output, "0 1 0\n") == 0, "0 1 0");
}

static void junit(void) {
    const outcome *o = file_of("JUNIT", "print: ");
    must_say(o, "<testsuite name=\"check-fixtures\" tests=\"1\" failures=\"1\" errors=\"0\"");
    must_say(o, "name=\"print: &lt;tag&gt; &amp; #1\" time=\"");
    must_say(o, "this &lt; fails &amp; &quot;prints&quot;");
    must_say(o, "line 1 &lt;&amp;&gt;&quot;??\n");
    must_say(file_of("JUNIT", "todo: right"),
             "<skipped message=\"stub is not written yet: tests/");
    must_say(file_of("JUNIT", "pass: chi2"), "name=\"pass: chi2\" time=\"0.");
}

// Every tag is closed by its own: a stack of names, in awk.
static void junit_well_formed(void) {
    char command[4096];
    snprintf(command, sizeof command,
             "JUNIT=%s T=: %s >/dev/null; awk 'BEGIN { RS = \"<\" } NR > 1 && !/^\\?/ {"
             " split($0, a, /[ >\\/]/); end = /^\\//; tag = end ? a[2] : a[1];"
             " if (end && open[n--] != tag) bad = 1; sub(/>[^>]*$/, \"\");"
             " if (!end && !/\\/$/) open[++n] = tag }"
             " END { print (NR > 50 && n == 0 && !bad) ? \"well formed\" : \"broken\" }' %s;"
             " rm -f %s",
             temporary(), fixtures(), temporary(), temporary());
    must_say(shell(command), "well formed");
}

static void junit_nowhere(void) {
    const outcome *o = run("JUNIT=/no/such/folder/file.xml", "pass: chi2");
    CHECK_INT(o->status, 1);
    must_say(o, "error: cannot write /no/such/folder/file.xml: ");
}

int main(void) {
    static const test tests[] = {
        {"pass: a passing test passes", passes, NULL},
        {"pass: chi2_limit agrees with tables", chi2_passes, NULL},
        {"crash: each kind has its message", crashes, NULL},
        {"crash: integer division by zero", divisions, NULL},
        {"todo: neither a pass nor a failure", todos, NULL},
        {"message: the rows", block, NULL},
        {"message: tell-tale numbers", factors, NULL},
        {"message: tell-tale vectors", vectors, NULL},
        {"message: suspects come first", suspects, NULL},
        {"message: silent rather than wrong", silence, NULL},
        {"message: what the test printed", printed, NULL},
        {"setting: T that matches nothing", no_match, NULL},
        {"setting: QUIET", quiet, NULL},
        {"setting: SOLUTIONS", solutions, NULL},
        {"setting: TALLY", tally, NULL},
        {"tap: lines", tap, NULL},
        {"junit: content", junit, NULL},
        {"junit: well formed", junit_well_formed, NULL},
        {"junit: cannot be written", junit_nowhere, NULL},
    };
    return run_tests("check-self", tests, COUNT(tests));
}
