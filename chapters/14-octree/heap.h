// heap.h: an array that grows.
#ifndef CHAPTER_HEAP_H
#define CHAPTER_HEAP_H

#include <stdlib.h>

#include "common/die.h"

typedef struct {
    void *at;
    size_t size; // of an item
    long count, room;
} heap;

// Room for `more` items behind the last one, which must be filled at once: items move. Dies when
// there is no memory. free(h->at) at the end.
static inline void *heap_more(heap *h, long more) {
    if (h->count + more > h->room) {
        h->room = 2 * h->room + more + 64;
        h->at = realloc(h->at, (size_t)h->room * h->size);
        if (!h->at) die(EXIT_RUN, "no memory for an array of %ld items", h->room);
    }
    h->count += more;
    return (char *)h->at + (size_t)(h->count - more) * h->size;
}

#endif
