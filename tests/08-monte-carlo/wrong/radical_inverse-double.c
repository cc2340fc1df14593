// Wrong: the digits by fmod and floor, from i in double.
// Expect: i went through a double: its last digits, the first of the answer, were rounded
#include "chapters/08-monte-carlo/monte_carlo.h"

double radical_inverse(int base, uint64_t i) {
    double sum = 0, place = 1;
    for (double rest = (double)i; rest > 0; rest = floor(rest / base)) {
        place /= base;
        sum += place * fmod(rest, base);
    }
    return fmin(sum, 1 - DBL_EPSILON / 2);
}
