// check_verdict.c: what the end of a test's process means. Passed, failed or
// missing; and in words, why it crashed or was stopped.
#define _XOPEN_SOURCE 700 // POSIX 2008 with SIGXCPU

#include "tests/check_inside.h"

#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>

enum { PRINTED_LINES = 10 }; // of the test's own output, shown when it fails

// ---- Crashes --------------------------------------------------------------

// The child's stack lies where ours does, since it was forked from here.
static bool is_below_stack(const void *address) {
    const uintptr_t slack = (uintptr_t)64 << 20; // frames with large arrays, inlined
    const uintptr_t here = (uintptr_t)&slack, a = (uintptr_t)address;
    struct rlimit r;
    if (getrlimit(RLIMIT_STACK, &r) != 0) return false;
    const uintptr_t size = (uintptr_t)(r.rlim_cur < STACK_LIMIT ? r.rlim_cur : STACK_LIMIT);
    return here - size - slack < a && a < here;
}

static void explain_signal(text *t, crash c) {
    const bool bad_access = c.signal == SIGSEGV || c.signal == SIGBUS;
    if (bad_access && is_below_stack(c.address))
        text_add(t, "crashed: endless recursion? (the stack ran out)\n");
    else if (bad_access)
        text_add(t, "crashed: bad pointer? (address 0x%jx)\n", (uintmax_t)(uintptr_t)c.address);
    else if (c.signal == SIGFPE)
        text_add(t, "crashed: integer division by zero?\n");
    else if (c.signal == SIGABRT)
        text_add(t, "crashed: abort() or assert()\n");
    else if (c.signal == SIGILL)
        text_add(t, "crashed: a trap of the compiler: division by zero, or no return?\n");
    else
        text_add(t, "crashed: %s\n", strsignal(c.signal));
}

// A sanitizer's line about what went wrong, or NULL.
static const char *sanitizer_line(const char *printed) {
    const char *line = strstr(printed, ": runtime error: ");
    if (!line) return strstr(printed, "SUMMARY: ");
    while (line > printed && line[-1] != '\n') line--;
    return line;
}

static void explain_sanitizer(text *t, const char *line) {
    const char *guess = "";
    if (strstr(line, "stack-overflow")) guess = "endless recursion? ";
    if (strstr(line, "null pointer")) guess = "bad pointer? ";
    if (strstr(line, "Sanitizer: SEGV")) guess = "bad pointer? ";
    if (strstr(line, "Sanitizer: FPE")) guess = "integer division by zero? ";
    text_add(t, "crashed: %s%.*s\n", guess, (int)strcspn(line, "\n"), line);
}

// What crashed() in check_child.c sent, else what the status says.
static crash crash_of(const ending *e) {
    const char *said = e->got[VERDICT].data;
    crash c = {WIFSIGNALED(e->status) ? WTERMSIG(e->status) : 0, NULL};
    if (*said == 'c' && e->got[VERDICT].size > sizeof c) memcpy(&c, said + 1, sizeof c);
    return c;
}

// Stopped by the clock, or by the limit of processor time: SIGKILL follows SIGXCPU.
static bool did_not_come_back(const ending *e) {
    const int signal = crash_of(e).signal;
    if (e->stopped) return e->stopped == TOO_LONG;
    return signal == SIGXCPU || signal == SIGKILL;
}

static void explain_end(text *t, const ending *e) {
    const char *sanitizer = sanitizer_line(e->got[PRINTED].data);
    const crash c = crash_of(e);
    if (e->stopped == FLOODED)
        text_add(t, "flood of output: stopped after %d KiB\n", OUTPUT_LIMIT / 1024);
    else if (sanitizer)
        explain_sanitizer(t, sanitizer);
    else if (c.signal)
        explain_signal(t, c);
    else
        text_add(t, "left the program by exit(%d)\n", WEXITSTATUS(e->status));
}

// The rows of a test that ended without a failed check. Without its hint, which
// is about wrong values.
static void explain(result *r, const ending *e) {
    text *t = &r->message;
    r->stuck = did_not_come_back(e);
    if (r->stuck)
        text_add(t, "endless loop? stopped after %d s\n",
                 r->cpu_limit * (e->stopped ? WALL_PER_CPU : 1));
    else
        explain_end(t, e);
    const char *said = e->got[VERDICT].data;
    const bool reported = *said == 'c' && e->got[VERDICT].size > 1 + sizeof(crash);
    if (reported) text_row(t, "given", "%s", said + 1 + sizeof(crash));
}

// ---- Stubs and output -----------------------------------------------------

typedef struct {
    char what[64], place[512];
} todo;

// The first line of common/todo.c's that was printed; false when there is none.
static bool find_todo(const char *printed, todo *found) {
    for (const char *line = printed; line; line = strchr(line, '\n')) {
        line += *line == '\n';
        if (sscanf(line, "todo: %63s is not written yet (%511[^)\n])", found->what,
                   found->place) == 2)
            return true;
    }
    return false;
}

// What a stub is in the way of: its own tests, or those of a later exercise.
static void describe_todo(text *t, const test *of, const ending *e) {
    const char *own = text_kept("%.*s", exercise_length(of), of->name);
    todo found;
    if (!find_todo(e->got[PRINTED].data, &found))
        text_add(t, "%s is not written yet", e->got[VERDICT].data + 1);
    else if (strcmp(found.what, own) == 0)
        text_add(t, "not written yet, or its TODO line is still there: %s", found.place);
    else
        text_add(t, "%s is not written yet: %s", found.what, found.place);
}

static void add_printed(text *t, const char *printed) {
    size_t length = 0;
    for (int lines = 0; lines < PRINTED_LINES && printed[length]; lines++) {
        length += strcspn(printed + length, "\n");
        if (printed[length]) length++;
    }
    const bool all = printed[length] == '\0';
    while (length > 0 && printed[length - 1] == '\n') length--;
    if (length > 4000) length = 4000;
    if (length > 0) text_row(t, "printed", "%.*s%s", (int)length, printed, all ? "" : "\n...");
}

// ---- The verdict ----------------------------------------------------------

static verdict decide(const ending *e) {
    const char letter = e->got[VERDICT].data[0], *printed = e->got[PRINTED].data;
    const bool clean = WIFEXITED(e->status) && WEXITSTATUS(e->status) == 0;
    if (letter == 't') return MISSING;
    if (letter == 'f') return FAILED;
    if (letter == 'p' && clean && !sanitizer_line(printed)) return PASSED;
    todo stub; // its answer led to a crash
    return find_todo(printed, &stub) ? MISSING : FAILED;
}

void verdict_judge(result *r, const ending *e) {
    const char *said = e->got[VERDICT].data;
    r->verdict = decide(e);
    if (r->verdict == MISSING) describe_todo(&r->message, r->test, e);
    if (r->verdict != FAILED) return;
    if (*said == 'f')
        text_add(&r->message, "%s", said + 1);
    else
        explain(r, e);
    add_printed(&r->message, e->got[PRINTED].data);
}

void verdict_skip(result *r) {
    r->verdict = FAILED;
    text_add(&r->message, "not run: it did not come back\n");
}
