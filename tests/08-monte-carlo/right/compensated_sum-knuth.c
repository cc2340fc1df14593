// Right: without a comparison (Knuth's sum of two), six operations.
#include "chapters/08-monte-carlo/monte_carlo.h"

float compensated_sum(const float *x, long n) {
    float sum = 0, lost = 0;
    for (long i = 0; i < n; i++) {
        const float next = sum + x[i], part = next - sum;
        lost += (sum - (next - part)) + (x[i] - part);
        sum = next + lost;
        lost -= sum - next;
    }
    return sum + lost;
}
