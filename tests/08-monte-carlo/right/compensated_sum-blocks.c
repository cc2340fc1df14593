// Right: Neumaier's over blocks, whose results are summed in the same way.
#include "chapters/08-monte-carlo/monte_carlo.h"

enum { BLOCK = 64 };

static void add_to(float *sum, float *lost, float x) {
    const float next = *sum + x;
    *lost += fabsf(*sum) >= fabsf(x) ? (*sum - next) + x : (x - next) + *sum;
    *sum = next + *lost;
    *lost = fabsf(next) >= fabsf(*lost) ? (next - *sum) + *lost : (*lost - *sum) + next;
}

float compensated_sum(const float *x, long n) {
    float total = 0, rest = 0;
    for (long i = 0; i < n; i += BLOCK) {
        float sum = 0, lost = 0;
        for (long k = i; k < i + BLOCK && k < n; k++) add_to(&sum, &lost, x[k]);
        add_to(&total, &rest, sum);
        add_to(&total, &rest, lost);
    }
    return total + rest;
}
