// program.c: the student's program as a process of its own, within the limits of the test that
// runs it: tests/check_child.c set them, and what it starts inherits them.
#define _POSIX_C_SOURCE 200809L
#include "tests/homework/homework.h"

#include "common/todo.h"

#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

enum { LARGEST_FILE = 16 << 20 }; // bytes

_Noreturn void fail(const text *more, const char *format, ...) {
    char words[1024];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(words, sizeof words, format, arguments);
    va_end(arguments);
    static text rows;
    rows.length = 0;
    text_add(&rows, "%s\n%s", words, more ? more->chars : "");
    test_failed(&rows, NULL, 0);
}

static const char *setting(const char *name) {
    const char *value = runner_setting(name);
    if (!value) fail(NULL, "%s is not set: use make homework", name);
    return value;
}

const char *program_folder(void) {
    return setting("HOMEWORK");
}

// Lives until four more are made.
static const char *in_folder(const char *file) {
    static char kept[4][4096];
    static int next;
    char *path = kept[next++ % 4];
    snprintf(path, sizeof kept[0], "%s/%s", program_folder(), file);
    return path;
}

void program_note(const char *file, const char *format, ...) {
    FILE *f = fopen(in_folder(file), "a");
    if (!f) return;
    va_list arguments;
    va_start(arguments, format);
    vfprintf(f, format, arguments);
    va_end(arguments);
    fclose(f);
}

// To where HOMEWORK_PROGRESS, a file descriptor, leads: past the runner, which keeps the rest
// until the end.
static void progress(const char *format, ...) __attribute__((format(printf, 1, 2)));
static void progress(const char *format, ...) {
    const char *descriptor = runner_setting("HOMEWORK_PROGRESS");
    if (!descriptor) return;
    va_list arguments;
    va_start(arguments, format);
    vdprintf(atoi(descriptor), format, arguments);
    va_end(arguments);
}

// tests/tools/homework.sh leaves raytracer there, or empty, or errors.txt.
int program_state(text *why) {
    char line[300];
    if (access(in_folder("raytracer"), X_OK) == 0) return BUILT;
    if (access(in_folder("empty"), F_OK) == 0) return EMPTY;
    FILE *f = fopen(in_folder("errors.txt"), "r");
    if (f && fgets(line, sizeof line, f)) text_add(why, "%.*s", (int)strcspn(line, "\n"), line);
    if (f) fclose(f);
    return NOT_BUILT;
}

static _Noreturn void become(const char *name, const char *file, const char *seed) {
    const struct rlimit size = {LARGEST_FILE, LARGEST_FILE};
    setrlimit(RLIMIT_FSIZE, &size);
    const char *descriptor = runner_setting("HOMEWORK_PROGRESS");
    if (descriptor) close(atoi(descriptor));
    if (chdir(program_folder()) == 0)
        execl("./raytracer", "./raytracer", name, file, seed, NULL);
    _exit(127);
}

static int run(const char *name, const char *file, const char *seed) {
    fflush(NULL);
    const pid_t child = fork();
    if (child < 0) runner_die("start a process");
    if (child == 0) become(name, file, seed);
    int status = 0;
    if (waitpid(child, &status, 0) < 0) runner_die("wait for a process");
    return status;
}

static const char *end_of(int signal_number) {
    if (signal_number == SIGSEGV || signal_number == SIGBUS)
        return "crashed: bad pointer, index out of range or endless recursion?";
    if (signal_number == SIGFPE) return "crashed: integer division by zero?";
    if (signal_number == SIGABRT) return "crashed: abort() or assert()";
    if (signal_number == SIGXFSZ) return "wrote more than 16 MB";
    return "crashed";
}

static void judge_end(const char *name, int status) {
    const int signal_number = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    if (signal_number == SIGXCPU || signal_number == SIGKILL)
        fail(NULL,
             "raytracer %s: %s? stopped after %d s of processor time (TEST_SECONDS=600 allows "
             "more)",
             name,
             strcmp(name, "path") == 0 ? "too many samples, or an endless loop"
                                       : "endless loop",
             child_cpu_limit(false));
    if (signal_number) fail(NULL, "raytracer %s: %s", name, end_of(signal_number));
    if (WEXITSTATUS(status) != 0)
        fail(NULL, "raytracer %s: ended with exit status %d", name, WEXITSTATUS(status));
}

bad_pixels program_bad_pixels(const picture *p, bool negative) {
    bad_pixels bad = {0};
    for (int i = WIDTH * HEIGHT - 1; i >= 0; i--) {
        const double *v = p->at[i / WIDTH][i % WIDTH];
        const bool finite = isfinite(v[0]) && isfinite(v[1]) && isfinite(v[2]);
        if (finite && !(negative && (v[0] < 0 || v[1] < 0 || v[2] < 0))) continue;
        bad.count++, bad.first = i;
    }
    return bad;
}

const char *fixed_number(double x) {
    if (!(fabs(x) < 1e6)) return "more than a million";
    return text_kept(fabs(x) >= 9.95 ? "%.0f" : fabs(x) >= 0.995 ? "%.1f" : "%.2f", x);
}

const picture *program_draw(const char *name, const char *seed) {
    const char *file_name = text_kept("%s-%s.pfm", name, seed), *file = in_folder(file_name);
    remove(file);
    progress("%s: drawing, up to %d s of processor time\n", name, child_cpu_limit(false));
    const int status = run(name, file_name, seed);
    if (WIFEXITED(status) && WEXITSTATUS(status) == 2 && access(file, F_OK) != 0) {
        program_note("todo.txt", "%s\n", name);
        todo_note(text_kept("the picture %s", name), "exit status 2", 0);
        return NULL;
    }
    judge_end(name, status);
    static float values[HEIGHT * WIDTH * CHANNELS];
    const char *reason = pfm_read(file, WIDTH, HEIGHT, values);
    if (reason) fail(NULL, "%s: %s", name, reason);
    static picture kept[2]; // the path tracer's two
    static int next;
    picture *p = &kept[next++ % 2];
    for (int i = 0; i < HEIGHT * WIDTH * CHANNELS; i++) (&p->at[0][0][0])[i] = values[i];
    return p;
}
