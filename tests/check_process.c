// check_process.c: one test in a process of its own, seen from outside: starts
// it, reads what it says, stops it when it goes on for too long.
//
// Two pipes lead from the test's process to the runner. One is its stdout and
// stderr, the other carries its verdict.
#define _XOPEN_SOURCE 700 // POSIX 2008 with SIGXCPU

#include "tests/check_inside.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

typedef struct {
    pid_t pid;
    struct pollfd pipes[2];
    ending end;
} process;

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static volatile sig_atomic_t running_pid; // for ctrl-C, which reaches the runner alone

static void interrupted(int signal_number) {
    if (running_pid > 0) kill(-(pid_t)running_pid, SIGKILL);
    signal(signal_number, SIG_DFL);
    raise(signal_number);
}

void process_catch_interrupts(void) {
    signal(SIGINT, interrupted);
    signal(SIGTERM, interrupted);
}

static struct pollfd read_end(int fd) {
    fcntl(fd, F_SETFL, O_NONBLOCK);
    return (struct pollfd){.fd = fd, .events = POLLIN};
}

static void start(process *p, const result *r) {
    int printed[2], verdicts[2];
    if (pipe(printed) != 0 || pipe(verdicts) != 0) runner_die("open a pipe");
    fflush(NULL); // or the child would write the runner's lines again
    p->pid = fork();
    if (p->pid < 0) runner_die("start a process");
    if (p->pid == 0) {
        close(printed[0]);
        close(verdicts[0]);
        child_run(r, printed[1], verdicts[1]);
    }
    setpgid(p->pid, p->pid); // both do it: whoever comes first
    running_pid = p->pid;
    close(printed[1]);
    close(verdicts[1]);
    p->pipes[PRINTED] = read_end(printed[0]);
    p->pipes[VERDICT] = read_end(verdicts[0]);
}

// Reads what one pipe holds now; closes it at its end.
static void drain(process *p, int which) {
    int *fd = &p->pipes[which].fd;
    while (*fd >= 0 && p->end.got[which].size < OUTPUT_LIMIT) {
        const size_t size = p->end.got[which].size;
        const ssize_t n = read(*fd, p->end.got[which].data + size, OUTPUT_LIMIT - size);
        if (n < 0) return;
        p->end.got[which].size += (size_t)n;
        p->end.got[which].data[p->end.got[which].size] = '\0';
        if (n > 0) continue;
        close(*fd);
        *fd = -1;
    }
}

// Past its end a test is asked to stop, as by the limit of processor time: it then says what was
// given. A second later it is not asked any more.
static void stop_if_over(process *p, double end) {
    ending *e = &p->end;
    if (e->stopped == TOO_LONG && now() > end + 1) kill(-p->pid, SIGKILL);
    if (e->stopped) return;
    if (now() > end) {
        e->stopped = TOO_LONG;
        kill(-p->pid, SIGXCPU);
    } else if (e->got[PRINTED].size >= OUTPUT_LIMIT) {
        e->stopped = FLOODED;
        kill(-p->pid, SIGKILL);
    }
}

static void drain_both(process *p) {
    drain(p, PRINTED);
    drain(p, VERDICT);
}

static void watch(process *p, double end) {
    while (waitpid(p->pid, &p->end.status, WNOHANG) == 0) {
        const bool open = p->pipes[PRINTED].fd >= 0 || p->pipes[VERDICT].fd >= 0;
        poll(p->pipes, 2, open ? 100 : 1); // milliseconds; both closed: it is about to end
        drain_both(p);
        stop_if_over(p, end);
    }
    running_pid = 0;
    drain_both(p);
    kill(-p->pid, SIGKILL); // whatever it may have started
    for (int i = 0; i < 2; i++)
        if (p->pipes[i].fd >= 0) close(p->pipes[i].fd);
}

void process_run(result *r) {
    static process p; // static: in the child, a leak checker would miss its owner
    memset(&p, 0, sizeof p);
    const double started = now();
    start(&p, r);
    watch(&p, started + WALL_PER_CPU * r->cpu_limit);
    r->seconds = now() - started;
    verdict_judge(r, &p.end);
}
