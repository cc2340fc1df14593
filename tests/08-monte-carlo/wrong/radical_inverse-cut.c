// Wrong: cut off at 0.999999.
// Expect: cut off too early
#include "chapters/08-monte-carlo/monte_carlo.h"

double radical_inverse(int base, uint64_t i) {
    double sum = 0, place = 1;
    for (; i > 0; i /= (uint64_t)base) {
        place /= base;
        sum += place * (double)(i % (uint64_t)base);
    }
    return fmin(sum, 0.999999);
}
