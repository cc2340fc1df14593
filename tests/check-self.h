// check-self.h: runs the fixtures program and reads what it prints.
//
// FIXTURES names that program; else it is build/check-fixtures.
#ifndef TESTS_CHECK_SELF_H
#define TESTS_CHECK_SELF_H

#include "tests/check-rows.h"
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
             "T= TAP= JUNIT= TALLY= QUIET= SOLUTIONS= FULL= TEST_SECONDS=1; "
             "export T TAP JUNIT TALLY QUIET SOLUTIONS FULL TEST_SECONDS; %s 2>&1",
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

typedef struct {
    const char *filter, *words; // SILENT: it is not said what the answer looks like
} row;

static void check_rows(const row *rows, int count, int status) {
    for (int i = 0; i < count; i++) {
        const outcome *o = run("", rows[i].filter);
        CHECK_INT(o->status, status);
        if (rows[i].words)
            must_say(o, rows[i].words);
        else
            must_not_say(o, "looks like");
    }
}

#endif
