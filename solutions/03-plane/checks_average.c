#include "chapters/03-plane/plane.h"

// The integral from 0 to x of the square wave that is +1 on [0, 1) and -1 on
// [1, 2): a triangle wave of height 1.
static double wave_integral(double x) {
    const double in_period = x - 2 * floor(x / 2);
    return in_period < 1 ? in_period : 2 - in_period;
}

// The mean of the wave over [x - w/2, x + w/2].
static double wave_mean(double x, double w) {
    return (wave_integral(x + w / 2) - wave_integral(x - w / 2)) / w;
}

// checks = (1 - wave(x) wave(z)) / 2, and the mean of a product of functions of
// different variables is the product of their means.
real checks_average(real x, real z, real w) {
    return (real)((1 - wave_mean(x, w) * wave_mean(z, w)) / 2);
}
