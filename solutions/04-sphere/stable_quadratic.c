#include "chapters/04-sphere/sphere.h"

// a b - c d within 1.5 roundings, so its sign is right (Kahan; Jeannerod, Louvet
// and Muller 2013): fma gives the rounding error of the product c d exactly.
static double difference_of_products(double a, double b, double c, double d) {
    const double cd = c * d;
    const double error = fma(-c, d, cd);
    return fma(a, b, -cd) + error;
}

roots stable_quadratic(double a, double b, double c) {
    if (a == 0) {
        if (b == 0) return (roots){0, 0, 0};
        return (roots){1, -c / b, -c / b};
    }
    const double half_b = b / 2;
    const double quarter = difference_of_products(half_b, half_b, a, c); // (b² - 4ac) / 4
    if (!(quarter >= 0)) return (roots){0, 0, 0};
    const double q =
        -(half_b + copysign(sqrt(quarter), half_b));   // equal signs: no cancellation
    const double t0 = q / a, t1 = q == 0 ? t0 : c / q; // t0 t1 = c / a
    return (roots){2, fmin(t0, t1), fmax(t0, t1)};
}
