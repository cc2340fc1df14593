#include "chapters/04-sphere/sphere.h"

// a b - c d with one rounding's error (Kahan; Jeannerod, Louvet and Muller 2013).
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
    const double half = b / 2;
    const double quarter = difference_of_products(half, half, a, c); // (b² - 4ac) / 4
    if (!(quarter >= 0)) return (roots){0, 0, 0};
    const double q = -(half + copysign(sqrt(quarter), half));
    const double t0 = q / a, t1 = q == 0 ? t0 : c / q;
    return (roots){2, fmin(t0, t1), fmax(t0, t1)};
}
