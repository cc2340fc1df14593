// homework.c: judges the homework "Läxa: skriv en raytracer" as a black box, in stages. Run it
// with make homework. tests/homework/homework.h tells how.
#include "tests/homework/homework.h"
#include "common/todo.h"

#include <string.h>

// Is there a program at all? If not, only the stage "build" says why.
static bool is_built(const char *stage_name) {
    static text why;
    const int state = program_state(&why);
    if (state == EMPTY) todo_note("your main.c", "", 0);
    if (state == NOT_BUILT && strcmp(stage_name, "build") == 0)
        fail(NULL, "does not compile: %s", why.chars);
    if (state == NOT_BUILT && runner_setting("T")) // the stage "build" is not shown
        fail(NULL, "not run: it does not compile: %s", why.chars);
    if (state == NOT_BUILT) fail(NULL, "not run: it does not compile");
    return state == BUILT;
}

static void build(void) {
    is_built("build");
}

static void depth(void) {
    if (is_built("depth")) judge_exact(DEPTH, "depth");
}

static void normal(void) {
    if (is_built("normal")) judge_exact(NORMAL, "normal");
}

static void mirror(void) {
    if (is_built("mirror")) judge_exact(MIRROR, "mirror");
}

static void path(void) {
    if (is_built("path")) judge_path();
}

int main(void) {
    static const test stages[] = {
        {"build: it compiles", build, NULL},        {"depth: scene 1, distances", depth, NULL},
        {"normal: scene 1, normals", normal, NULL}, {"mirror: scene 2", mirror, NULL},
        {"path: scene 3, light", path, NULL},
    };
    return run_tests("homework", stages, COUNT(stages));
}
