// Right: scaled by a power of two first, so that no product overflows or vanishes; and
// the rounding errors of both products added to their difference.
#include "chapters/04-sphere/sphere.h"

roots stable_quadratic(double a, double b, double c) {
    if (a == 0 && b == 0) return (roots){0, 0, 0};
    if (a == 0) return (roots){1, -c / b, -c / b};
    const double h = b / 2, size = fmax(fabs(h), sqrt(fabs(a)) * sqrt(fabs(c)));
    if (!(size > 0)) return size == 0 ? (roots){2, 0, 0} : (roots){0, 0, 0};
    const double s = ldexp(1.0, -ilogb(size));
    const double A = a * s, H = h * s, C = c * s;
    const double hh = H * H, ac = A * C;
    const double quarter = (hh - ac) + (fma(H, H, -hh) - fma(A, C, -ac));
    if (!(quarter >= 0)) return (roots){0, 0, 0};
    const double q = H > 0 ? -H - sqrt(quarter) : -H + sqrt(quarter);
    if (q == 0) return (roots){2, 0, 0};
    const double x = q / A, y = C / q;
    return x < y ? (roots){2, x, y} : (roots){2, y, x};
}
