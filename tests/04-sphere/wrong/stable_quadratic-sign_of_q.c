// Wrong: q with the wrong sign.
// Expect: q with the wrong sign: minus the other root
#include "chapters/04-sphere/sphere.h"

roots stable_quadratic(double a, double b, double c) {
    if (a == 0) return solve_quadratic(a, b, c);
    const double half_b = b / 2, p = a * c;
    const double quarter = fma(half_b, half_b, -p) + fma(-a, c, p);
    if (!(quarter >= 0)) return (roots){0, 0, 0};
    const double q = half_b + copysign(sqrt(quarter), half_b);
    const double t0 = q / a, t1 = q == 0 ? t0 : c / q;
    return (roots){2, fmin(t0, t1), fmax(t0, t1)};
}
