// check-generic.h: data for tests in which no axis, unit or zero hides a slip.
#ifndef TESTS_CHECK_GENERIC_H
#define TESTS_CHECK_GENERIC_H

#include "common/exact3.h"
#include "common/wide3.h"

// A unit vector in any direction; not uniform.
static inline vec3 generic_unit(rng *g) {
    vec3 v;
    do v = in_cube(g);
    while (dot(v, v) < (real)0.01);
    return normalize(v);
}

// Unit, perpendicular to the unit vector n.
static inline vec3 perpendicular(vec3 n) {
    const vec3 other = fabs(n.x) < (real)0.6 ? (vec3){1, 0, 0} : (vec3){0, 1, 0};
    return normalize(cross(n, other));
}

// Uniform in [low, high).
static inline double between(rng *g, double low, double high) {
    return low + (high - low) * rng_double(g);
}

static inline double wide_length(vec3 v) {
    return sqrt(wide_dot(widen(v), widen(v)));
}

#endif
