// Right: all digits first, then from the last one up.
#include "chapters/08-monte-carlo/monte_carlo.h"

double radical_inverse(int base, uint64_t i) {
    int digit[64], count = 0;
    for (; i > 0; i /= (uint64_t)base) digit[count++] = (int)(i % (uint64_t)base);
    double x = 0;
    while (count > 0) x = (x + digit[--count]) / base;
    return x < 1 ? x : nextafter(1.0, 0.0);
}
