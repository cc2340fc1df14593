// Wrong: i in an int.
// Expect: i went through an int or unsigned: 32 bits are left of it
#include "chapters/08-monte-carlo/monte_carlo.h"

double radical_inverse(int base, uint64_t i) {
    double sum = 0, place = 1;
    for (unsigned rest = (unsigned)i; rest > 0; rest /= (unsigned)base) {
        place /= base;
        sum += place * (rest % (unsigned)base);
    }
    return fmin(sum, 1 - DBL_EPSILON / 2);
}
