// Wrong: 1 / base in whole numbers.
// Expect: is 1 / base divided in whole numbers, 0?
#include "chapters/08-monte-carlo/monte_carlo.h"

double radical_inverse(int base, uint64_t i) {
    double sum = 0, place = 1;
    for (; i > 0; i /= (uint64_t)base) {
        place *= 1 / base;
        sum += place * (double)(i % (uint64_t)base);
    }
    return fmin(sum, 1 - DBL_EPSILON / 2);
}
