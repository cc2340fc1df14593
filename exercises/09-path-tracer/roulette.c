// roulette: an end without loss. The task is in README.md.
#include "chapters/09-path-tracer/path.h"
#include "common/todo.h"

real roulette(real q, rng *g) {
    TODO("roulette"); // your answer instead of these two lines
    return 0;
}
