// check.c: runs each test in a process of its own and reports the results, as
// text for people, as TAP or as JUnit XML. What a check is stands in
// check_values.c.
//
// A test's process has two pipes to the runner. One is its stdout and stderr,
// the other carries its verdict: one letter and a message. A process that ends
// without a verdict has crashed, was stopped, or left by exit().
#define _XOPEN_SOURCE 700 // POSIX 2008 with sigaltstack and strsignal

#include "tests/check.h"
#include "common/todo.h"
#include "tests/check_inside.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#ifdef __has_feature
#if __has_feature(address_sanitizer)
#define SANITIZED 1
#endif
#endif
#ifdef __SANITIZE_ADDRESS__
#define SANITIZED 1
#endif
#ifndef SANITIZED
#define SANITIZED 0
#endif

enum {
    CPU_SECONDS = SANITIZED ? 40 : 10, // of one test; a sanitizer costs up to 4 times
    WALL_PER_CPU = 6,                  // generous: the machine may be busy
    OUTPUT_LIMIT = 64 * 1024,
    PRINTED_LINES = 10, // of the test's own output, shown when it fails
};
static const rlim_t MEMORY_LIMIT = (rlim_t)4 << 30; // bytes
static const rlim_t STACK_LIMIT = (rlim_t)8 << 20;  // bytes; the usual default, for all

typedef enum { PASSED, FAILED, MISSING } verdict; // MISSING: a TODO was reached

typedef struct {
    const test *test;
    verdict verdict;
    double seconds;
    text message; // FAILED: the rows; MISSING: what is missing and where
} result;

typedef struct {
    const char *suite;
    result *results;
    int count, tally[3]; // tally[verdict]
} summary;

// ---- Environment and clock ------------------------------------------------

// The value, or NULL when it is unset or empty.
static const char *setting(const char *name) {
    const char *value = getenv(name);
    return value && *value ? value : NULL;
}

static bool flag(const char *name) {
    const char *value = setting(name);
    return value && strcmp(value, "0") != 0;
}

static int cpu_limit(void) {
    const char *value = setting("TEST_SECONDS");
    const int seconds = value ? atoi(value) : 0;
    return seconds > 0 ? seconds : CPU_SECONDS;
}

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

// ---- Inside the test's process --------------------------------------------

static int verdict_pipe = -1;
static const test *running_test;

typedef struct {
    int signal;
    void *address;
} crash;

static void send(const void *data, size_t size) {
    if (write(verdict_pipe, data, size) < 0) _exit(EXIT_FAILURE);
}

// exit, not _exit: coverage and leak reports are written then.
static _Noreturn void end_test(const char *letter, const char *message) {
    send(letter, 1);
    send(message, strlen(message));
    exit(EXIT_SUCCESS);
}

_Noreturn void test_failed(text *rows, const char *file, int line) {
    if (todo_first()) end_test("t", todo_first());
    if (running_test->hint) text_row(rows, "hint", "%s", running_test->hint);
    text_row(rows, "at", "%s:%d", file, line);
    end_test("f", rows->chars);
}

// Only calls that are safe in a signal handler.
static void crashed(int signal, siginfo_t *info, void *context) {
    (void)context;
    const crash c = {signal, info->si_addr};
    send("c", 1);
    send(&c, sizeof c);
    send(given_text(), strlen(given_text()));
    _exit(EXIT_FAILURE);
}

// The sanitizers' own handlers know more about a crash than ours.
static void catch_crashes(void) {
    static char stack[64 * 1024]; // endless recursion leaves no other to run on
    static const int signals[] = {SIGXCPU, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};
    const stack_t alternate = {.ss_sp = stack, .ss_size = sizeof stack};
    if (!SANITIZED) sigaltstack(&alternate, NULL);
    struct sigaction action = {.sa_flags = SA_SIGINFO | SA_ONSTACK | (int)SA_RESETHAND};
    action.sa_sigaction = crashed;
    for (int i = 0; i < (SANITIZED ? 1 : COUNT(signals)); i++)
        sigaction(signals[i], &action, NULL);
}

// Lowers a limit; never raises one that was set from outside.
static void limit(int resource, rlim_t soft, rlim_t hard) {
    struct rlimit r;
    if (getrlimit(resource, &r) != 0) return;
    if (hard < r.rlim_max) r.rlim_max = hard;
    if (soft < r.rlim_cur) r.rlim_cur = soft;
    if (r.rlim_cur > r.rlim_max) r.rlim_cur = r.rlim_max;
    setrlimit(resource, &r);
}

static void set_limits(void) {
    const rlim_t seconds = (rlim_t)cpu_limit();
    limit(RLIMIT_CPU, seconds, seconds + 1);
    limit(RLIMIT_CORE, 0, 0);
    if (SANITIZED) return; // its shadow memory takes terabytes of addresses
    limit(RLIMIT_AS, MEMORY_LIMIT, MEMORY_LIMIT);
    limit(RLIMIT_STACK, STACK_LIMIT, RLIM_INFINITY);
}

static _Noreturn void run_child(const test *t, int printed, int verdict_end) {
    const int nothing = open("/dev/null", O_RDONLY);
    setpgid(0, 0);
    signal(SIGINT, SIG_DFL);
    signal(SIGTERM, SIG_DFL);
    dup2(nothing, STDIN_FILENO);
    dup2(printed, STDOUT_FILENO);
    dup2(printed, STDERR_FILENO);
    verdict_pipe = verdict_end;
    running_test = t;
    set_limits();
    catch_crashes();
    t->run();
    if (todo_first()) end_test("t", todo_first());
    end_test("p", "");
}

// ---- Watching it from outside ---------------------------------------------

enum { PRINTED, VERDICT };

typedef struct {
    pid_t pid;
    int status; // from waitpid
    struct pollfd pipes[2];
    struct {
        size_t size;
        char data[OUTPUT_LIMIT + 1]; // ends with a 0
    } got[2];
    char stopped[80]; // why the runner stopped it, or ""
} process;

static volatile sig_atomic_t running_pid; // for ctrl-C, which reaches the runner alone

static void interrupted(int signal_number) {
    if (running_pid > 0) kill(-(pid_t)running_pid, SIGKILL);
    signal(signal_number, SIG_DFL);
    raise(signal_number);
}

static _Noreturn void give_up(const char *what) {
    fprintf(stderr, "error: the test runner cannot %s: %s\n", what, strerror(errno));
    exit(EXIT_FAILURE);
}

static void start(process *p, const test *t) {
    int printed[2], verdicts[2];
    if (pipe(printed) != 0 || pipe(verdicts) != 0) give_up("open a pipe");
    fflush(NULL); // or the child would write the runner's lines again
    p->pid = fork();
    if (p->pid < 0) give_up("start a process");
    if (p->pid == 0) {
        close(printed[0]);
        close(verdicts[0]);
        run_child(t, printed[1], verdicts[1]);
    }
    setpgid(p->pid, p->pid); // both do it: whoever comes first
    running_pid = p->pid;
    close(printed[1]);
    close(verdicts[1]);
    p->pipes[PRINTED] = (struct pollfd){.fd = printed[0], .events = POLLIN};
    p->pipes[VERDICT] = (struct pollfd){.fd = verdicts[0], .events = POLLIN};
    fcntl(printed[0], F_SETFL, O_NONBLOCK);
    fcntl(verdicts[0], F_SETFL, O_NONBLOCK);
}

// Reads what one pipe holds now; closes it at its end.
static void drain(process *p, int which) {
    int *fd = &p->pipes[which].fd;
    while (*fd >= 0 && p->got[which].size < OUTPUT_LIMIT) {
        const size_t size = p->got[which].size;
        const ssize_t n = read(*fd, p->got[which].data + size, OUTPUT_LIMIT - size);
        if (n < 0) return;
        p->got[which].size += (size_t)n;
        p->got[which].data[p->got[which].size] = '\0';
        if (n > 0) continue;
        close(*fd);
        *fd = -1;
    }
}

static void stop_if_over(process *p, double started) {
    const int wall_limit = WALL_PER_CPU * cpu_limit();
    if (p->stopped[0]) return;
    if (p->got[PRINTED].size >= OUTPUT_LIMIT)
        snprintf(p->stopped, sizeof p->stopped, "flood of output: stopped after %d KiB",
                 OUTPUT_LIMIT / 1024);
    else if (now() - started > wall_limit)
        snprintf(p->stopped, sizeof p->stopped, "endless loop? stopped after %d s", wall_limit);
    else
        return;
    kill(-p->pid, SIGKILL);
}

static void watch(process *p) {
    const double started = now();
    while (waitpid(p->pid, &p->status, WNOHANG) == 0) {
        const bool open = p->pipes[PRINTED].fd >= 0 || p->pipes[VERDICT].fd >= 0;
        poll(p->pipes, 2, open ? 100 : 1); // milliseconds; both closed: it is about to end
        drain(p, PRINTED);
        drain(p, VERDICT);
        stop_if_over(p, started);
    }
    running_pid = 0;
    drain(p, PRINTED);
    drain(p, VERDICT);
    kill(-p->pid, SIGKILL); // whatever it may have started
    for (int i = 0; i < 2; i++)
        if (p->pipes[i].fd >= 0) close(p->pipes[i].fd);
}

// ---- What happened --------------------------------------------------------

// The child's stack lies where ours does, since it was forked from here.
static bool is_below_stack(const void *address) {
    const uintptr_t slack = (uintptr_t)16 << 20; // one frame with a large array
    const uintptr_t here = (uintptr_t)&slack, a = (uintptr_t)address;
    struct rlimit r;
    if (getrlimit(RLIMIT_STACK, &r) != 0) return false;
    const uintptr_t size = (uintptr_t)(r.rlim_cur < STACK_LIMIT ? r.rlim_cur : STACK_LIMIT);
    return here - size - slack < a && a < here;
}

static void explain_signal(text *t, crash c) {
    const bool bad_access = c.signal == SIGSEGV || c.signal == SIGBUS;
    if (c.signal == SIGXCPU || c.signal == SIGKILL)
        text_add(t, "endless loop? stopped after %d s\n", cpu_limit());
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
    if (strstr(line, "Sanitizer: SEGV")) guess = "bad pointer? ";
    if (strstr(line, "Sanitizer: FPE")) guess = "integer division by zero? ";
    text_add(t, "crashed: %s%.*s\n", guess, (int)strcspn(line, "\n"), line);
}

// The rows of a test that ended without a failed check.
static void explain(text *t, const process *p) {
    const char *sanitizer = sanitizer_line(p->got[PRINTED].data), *said = p->got[VERDICT].data;
    crash c = {WIFSIGNALED(p->status) ? WTERMSIG(p->status) : 0, NULL};
    const bool reported = *said == 'c' && p->got[VERDICT].size > sizeof c;
    if (reported) memcpy(&c, said + 1, sizeof c);
    if (p->stopped[0])
        text_add(t, "%s\n", p->stopped);
    else if (sanitizer)
        explain_sanitizer(t, sanitizer);
    else if (c.signal)
        explain_signal(t, c);
    else
        text_add(t, "left the program by exit(%d)\n", WEXITSTATUS(p->status));
    const char *was_given = reported ? said + 1 + sizeof c : "";
    if (*was_given) text_row(t, "given", "%s", was_given);
}

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

static verdict decide(const process *p) {
    const char letter = p->got[VERDICT].data[0], *printed = p->got[PRINTED].data;
    const bool clean = WIFEXITED(p->status) && WEXITSTATUS(p->status) == 0;
    if (letter == 't') return MISSING;
    if (letter == 'f') return FAILED;
    if (letter == 'p' && clean && !sanitizer_line(printed)) return PASSED;
    return todo_line(printed) ? MISSING : FAILED; // a crash because of what a stub returned
}

static void judge(result *r, const process *p) {
    const char *said = p->got[VERDICT].data, *printed = p->got[PRINTED].data;
    r->verdict = decide(p);
    if (r->verdict == MISSING)
        describe_todo(&r->message, *said == 't' ? said + 1 : "", todo_line(printed));
    if (r->verdict != FAILED) return;
    if (*said == 'f') {
        text_add(&r->message, "%s", said + 1);
    } else {
        explain(&r->message, p);
        if (r->test->hint) text_row(&r->message, "hint", "%s", r->test->hint);
    }
    add_printed(&r->message, printed);
}

static void run_test(result *r) {
    process *p = calloc(1, sizeof *p);
    if (!p) give_up("get memory");
    const double started = now();
    start(p, r->test);
    watch(p);
    r->seconds = now() - started;
    judge(r, p);
    free(p);
}

// ---- Reports --------------------------------------------------------------

// Prints `message` with every line after `indent`.
static void print_lines(const char *indent, const char *message) {
    for (const char *line = message; *line;) {
        const int length = (int)strcspn(line, "\n");
        printf("%s%.*s\n", indent, length, line);
        line += length + (line[length] == '\n');
    }
}

static void print_for_people(const result *r) {
    static const char *const words[] = {"ok  ", "FAIL", "todo"};
    static const char *const colours[] = {"\033[32m", "\033[31m", "\033[33m"};
    const bool colour = isatty(STDOUT_FILENO) && !setting("NO_COLOR");
    if (r->verdict == PASSED && flag("QUIET")) return;
    printf("%s%s%s  %s", colour ? colours[r->verdict] : "", words[r->verdict],
           colour ? "\033[0m" : "", r->test->name);
    if (r->verdict == MISSING) printf("   (%s)", r->message.chars);
    printf("\n");
    if (r->verdict == FAILED) print_lines("      ", r->message.chars);
}

static void print_tap(const result *r, int number) {
    printf("%s %d - ", r->verdict == PASSED ? "ok" : "not ok", number);
    for (const char *c = r->test->name; *c; c++) printf(*c == '#' ? "\\#" : "%c", *c);
    if (r->verdict == MISSING) printf(" # TODO %s", r->message.chars);
    printf("\n");
    if (r->verdict == FAILED) print_lines("# ", r->message.chars);
}

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

static void write_testcase(FILE *f, const char *suite, const result *r) {
    const char *message = r->message.chars;
    fprintf(f, "  <testcase classname=\"%s\" name=\"", suite);
    write_xml(f, r->test->name, strlen(r->test->name));
    fprintf(f, "\" time=\"%.3f\"", r->seconds);
    if (r->verdict == PASSED) {
        fprintf(f, "/>\n");
        return;
    }
    fprintf(f, ">\n    <%s message=\"", r->verdict == FAILED ? "failure" : "skipped");
    write_xml(f, message, strcspn(message, "\n"));
    fprintf(f, r->verdict == FAILED ? "\">" : "\"/>\n");
    if (r->verdict == FAILED) {
        write_xml(f, message, strlen(message));
        fprintf(f, "</failure>\n");
    }
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

static bool write_tally(const char *path, const summary *s) {
    FILE *f = fopen(path, "a");
    if (f) fprintf(f, "%d %d %d\n", s->tally[PASSED], s->tally[FAILED], s->tally[MISSING]);
    if (f && fclose(f) == 0) return true;
    fprintf(stderr, "error: cannot write %s: %s\n", path, strerror(errno));
    return false;
}

static void print_end(const summary *s, bool all_right) {
    if (!flag("QUIET")) printf("%s", flag("TAP") ? "# " : "\n");
    if (flag("QUIET") && flag("TAP")) printf("# ");
    printf("%d passed, %d failed", s->tally[PASSED], s->tally[FAILED]);
    if (s->tally[MISSING] > 0) printf(", %d todo", s->tally[MISSING]);
    printf("\n");
    if (all_right && setting("SOLUTIONS") && !flag("TAP"))
        printf("All right. Compare with %s\n", setting("SOLUTIONS"));
}

// ---- The suite ------------------------------------------------------------

// The tests whose name contains `filter`, as results to be filled in.
static summary choose(const char *suite, const test *tests, int count, const char *filter) {
    summary s = {.suite = suite, .results = calloc((size_t)count + 1, sizeof *s.results)};
    if (!s.results) give_up("get memory");
    for (int i = 0; i < count; i++)
        if (!filter || strstr(tests[i].name, filter)) s.results[s.count++].test = &tests[i];
    return s;
}

static int report_none(const summary *s, const char *filter) {
    if (filter)
        fprintf(stderr, "%s: no test's name contains \"%s\"\n", s->suite, filter);
    else
        fprintf(stderr, "%s: there are no tests\n", s->suite);
    return EXIT_FAILURE;
}

static bool write_files(const summary *s) {
    bool good = true;
    if (setting("JUNIT")) good = write_junit(setting("JUNIT"), s) && good;
    if (setting("TALLY")) good = write_tally(setting("TALLY"), s) && good;
    return good;
}

int run_tests(const char *suite, const test *tests, int count) {
    summary s = choose(suite, tests, count, setting("T"));
    signal(SIGINT, interrupted);
    signal(SIGTERM, interrupted);
    if (flag("TAP")) printf("TAP version 13\n1..%d\n", s.count);
    for (int i = 0; i < s.count; i++) {
        run_test(&s.results[i]);
        s.tally[s.results[i].verdict]++;
        if (flag("TAP"))
            print_tap(&s.results[i], i + 1);
        else
            print_for_people(&s.results[i]);
    }
    const bool all_right = s.count > 0 && s.tally[PASSED] == s.count;
    if (s.count > 0) print_end(&s, all_right);
    const bool written = write_files(&s);
    if (s.count == 0) report_none(&s, setting("T"));
    free(s.results);
    return all_right && written ? EXIT_SUCCESS : EXIT_FAILURE;
}
