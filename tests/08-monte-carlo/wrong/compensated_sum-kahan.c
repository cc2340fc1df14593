// Wrong: Kahan's, which takes the sum for the larger one.
// Expect: and was lost with it (Kahan's)
#include "chapters/08-monte-carlo/monte_carlo.h"

float compensated_sum(const float *x, long n) {
    float sum = 0, lost = 0;
    for (long i = 0; i < n; i++) {
        const float term = x[i] + lost, next = sum + term;
        lost = term - (next - sum);
        sum = next;
    }
    return sum;
}
