// Wrong: many ones in a row are rounded to 1.
// Expect: What is 1 - 2^-60 in double?
#include "chapters/08-monte-carlo/monte_carlo.h"

double radical_inverse(int base, uint64_t i) {
    double sum = 0, place = 1;
    for (; i > 0; i /= (uint64_t)base) {
        place /= base;
        sum += place * (double)(i % (uint64_t)base);
    }
    return sum;
}
