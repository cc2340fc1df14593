// Wrong: the running mean, times n.
// Expect: some of what float additions lose is not kept
#include "chapters/08-monte-carlo/monte_carlo.h"

float compensated_sum(const float *x, long n) {
    float mean = 0;
    for (long i = 0; i < n; i++) mean += (x[i] - mean) / (float)(i + 1);
    return mean * (float)n;
}
