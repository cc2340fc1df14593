// Wrong: what was lost goes to the next term, and is lost with it.
// Expect: what was lost went to the next term, and was lost with it
#include "chapters/08-monte-carlo/monte_carlo.h"

float compensated_sum(const float *x, long n) {
    float sum = 0, lost = 0;
    for (long i = 0; i < n; i++) {
        const float term = x[i] + lost, next = sum + term;
        lost = fabsf(sum) >= fabsf(term) ? (sum - next) + term : (term - next) + sum;
        sum = next;
    }
    return sum + lost;
}
