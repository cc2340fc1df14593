// check_report.c: the results as text for people or as TAP, line by line while
// the tests run; then as files, JUnit XML and a tally.
#define _POSIX_C_SOURCE 200809L

#include "tests/check_inside.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

// ---- People and TAP -------------------------------------------------------

void report_start(const summary *s) {
    if (runner_flag("TAP")) printf("TAP version 13\n1..%d\n", s->count);
}

// Prints `message` with every line after `indent`.
static void print_lines(const char *indent, const char *message) {
    for (const char *line = message; *line;) {
        const int length = (int)strcspn(line, "\n");
        printf("%s%.*s\n", indent, length, line);
        line += length + (line[length] == '\n');
    }
}

static void print_verdict(verdict v) {
    static const char *const words[] = {"ok  ", "FAIL", "todo"};
    static const char *const colours[] = {"\033[32m", "\033[31m", "\033[33m"};
    const bool colour = isatty(STDOUT_FILENO) && !runner_setting("NO_COLOR");
    printf("%s%s%s  ", colour ? colours[v] : "", words[v], colour ? "\033[0m" : "");
}

// Whether an earlier test of r's exercise has said the same.
static bool is_repeated(const summary *s, const result *r) {
    for (const result *b = s->results; b < r; b++)
        if (b->verdict == r->verdict && b->skipped == r->skipped &&
            same_exercise(b->test, r->test))
            return true;
    return false;
}

// One line for all tests of r's exercise that are to do, or that are not run.
static void print_exercise(const summary *s, const result *r) {
    if (is_repeated(s, r)) return;
    int left = 0; // r is the first of them
    for (const result *after = r; after < s->results + s->count; after++)
        left += same_exercise(after->test, r->test);
    print_verdict(r->verdict);
    printf("%.*s", exercise_length(r->test), r->test->name);
    if (r->skipped)
        printf(": %d more test%s %s", left, left == 1 ? "" : "s", r->message.chars);
    else
        printf("   (%s)\n", r->message.chars);
}

// The row of a message with this label, to the end of its last line; length 0: there is none.
static const char *row_of(const char *message, const char *label, size_t *length) {
    const size_t width = strlen(label);
    const char *row = message;
    for (*length = 0; strncmp(row, label, width) != 0;) {
        row += strcspn(row, "\n");
        if (!*row++) return message;
    }
    const char *end = row + strcspn(row, "\n");
    while (strncmp(end, "\n           ", 12) == 0) end += 1 + strcspn(end + 1, "\n");
    *length = (size_t)(end - row);
    return row;
}

static bool same_row(const result *a, const result *b, const char *label) {
    size_t length, other;
    const char *row = row_of(a->message.chars, label, &length);
    const char *also = row_of(b->message.chars, label, &other);
    return length == other && strncmp(row, also, length) == 0;
}

static bool has_row(const result *r, const char *label) {
    size_t length;
    row_of(r->message.chars, label, &length);
    return length > 0;
}

// The label of the row that tells the cause, as far as is known; or NULL.
static const char *cause_of(const result *r) {
    if (has_row(r, "looks like ")) return "looks like ";
    return has_row(r, "crashed: ") ? "crashed: " : NULL;
}

// Whether an earlier test of r's exercise has failed for the same reason, as far as is known.
static bool is_as_above(const summary *s, const result *r) {
    const char *cause = cause_of(r);
    if (runner_flag("FULL") || !cause || has_row(r, "printed ")) return false;
    for (const result *b = s->results; b < r; b++)
        if (b->verdict == FAILED && same_exercise(b->test, r->test) && same_row(b, r, cause) &&
            same_row(b, r, "hint "))
            return true;
    return false;
}

static void print_as_above(const result *r) {
    size_t length;
    const char *row = row_of(r->message.chars, cause_of(r), &length);
    printf("      as above: %.*s   (FULL=1 tells all)\n", (int)strcspn(row, "\n"), row);
}

static void print_for_people(const summary *s, const result *r) {
    if (r->verdict == PASSED && runner_flag("QUIET")) return;
    if (r->verdict == MISSING || r->skipped) {
        print_exercise(s, r);
        return;
    }
    print_verdict(r->verdict);
    printf("%s\n", r->test->name);
    if (r->verdict == FAILED && is_as_above(s, r))
        print_as_above(r);
    else
        print_lines("      ", r->message.chars);
}

static void print_tap(const result *r, int number) {
    printf("%s %d - ", r->verdict == PASSED ? "ok" : "not ok", number);
    for (const char *c = r->test->name; *c; c++) printf(*c == '#' ? "\\#" : "%c", *c);
    if (r->verdict == MISSING) printf(" # TODO %s", r->message.chars);
    printf("\n");
    if (r->verdict == FAILED) print_lines("# ", r->message.chars);
}

void report_test(const summary *s, const result *r) {
    if (runner_flag("TAP"))
        print_tap(r, (int)(r - s->results) + 1);
    else
        print_for_people(s, r);
}

static void print_end(const summary *s, bool all_right) {
    if (!runner_flag("QUIET")) printf("%s", runner_flag("TAP") ? "# " : "\n");
    if (runner_flag("QUIET") && runner_flag("TAP")) printf("# ");
    printf("%d passed, %d failed", s->tally[PASSED], s->tally[FAILED]);
    if (s->tally[MISSING] > 0) printf(", %d todo", s->tally[MISSING]);
    printf("\n");
    if (all_right && runner_setting("SOLUTIONS") && !runner_flag("TAP"))
        printf("All right. Compare with %s\n", runner_setting("SOLUTIONS"));
}

// ---- JUnit XML ------------------------------------------------------------

// The length of the UTF-8 character at s; 0 where XML allows none.
static int xml_character(const unsigned char *s) {
    if (s[0] < 0x80) return s[0] >= 0x20 || strchr("\t\n\r", s[0]) ? 1 : 0;
    const int length = s[0] >= 0xf0 ? 4 : s[0] >= 0xe0 ? 3 : 2;
    if (s[0] < 0xc2 || s[0] > 0xf4) return 0;
    for (int i = 1; i < length; i++)
        if ((s[i] & 0xc0) != 0x80) return 0;
    return length;
}

static void write_xml(FILE *f, const char *s, size_t length) {
    const char *end = s + length;
    while (s < end) {
        const int n = xml_character((const unsigned char *)s);
        const char *name = *s == '&' ? "&amp;" : *s == '<' ? "&lt;" : *s == '>' ? "&gt;" : NULL;
        if (*s == '"') name = "&quot;";
        if (name || n == 0)
            fputs(name ? name : "?", f);
        else
            fwrite(s, 1, (size_t)n, f);
        s += n > 0 ? n : 1;
    }
}

static void write_message(FILE *f, const result *r) {
    const char *message = r->message.chars;
    fprintf(f, "    <%s message=\"", r->verdict == FAILED ? "failure" : "skipped");
    write_xml(f, message, strcspn(message, "\n"));
    fprintf(f, r->verdict == FAILED ? "\">" : "\"/>\n");
    if (r->verdict != FAILED) return;
    write_xml(f, message, strlen(message));
    fprintf(f, "</failure>\n");
}

static void write_testcase(FILE *f, const char *suite, const result *r) {
    fprintf(f, "  <testcase classname=\"%s\" name=\"", suite);
    write_xml(f, r->test->name, strlen(r->test->name));
    fprintf(f, "\" time=\"%.3f\"", r->seconds);
    fprintf(f, r->verdict == PASSED ? "/>\n" : ">\n");
    if (r->verdict == PASSED) return;
    write_message(f, r);
    fprintf(f, "  </testcase>\n");
}

static bool write_suite(FILE *f, const summary *s) {
    double seconds = 0;
    for (int i = 0; i < s->count; i++) seconds += s->results[i].seconds;
    fprintf(f, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    fprintf(f,
            "<testsuite name=\"%s\" tests=\"%d\" failures=\"%d\" errors=\"0\" skipped=\"%d\" ",
            s->suite, s->count, s->tally[FAILED], s->tally[MISSING]);
    fprintf(f, "time=\"%.3f\">\n", seconds);
    for (int i = 0; i < s->count; i++) write_testcase(f, s->suite, &s->results[i]);
    fprintf(f, "</testsuite>\n");
    const bool good = !ferror(f);
    return fclose(f) == 0 && good;
}

// Written beside `path` and renamed, so that it is whole or not there.
static bool write_junit(const char *path, const summary *s) {
    char beside[4096];
    snprintf(beside, sizeof beside, "%s.%ld", path, (long)getpid());
    FILE *f = fopen(beside, "w");
    if (f && write_suite(f, s) && rename(beside, path) == 0) return true;
    fprintf(stderr, "error: cannot write %s: %s\n", path, strerror(errno));
    if (f) remove(beside);
    return false;
}

// ---- Files ----------------------------------------------------------------

static bool write_tally(const char *path, const summary *s) {
    FILE *f = fopen(path, "a");
    if (f) fprintf(f, "%d %d %d\n", s->tally[PASSED], s->tally[FAILED], s->tally[MISSING]);
    if (f && fclose(f) == 0) return true;
    fprintf(stderr, "error: cannot write %s: %s\n", path, strerror(errno));
    return false;
}

static bool write_files(const summary *s) {
    const char *junit = runner_setting("JUNIT"), *tally = runner_setting("TALLY");
    const bool good = !junit || write_junit(junit, s);
    return (!tally || write_tally(tally, s)) && good; // the one even if the other failed
}

bool report_end(const summary *s, bool all_right) {
    print_end(s, all_right);
    return write_files(s);
}

bool report_none(const summary *s) {
    const bool written = write_files(s);
    const char *filter = runner_setting("T");
    if (filter)
        fprintf(stderr, "%s: no test's name contains \"%s\"\n", s->suite, filter);
    else
        fprintf(stderr, "%s: there are no tests\n", s->suite);
    return written;
}
