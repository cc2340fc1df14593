// quadrature.c: integrals as weighted sums, in one dimension and in several.
#include <stdlib.h>

#include "chapters/07-rendering-equation/rendering.h"
#include "common/die.h"

static void midpoint_rule(int n, double *x, double *weight) {
    for (int i = 0; i < n; i++) {
        x[i] = (i + 0.5) / n;
        weight[i] = 1.0 / n;
    }
}

// 1 4 1, shoulder to shoulder: 1 4 2 4 2 ... 4 1.
static void simpson_rule(int n, double *x, double *weight) {
    const double h = 1.0 / (n - 1);
    for (int i = 0; i < n; i++) {
        const bool end = i == 0 || i == n - 1;
        x[i] = i * h;
        weight[i] = (end ? 1 : i % 2 ? 4 : 2) * h / 3;
    }
}

// Legendre's polynomial P_n and its derivative at x in (-1, 1), by the recurrence
// k P_k = (2k - 1) x P_(k-1) - (k - 1) P_(k-2).
static double legendre(int n, double x, double *derivative) {
    double p = 1, before = 0;
    for (int k = 1; k <= n; k++) {
        const double next = ((2 * k - 1) * x * p - (k - 1) * before) / k;
        before = p;
        p = next;
    }
    *derivative = n * (before - x * p) / ((1 - x) * (1 + x));
    return p;
}

// The points are the roots of P_n, by Newton's method from a cosine that lies near.
static void gauss_rule(int n, double *x, double *weight) {
    for (int i = 0; i < n; i++) {
        double z = -cos(PI * (i + 0.75) / (n + 0.5)), slope = 1;
        for (int step = 0; step < 8; step++) {
            const double p = legendre(n, z, &slope);
            z -= p / slope;
        }
        legendre(n, z, &slope);
        x[i] = (1 + z) / 2; // from [-1, 1] to [0, 1]
        weight[i] = 1 / ((1 - z) * (1 + z) * slope * slope);
    }
}

void quadrature_rule(quadrature rule, int n, double *x, double *weight) {
    if (rule == MIDPOINT) midpoint_rule(n, x, weight);
    if (rule == SIMPSON) simpson_rule(n, x, weight);
    if (rule == GAUSS) gauss_rule(n, x, weight);
}

// The next point of the grid, as a milometer counts; false behind the last one.
static bool next_index(int *index, int n, int dimensions) {
    for (int k = 0; k < dimensions; k++) {
        if (++index[k] < n) return true;
        index[k] = 0;
    }
    return false;
}

double integrate_cube(quadrature rule, int n, int dimensions, integrand f, const void *data) {
    double *x = malloc(2 * (size_t)n * sizeof *x), *weight = x + n;
    if (!x) die(EXIT_RUN, "no memory for %d points", n);
    quadrature_rule(rule, n, x, weight);
    int index[MOST_DIMENSIONS] = {0};
    double sum = 0;
    do {
        double point[MOST_DIMENSIONS] = {0}, w = 1;
        for (int k = 0; k < dimensions; k++) {
            point[k] = x[index[k]];
            w *= weight[index[k]];
        }
        sum += w * f(data, point);
    } while (next_index(index, n, dimensions));
    free(x);
    return sum;
}
