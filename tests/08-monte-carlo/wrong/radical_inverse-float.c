// Wrong: in float.
// Expect: float inside
#include "chapters/08-monte-carlo/monte_carlo.h"

double radical_inverse(int base, uint64_t i) {
    float sum = 0, place = 1;
    for (; i > 0; i /= (uint64_t)base) {
        place /= (float)base;
        sum += place * (float)(i % (uint64_t)base);
    }
    return fmin((double)sum, 1 - DBL_EPSILON / 2);
}
