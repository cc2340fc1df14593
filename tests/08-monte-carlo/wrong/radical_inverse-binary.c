// Wrong: always base 2.
// Expect: The last digit of i is i % base
#include "chapters/08-monte-carlo/monte_carlo.h"

double radical_inverse(int base, uint64_t i) {
    (void)base;
    double sum = 0, place = 1;
    for (; i > 0; i /= 2) {
        place /= 2;
        sum += place * (double)(i % 2);
    }
    return fmin(sum, 1 - DBL_EPSILON / 2);
}
