// Right: adds up the overlaps with the squares of either parity, one by one.
#include "chapters/03-plane/plane.h"

// The share of [x - w/2, x + w/2] that lies in odd squares.
static double odd_share(double x, double w) {
    const double lo = x - w / 2, hi = x + w / 2;
    double sum = 0;
    for (double k = floor(lo); k < hi; k += 1)
        if (fmod(fabs(k), 2) == 1) sum += fmin(hi, k + 1) - fmax(lo, k);
    return sum / w;
}

real checks_average(real x, real z, real w) {
    const double p = odd_share(x, w), q = odd_share(z, w);
    return (real)(p * (1 - q) + (1 - p) * q);
}
