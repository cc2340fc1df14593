// Wrong: the digits behind the point, but not mirrored.
// Expect: the digits behind the point, but not mirrored
#include "chapters/08-monte-carlo/monte_carlo.h"

double radical_inverse(int base, uint64_t i) {
    double x = (double)i;
    while (x >= 1) x /= base;
    return x;
}
