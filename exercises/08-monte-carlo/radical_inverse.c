// radical_inverse: the digits of i, mirrored. The task is in README.md.
#include "chapters/08-monte-carlo/monte_carlo.h"
#include "common/todo.h"

double radical_inverse(int base, uint64_t i) {
    TODO("radical_inverse"); // your answer instead of these two lines
    return 0;
}
