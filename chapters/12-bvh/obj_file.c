// obj_file.c: see obj_inside.h.
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "chapters/12-bvh/obj_inside.h"

typedef struct {
    char *bytes;
    size_t length, room;
} content;

static bool grow(content *c) {
    enum { FIRST = 1 << 16 };
    const size_t room = c->room == 0 ? FIRST : 2 * c->room;
    char *bytes = room > c->room ? realloc(c->bytes, room) : NULL; // 2 room may overflow
    if (!bytes) return false;
    c->bytes = bytes;
    c->room = room;
    return true;
}

// 0, or errno. The end of a pipe is known only when it comes.
static int read_all(FILE *file, content *c) {
    for (;;) {
        if (c->length == c->room && !grow(c)) return ENOMEM;
        errno = 0;
        const size_t got = fread(c->bytes + c->length, 1, c->room - c->length, file);
        c->length += got;
        if (ferror(file)) return errno ? errno : EIO;
        if (got == 0) return 0;
    }
}

static int read_path(const char *path, content *c) {
    FILE *file = fopen(path, "rb");
    if (!file) return errno;
    const int problem = read_all(file, c);
    fclose(file);
    return problem;
}

bool obj_read(const char *path, mesh *m, obj_report *report, char error[OBJ_ERROR]) {
    content c = {0};
    const int problem = read_path(path, &c);
    bool done = false;
    if (problem) {
        *m = (mesh){0};
        *report = (obj_report){0};
        const int used = obj_begin_error(error, path, 0);
        snprintf(error + used, (size_t)(OBJ_ERROR - used), "%s", strerror(problem));
    } else {
        done = obj_parse(c.bytes, c.length, path, m, report, error);
    }
    free(c.bytes);
    return done;
}
