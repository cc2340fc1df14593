// Right: the places' values one by one.
#include "chapters/08-monte-carlo/monte_carlo.h"

double radical_inverse(int base, uint64_t i) {
    double sum = 0, place = 1;
    for (; i > 0; i /= (uint64_t)base) {
        place /= base;
        sum += place * (double)(i % (uint64_t)base);
    }
    return fmin(sum, 1 - DBL_EPSILON / 2);
}
