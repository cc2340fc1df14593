// check_verdict.c: what the end of a test's process means. Passed, failed or
// missing; and in words, why it crashed or was stopped.
#define _XOPEN_SOURCE 700 // POSIX 2008 with SIGXCPU

#include "tests/check_inside.h"

#include <signal.h>
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
    if (c.signal == SIGXCPU || c.signal == SIGKILL)
        text_add(t, "endless loop? stopped after %d s\n", child_cpu_limit());
    else if (bad_access && is_below_stack(c.address))
        text_add(t, "crashed: endless recursion? (the stack ran out)\n");
    else if (bad_access)
        text_add(t, "crashed: bad pointer? (address 0x%jx)\n", (uintmax_t)(uintptr_t)c.address);
    else if (c.signal == SIGFPE)
        text_add(t, "crashed: integer division by zero?\n");
    else if (c.signal == SIGABRT)
        text_add(t, "crashed: abort() or assert()\n");
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

// The rows of a test that ended without a failed check.
static void explain(text *t, const ending *e) {
    const char *sanitizer = sanitizer_line(e->got[PRINTED].data), *said = e->got[VERDICT].data;
    crash c = {WIFSIGNALED(e->status) ? WTERMSIG(e->status) : 0, NULL};
    const bool reported = *said == 'c' && e->got[VERDICT].size > sizeof c;
    if (reported) memcpy(&c, said + 1, sizeof c);
    if (e->stopped[0])
        text_add(t, "%s\n", e->stopped);
    else if (sanitizer)
        explain_sanitizer(t, sanitizer);
    else if (c.signal)
        explain_signal(t, c);
    else
        text_add(t, "left the program by exit(%d)\n", WEXITSTATUS(e->status));
    const char *was_given = reported ? said + 1 + sizeof c : "";
    if (*was_given) text_row(t, "given", "%s", was_given);
}

// ---- Stubs and output -----------------------------------------------------

// The line "todo: WHAT (FILE:LINE)" that common/todo.c printed, or NULL.
static const char *todo_line(const char *printed) {
    const char *line = printed;
    while (line && strncmp(line, "todo: ", 6) != 0) {
        line = strchr(line, '\n');
        if (line) line++;
    }
    return line ? line + 6 : NULL;
}

// "WHAT: FILE:LINE" when the place is known, else what the test noted.
static void describe_todo(text *t, const char *noted, const char *line) {
    const size_t length = line ? strcspn(line, "\n") : 0;
    const char *place = line ? line + length : NULL;
    while (place && place > line && strncmp(place, " (", 2) != 0) place--;
    if (!place || place == line || line[length - 1] != ')')
        text_add(t, "%s", noted);
    else
        text_add(t, "%.*s: %.*s", (int)(place - line), line, (int)(line + length - 3 - place),
                 place + 2);
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
    return todo_line(printed) ? MISSING : FAILED; // a crash because of what a stub returned
}

void verdict_judge(result *r, const ending *e) {
    const char *said = e->got[VERDICT].data, *printed = e->got[PRINTED].data;
    r->verdict = decide(e);
    if (r->verdict == MISSING)
        describe_todo(&r->message, *said == 't' ? said + 1 : "", todo_line(printed));
    if (r->verdict != FAILED) return;
    if (*said == 'f') {
        text_add(&r->message, "%s", said + 1);
    } else {
        explain(&r->message, e);
        if (r->test->hint) text_row(&r->message, "hint", "%s", r->test->hint);
    }
    add_printed(&r->message, printed);
}
