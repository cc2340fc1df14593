// Wrong: the two colours are swapped.
// Expect: looks like 1 minus the answer: which square is 1?
#include "chapters/03-plane/plane.h"

static double wave_integral(double x) {
    const double in_period = x - 2 * floor(x / 2);
    return in_period < 1 ? in_period : 2 - in_period;
}

static double wave_mean(double x, double w) {
    return (wave_integral(x + w / 2) - wave_integral(x - w / 2)) / w;
}

real checks_average(real x, real z, real w) {
    return (real)((1 + wave_mean(x, w) * wave_mean(z, w)) / 2);
}
