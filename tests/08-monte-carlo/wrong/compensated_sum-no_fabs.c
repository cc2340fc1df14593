// Wrong: Neumaier's, but it compares sum and x, not their sizes.
// Expect: compare their sizes, |sum| with |x|
#include "chapters/08-monte-carlo/monte_carlo.h"

float compensated_sum(const float *x, long n) {
    float s = 0, lost = 0;
    for (long i = 0; i < n; i++) {
        const float t = s + x[i];
        lost += s >= x[i] ? (s - t) + x[i] : (x[i] - t) + s;
        s = t;
    }
    return s + lost;
}
