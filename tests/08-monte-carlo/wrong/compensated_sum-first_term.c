// Wrong: begins with x[0], also of no terms.
// Expect: x[0] was read, though n = 0
#include "chapters/08-monte-carlo/monte_carlo.h"

float compensated_sum(const float *x, long n) {
    float s = x[0], lost = 0;
    for (long i = 1; i < n; i++) {
        const float t = s + x[i];
        lost += fabsf(s) >= fabsf(x[i]) ? (s - t) + x[i] : (x[i] - t) + s;
        s = t;
    }
    return s + lost;
}
