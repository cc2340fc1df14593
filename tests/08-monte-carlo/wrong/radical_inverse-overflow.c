// Wrong: mirrored as a whole number; base^k overflows.
// Expect: base^k as a whole number overflows
#include "chapters/08-monte-carlo/monte_carlo.h"

double radical_inverse(int base, uint64_t i) {
    const uint64_t b = (uint64_t)base;
    uint64_t mirrored = 0, power = 1;
    for (; i > 0; i /= b) {
        mirrored = mirrored * b + i % b;
        power *= b;
    }
    return fmin((double)mirrored / (double)power, 1 - DBL_EPSILON / 2);
}
