// plane.c: see plane.h. The derivations are in README.md.
#include "chapters/03-plane/plane.h"

hit hit_at(ray r, real t, vec3 n) {
    const vec3 step = scale(t, r.d);
    return (hit){.t = t,
                 .p = add(r.O, step),
                 .error = scale(rounding_bound(4), add(absolute(r.O), absolute(step))),
                 .n = n,
                 .front = dot(r.d, n) < 0};
}

// In double, since the square of a short or long n leaves float's range.
static vec3 unit_normal(vec3 n) {
    return dot(n, n) == 1 ? n : narrow(wide_unit(widen(n)));
}

// plane_hit's two dot products in double: nothing beside float's roundings (unless x is 1e8 times
// farther off than the hit), all that counts where real is double.
hit plane_surface(plane P, ray r, real t) {
    hit h = hit_at(r, t, unit_normal(P.n));
    const vec3 summed = add(absolute(sub(P.x, r.O)), absolute(scale(t, r.d)));
    h.error = add(h.error, scale((real)(4 * DBL_EPSILON), summed));
    return h;
}

// ---- many rays -------------------------------------------------------------------

// a·b as if summed with twice the digits, then rounded: Dot2. What each product and each sum
// loses is caught and added at the end.
// Source: Ogita, Rump and Oishi 2005, Accurate sum and dot product, algorithm 5.3.
static double dot_twice(wide3 a, wide3 b) {
    const double p[3] = {a.x * b.x, a.y * b.y, a.z * b.z};
    double lost = fma(a.x, b.x, -p[0]) + fma(a.y, b.y, -p[1]) + fma(a.z, b.z, -p[2]);
    double sum = p[0];
    for (int i = 1; i < 3; i++) {
        const double next = sum + p[i], added = next - sum;
        lost += (sum - (next - added)) + (p[i] - added);
        sum = next;
    }
    return sum + lost;
}

plane_equations plane_equations_of(const plane *planes, int count) {
    plane_equations E = {.x = {0}};
    for (int i = 0; i < count && i < EQUATIONS; i++) {
        const wide3 n = widen(planes[i].n);
        E.x[i] = n.x, E.y[i] = n.y, E.z[i] = n.z;
        E.D[i] = dot_twice(n, widen(planes[i].x));
        E.unit[i] = unit_normal(planes[i].n);
    }
    return E;
}

// 0 = 0 gives 0/0, which is not a number and lies in no interval.
void equations_hit(const plane_equations *E, ray r, real t_min, real t[EQUATIONS]) {
    const wide3 O = widen(r.O), d = widen(r.d);
#pragma omp simd
    for (int i = 0; i < EQUATIONS; i++) {
        const double above = E->D[i] - (E->x[i] * O.x + E->y[i] * O.y + E->z[i] * O.z);
        const double along = E->x[i] * d.x + E->y[i] * d.y + E->z[i] * d.z;
        const real at = (real)(above / along);
        t[i] = at > t_min ? at : NO_HIT;
    }
}

hit equations_surface(const plane_equations *E, int i, ray r, real t) {
    hit h = hit_at(r, t, E->unit[i]);
    // Besides hit_at's, in units of DBL_EPSILON / 2, times |n_i|(|O_i| + |t d_i|), summed: D 1,
    // n·O and the difference 4, n·d and the quotient 4, and, as the next ray must find itself on
    // the side that it starts on, D - n·O once more 5: 14 of these 16. In float the factor is
    // rounded to 1, and hit_at's fourth rounding has room for them.
    h.error = scale((real)(1 + 8 * DBL_EPSILON / rounding_bound(4)), h.error);
    return h;
}

// ---- a checkered floor -----------------------------------------------------------

// Is floor(x) odd? Stays right where the whole number no longer fits an int.
static int odd(real x) {
    const real whole = floor(x);
    return whole - 2 * floor(whole / 2) != 0;
}

int checks(real x, real z) {
    return odd(x) ^ odd(z);
}
