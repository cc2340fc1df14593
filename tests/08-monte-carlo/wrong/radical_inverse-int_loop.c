// Wrong: i in an int, which may be negative: no digits then.
// Expect: the upper bits of i were lost: is it an int?
#include "chapters/08-monte-carlo/monte_carlo.h"

double radical_inverse(int base, uint64_t i) {
    double sum = 0, place = 1;
    for (int rest = (int)i; rest > 0; rest /= base) {
        place /= base;
        sum += place * (rest % base);
    }
    return fmin(sum, 1 - DBL_EPSILON / 2);
}
