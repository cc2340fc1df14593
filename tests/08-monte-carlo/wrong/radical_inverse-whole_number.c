// Wrong: the mirrored digits as a whole number of 64 bits.
// Expect: the mirrored digits as a whole number overflow 64 bits
#include "chapters/08-monte-carlo/monte_carlo.h"

double radical_inverse(int base, uint64_t i) {
    const uint64_t b = (uint64_t)base;
    uint64_t mirrored = 0;
    double power = 1;
    for (; i > 0; i /= b) {
        mirrored = mirrored * b + i % b;
        power *= base;
    }
    return fmin((double)mirrored / power, 1 - DBL_EPSILON / 2);
}
