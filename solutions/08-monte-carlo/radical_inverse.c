#include "chapters/08-monte-carlo/monte_carlo.h"

// The last digit of i comes first. What the others give together is mirrored in the same
// way, and moves one place down. Many ones in a row would round to 1.
double radical_inverse(int base, uint64_t i) {
    if (i == 0) return 0;
    const uint64_t b = (uint64_t)base;
    const double others = radical_inverse(base, i / b);
    return fmin(((double)(i % b) + others) / base, 1 - DBL_EPSILON / 2);
}
