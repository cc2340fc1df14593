// Right: the mirrored number as a whole one, divided at the end.
#include "chapters/08-monte-carlo/monte_carlo.h"

double radical_inverse(int base, uint64_t i) {
    double mirrored = 0, size = 1;
    for (; i > 0; i /= (uint64_t)base) {
        mirrored = mirrored * base + (double)(i % (uint64_t)base);
        size *= base;
    }
    return fmin(mirrored / size, 1 - DBL_EPSILON / 2);
}
