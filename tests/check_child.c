// check_child.c: what happens inside the process of a test: limits, the test
// itself, and its verdict, a message to check_process.c. A process that ends
// without one was stopped or left by exit().
#define _XOPEN_SOURCE 700 // POSIX 2008 with sigaltstack

#include "common/todo.h"
#include "tests/check_inside.h"

#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
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

#if SANITIZED
// What OpenMP's own library keeps until the end is no leak of the student's.
const char *__lsan_default_suppressions(void);
const char *__lsan_default_suppressions(void) {
    return "leak:libomp\nleak:libgomp\n";
}
#endif

enum { SLOWER = SANITIZED ? 4 : 1 }; // a sanitizer costs up to so many times
enum { CPU_SECONDS = 10 * SLOWER, SECONDS_LATER = 2 * SLOWER };
static const rlim_t MEMORY_LIMIT = (rlim_t)4 << 30; // bytes

// ---- Limits ---------------------------------------------------------------

int child_cpu_limit(bool stuck_before) {
    const char *value = runner_setting("TEST_SECONDS");
    const int seconds = value ? atoi(value) : 0;
    if (seconds > 0) return seconds;
    return stuck_before ? SECONDS_LATER : CPU_SECONDS;
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

static void set_limits(rlim_t cpu_seconds) {
    limit(RLIMIT_CPU, cpu_seconds, cpu_seconds + 1);
    limit(RLIMIT_CORE, 0, 0);
    if (SANITIZED) return; // its shadow memory takes terabytes of addresses
    limit(RLIMIT_AS, MEMORY_LIMIT, MEMORY_LIMIT);
    limit(RLIMIT_STACK, STACK_LIMIT, RLIM_INFINITY);
}

// ---- The verdict ----------------------------------------------------------

static int verdict_pipe = -1;
static const test *running_test;

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
    const char *hint = hint_given() ? hint_given() : running_test->hint;
    if (hint) text_row(rows, "hint", "%s", hint);
    if (file) text_row(rows, "at", "%s:%d", file, line);
    end_test("f", rows->chars);
}

// ---- Crashes --------------------------------------------------------------

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

// ---- The test -------------------------------------------------------------

static void connect_output(int printed_end) {
    const int nothing = open("/dev/null", O_RDONLY);
    dup2(nothing, STDIN_FILENO);
    dup2(printed_end, STDOUT_FILENO);
    dup2(printed_end, STDERR_FILENO);
    setvbuf(stdout, NULL, _IOLBF, 0); // what was printed before a crash must be seen
}

_Noreturn void child_run(const result *r, int printed_end, int verdict_end) {
    setpgid(0, 0);
    signal(SIGINT, SIG_DFL);
    signal(SIGTERM, SIG_DFL);
    connect_output(printed_end);
    verdict_pipe = verdict_end;
    running_test = r->test;
    set_limits((rlim_t)r->cpu_limit);
    catch_crashes();
    running_test->run();
    if (todo_first()) end_test("t", todo_first());
    end_test("p", "");
}
