// Wrong: Kahan's with the sign of the correction turned.
// Expect: the correction's sign: Kahan's c is subtracted
#include "chapters/08-monte-carlo/monte_carlo.h"

float compensated_sum(const float *x, long n) {
    float s = 0, c = 0;
    for (long i = 0; i < n; i++) {
        const float y = x[i] + c, t = s + y;
        c = (t - s) - y;
        s = t;
    }
    return s;
}
