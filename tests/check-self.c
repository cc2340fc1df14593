// check-self.c: tests of the test runner. It runs the fixtures program, whose
// tests go wrong in known ways, and reads what is said about them.
#define _POSIX_C_SOURCE 200809L

#include "tests/check-self.h"

// ---- Each fixture gives its one clear message ------------------------------

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
        {"crash: null", "printed    just before the crash\n"},
        {"crash: recursion", "crashed: endless recursion?"},
        {"crash: abort", "crashed: abort() or assert()"},
        {"crash: exit", "left the program by exit(3)"},
        {"crash: flood", "flood of output: stopped after 64 KiB"},
        {"crash: ", "0 passed, 6 failed"},
        {"loop: ", "endless loop? stopped after 1 s"},
    };
    check_rows(rows, COUNT(rows), 1);
}

static void hints(void) { // they are about wrong values
    must_say(run("", "print: "), "      hint       a hint\n");
    must_not_say(run("", "crash: "), "hint");
    must_not_say(run("", "loop: "), "hint");
}

static void divisions(void) {
    const outcome *o = run("", "crash: division"); // a sanitizer words it otherwise
    CHECK(strstr(o->output, "division by zero") != NULL, "it says: division by zero");
}

// ---- What did not come back is not called again ----------------------------

static void stuck(void) {
    const outcome *o = run("", "stuck: ");
    must_say(o, "FAIL  stuck: first\n"
                "      endless loop? stopped after 1 s\n"
                "      given      a test that is out of time, nan\n"
                "ok    unstuck: passes\n"
                "FAIL  stuck: 2 more tests not run: it did not come back\n"
                "FAIL  unstuck: time limit\n");
    must_say(o, "\n\n1 passed, 4 failed\n");
    must_not_say(run("", "crash: "), "not run");
}

static void stuck_in_files(void) {
    const char *reason = "not ok 3 - stuck: second\n# not run: it did not come back\n";
    must_say(run("TAP=1", "stuck: "), reason);
    must_say(file_of("JUNIT", "stuck: "),
             "<failure message=\"not run: it did not come back\">");
    must_say(file_of("TALLY", "stuck: "), "1 4 0\n");
}

static void asleep(void) {
    const outcome *o = run("", "asleep");
    must_say(o, "FAIL  asleep\n      endless loop? stopped after 6 s\n"
                "FAIL  asleep: 1 more test not run: it did not come back\n");
}

static bool limit_is(const outcome *o, const char *usual, const char *sanitized) {
    printf("%s", o->output);
    return strstr(o->output, usual) || strstr(o->output, sanitized);
}

static void less_time(void) {
    const char *none = "TEST_SECONDS=";
    CHECK(limit_is(run(none, "time limit"), "got        10\n", "got        40\n"), "10 s");
    CHECK(limit_is(run(none, "stuck: "), "got        2\n", "got        8\n"), "2 s");
    must_say(run("TEST_SECONDS=5", "stuck: "), "got        5\n");
}

// ---- Stubs -----------------------------------------------------------------

static void todos(void) {
    static const row rows[] = {
        {"todo: ", "todo  todo   (stub is not written yet: tests/check-fixtures.c:"},
        {"stub: ", "todo  stub   (not written yet, or its TODO line is still there: tests/"},
        {"todo: right", "0 passed, 0 failed, 1 todo\n"},
        {"todo: crash", "0 passed, 0 failed, 1 todo\n"},
    };
    check_rows(rows, COUNT(rows), 1);
}

static void todo_lines(void) {
    const outcome *o = run("", "todo: ");
    CHECK(strstr(o->output, ")\n\n0 passed, 0 failed, 3 todo\n") == strchr(o->output, ')'),
          "one line for the exercise, a blank line and the closing line");
}

// ---- What a wrong answer looks like ----------------------------------------

#define REAL_ROW(name, got, words) {"real: " #name ".", words},
#define VEC3_ROW(name, x, y, z, words) {"vec3: " #name ".", words},

static void numbers(void) {
    static const row rows[] = {REAL_ROWS(REAL_ROW)};
    check_rows(rows, COUNT(rows), 1);
}

static void vectors(void) {
    static const row rows[] = {VEC3_ROWS(VEC3_ROW)};
    check_rows(rows, COUNT(rows), 1);
}

static void others(void) {
    static const row rows[] = {
        {"miss: expected", "a hit was reported where there is none"},
        {"int: one too many", "looks like one too many"},
        {"bound: too much", "expected   at most 2.5 (chi², 3 degrees of freedom)"},
        {"bound: nan", "looks like NaN"},
        {"bool: wrong", "expected   true\n      got        false"},
        {"nearly: in double", IN_DOUBLE},
        {"statistics: ", SILENT},
        {"zero: expected", SILENT},
        {"one: expected", SILENT},
    };
    check_rows(rows, COUNT(rows), 1);
}

static void suspects(void) {
    static const row rows[] = {
        {"suspect: first", "looks like the far side"},
        {"suspect: factor", "looks like the cosine is missing"},
        {"suspect: vector", "looks like the other side"},
        {"suspect: nearly", "looks like what the cheap formula gives"},
        {"suspect: forgotten", SILENT},
    };
    check_rows(rows, COUNT(rows), 1);
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

// What fails for the same reason is told once in each exercise, unless it has more to say.
static void as_above(void) {
    const outcome *o = run("", "again: ");
    must_say(o, "      got        false\n"
                "      looks like a well-known slip\n"
                "      hint       a hint\n");
    must_say(o, "FAIL  again: the same\n"
                "      as above: looks like a well-known slip   (FULL=1 tells all)\n"
                "FAIL  again: printed\n"
                "      given      an answer that no number tells\n");
    must_say(o, "FAIL  again: another hint\n"
                "      given      an answer that no number tells\n");
    must_say(o, "FAIL  again: forgotten\n"
                "      as above: looks like a well-known slip   (FULL=1 tells all)\n");
    must_say(run("", "a"), "FAIL  anew: in another exercise\n      given ");
    must_not_say(run("FULL=1", "again: "), "as above");
    must_not_say(run("TAP=1", "again: "), "as above");
    must_not_say(file_of("JUNIT", "again: "), "as above");
}

static void crashed_as_above(void) {
    const outcome *o = run("", "fallen: ");
    must_say(o, "FAIL  fallen: first\n      crashed: abort() or assert()\n"
                "FAIL  fallen: too\n"
                "      as above: crashed: abort() or assert()   (FULL=1 tells all)\n"
                "FAIL  fallen: otherwise\n      left the program by exit(3)\n");
    must_not_say(run("FULL=1", "fallen: "), "as above");
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

// "one" is an exercise here, and stands in "int: one too many" as well.
static void whole_name(void) {
    must_say(run("", "one"), "one: ");
    must_not_say(run("", "one"), "int: one");
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
    must_say(run("TAP=1", "todo: right"),
             "not ok 1 - todo: right # TODO stub is not written yet: ");
    const char *strays =
        "grep -v -e '^ok ' -e '^not ok ' -e '^#' -e '^TAP version 13$' -e '^1\\.\\.'";
    char command[4096];
    snprintf(command, sizeof command, "TAP=1 T=: %s | %s", fixtures(), strays);
    CHECK(shell(command)->output[0] == '\0', "no other line in a TAP stream");
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
        {"crash: no hint", hints, NULL},
        {"crash: integer division by zero", divisions, NULL},
        {"stuck: the rest of its exercise is not run", stuck, NULL},
        {"stuck: in TAP, JUnit and tally", stuck_in_files, NULL},
        {"stuck: stopped by the clock", asleep, NULL},
        {"stuck: less time for the others", less_time, NULL},
        {"todo: neither a pass nor a failure", todos, NULL},
        {"todo: one line for an exercise", todo_lines, NULL},
        {"message: the rows", block, NULL},
        {"message: tell-tale numbers", numbers, NULL},
        {"message: tell-tale vectors", vectors, NULL},
        {"message: other checks", others, NULL},
        {"message: suspects come first", suspects, NULL},
        {"message: as above", as_above, NULL},
        {"message: a crash as above", crashed_as_above, NULL},
        {"message: what the test printed", printed, NULL},
        {"setting: T that matches nothing", no_match, NULL},
        {"setting: T that is an exercise's whole name", whole_name, NULL},
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
