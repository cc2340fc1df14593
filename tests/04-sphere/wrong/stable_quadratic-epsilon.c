// Wrong: a threshold for "a is zero" throws quadratics away.
// Expect: sizes from 1e-145 to 1e150
// Expect: No threshold is needed.
#include "chapters/04-sphere/sphere.h"

roots stable_quadratic(double a, double b, double c) {
    if (fabs(a) < 1e-40) return solve_quadratic(0, b, c);
    const double half_b = b / 2, p = a * c;
    const double quarter = fma(half_b, half_b, -p) + fma(-a, c, p);
    if (!(quarter >= 0)) return (roots){0, 0, 0};
    const double q = -(half_b + copysign(sqrt(quarter), half_b));
    const double t0 = q / a, t1 = q == 0 ? t0 : c / q;
    return (roots){2, fmin(t0, t1), fmax(t0, t1)};
}
