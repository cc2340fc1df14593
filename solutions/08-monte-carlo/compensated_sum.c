#include "chapters/08-monte-carlo/monte_carlo.h"

typedef struct {
    float sum, lost;
} pair;

// sum + lost is a + b exactly: larger - sum needs no rounding, and shows what was lost.
// Source: Dekker 1971.
static pair two_sum(float a, float b) {
    const float sum = a + b;
    const bool a_is_larger = fabsf(a) >= fabsf(b);
    return (pair){sum, a_is_larger ? (a - sum) + b : (b - sum) + a};
}

// The second two_sum moves into the sum what has grown large enough in lost, so that lost
// stays small and is itself rounded by little.
float compensated_sum(const float *x, long n) {
    pair s = {0, 0};
    for (long i = 0; i < n; i++) {
        const pair next = two_sum(s.sum, x[i]);
        s = two_sum(next.sum, next.lost + s.lost);
    }
    return s.sum;
}
