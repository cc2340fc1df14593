// Wrong: by halves: better than the plain sum, but nothing is kept.
// Expect: Keep it in a second float
#include "chapters/08-monte-carlo/monte_carlo.h"

float compensated_sum(const float *x, long n) {
    if (n < 2) return n == 1 ? x[0] : 0;
    return compensated_sum(x, n / 2) + compensated_sum(x + n / 2, n - n / 2);
}
