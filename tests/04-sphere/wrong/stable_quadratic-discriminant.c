// Wrong: the discriminant by two rounded products.
// Expect: nearly double roots
// Expect: h² - ac from two rounded products
// Expect: fma(x, y, z) rounds only once
#include "chapters/04-sphere/sphere.h"

roots stable_quadratic(double a, double b, double c) {
    if (a == 0) return solve_quadratic(a, b, c);
    const double half_b = b / 2, quarter = half_b * half_b - a * c;
    if (!(quarter >= 0)) return (roots){0, 0, 0};
    const double q = -(half_b + copysign(sqrt(quarter), half_b));
    const double t0 = q / a, t1 = q == 0 ? t0 : c / q;
    return (roots){2, fmin(t0, t1), fmax(t0, t1)};
}
