// Wrong: sign(0) = 0, so that q = 0 when b = 0.
// Expect: is your sign(0) 0?
// Expect: zeros and NaN
#include "chapters/04-sphere/sphere.h"

roots stable_quadratic(double a, double b, double c) {
    if (a == 0) return solve_quadratic(a, b, c);
    const double half_b = b / 2, p = a * c;
    const double quarter = fma(half_b, half_b, -p) + fma(-a, c, p);
    if (!(quarter >= 0)) return (roots){0, 0, 0};
    const double q = -(half_b + ((half_b > 0) - (half_b < 0)) * sqrt(quarter));
    const double t0 = q / a, t1 = q == 0 ? t0 : c / q;
    return (roots){2, fmin(t0, t1), fmax(t0, t1)};
}
