// Wrong: the first digit before the point.
// Expect: a whole number: the first digit belongs behind the point
#include "chapters/08-monte-carlo/monte_carlo.h"

double radical_inverse(int base, uint64_t i) {
    double sum = 0, place = 1;
    for (; i > 0; i /= (uint64_t)base) {
        sum += place * (double)(i % (uint64_t)base);
        place /= base;
    }
    return sum;
}
