// todo.c: remembers which stubs were reached, each place once.
// A stub may be called for every ray, from every thread. So a place that is
// known costs a look into the table without a lock: rows below `known` are
// complete and never change again. Only a new row takes the lock.
#include "common/todo.h"

#include <stdatomic.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

enum { MAX_PLACES = 64 }; // more than the stubs of the whole course in one program

typedef struct {
    const char *what, *file;
    int line;
} place;

static place places[MAX_PLACES];
static atomic_int known;
static atomic_flag adding = ATOMIC_FLAG_INIT;

static bool is_known(const char *file, int line) {
    const int count = atomic_load_explicit(&known, memory_order_acquire);
    for (int i = 0; i < count; i++)
        if (places[i].line == line && strcmp(places[i].file, file) == 0) return true;
    return count == MAX_PLACES; // no room: better silent than a line for every ray
}

void todo_note(const char *what, const char *file, int line) {
    if (is_known(file, line)) return;
    while (atomic_flag_test_and_set(&adding)) {
    }
    if (!is_known(file, line)) { // another thread may have been faster
        const int count = atomic_load(&known);
        places[count] = (place){what, file, line};
        atomic_store_explicit(&known, count + 1, memory_order_release);
        fprintf(stderr, "todo: %s is not written yet (%s:%d)\n", what, file, line);
    }
    atomic_flag_clear(&adding);
}

const char *todo_first(void) {
    return atomic_load_explicit(&known, memory_order_acquire) > 0 ? places[0].what : NULL;
}
