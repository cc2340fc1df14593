// Wrong: what was lost is subtracted.
// Expect: what was lost is subtracted: its sign
#include "chapters/08-monte-carlo/monte_carlo.h"

float compensated_sum(const float *x, long n) {
    float sum = 0, lost = 0;
    for (long i = 0; i < n; i++) {
        const float next = sum + x[i];
        lost += fabsf(sum) >= fabsf(x[i]) ? (sum - next) + x[i] : (x[i] - next) + sum;
        sum = next;
    }
    return sum - lost;
}
