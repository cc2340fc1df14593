// Wrong: base^k in an int.
// Expect: base^k overflows: it has no room in an int
#include "chapters/08-monte-carlo/monte_carlo.h"

double radical_inverse(int base, uint64_t i) {
    double sum = 0;
    uint32_t power = 1; // as an int, whose overflow is undefined, does on most machines
    for (; i > 0; i /= (uint64_t)base) {
        power *= (uint32_t)base;
        sum += (double)(i % (uint64_t)base) / (double)(int32_t)power;
    }
    return fmin(sum, 1 - DBL_EPSILON / 2);
}
