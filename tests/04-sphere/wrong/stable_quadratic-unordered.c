// Wrong: the roots in the order in which they were found.
// Expect: the two roots in the wrong order
#include "chapters/04-sphere/sphere.h"

static double quarter_of(double a, double h, double c) {
    const double p = a * c;
    return fma(h, h, -p) + fma(-a, c, p);
}

roots stable_quadratic(double a, double b, double c) {
    if (a == 0) return solve_quadratic(a, b, c);
    const double half_b = b / 2, quarter = quarter_of(a, half_b, c);
    if (!(quarter >= 0)) return (roots){0, 0, 0};
    const double q = -(half_b + copysign(sqrt(quarter), half_b));
    return (roots){2, q / a, q == 0 ? q / a : c / q};
}
