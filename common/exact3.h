// exact3.h: a vec3 in the precision of the reference, and generic data: what tests
// and measuring need to judge a formula.
#ifndef COMMON_EXACT3_H
#define COMMON_EXACT3_H

#include "common/measure.h"
#include "common/rng.h"

typedef struct {
    exact x, y, z;
} exact3;

static inline exact3 exact_of(vec3 a) {
    return (exact3){a.x, a.y, a.z};
}

// a - b, without rounding for all but the strangest pairs.
static inline exact3 exact_sub(vec3 a, vec3 b) {
    return (exact3){(exact)a.x - b.x, (exact)a.y - b.y, (exact)a.z - b.z};
}

// a + s b
static inline exact3 exact_along(exact3 a, exact s, exact3 b) {
    return (exact3){a.x + s * b.x, a.y + s * b.y, a.z + s * b.z};
}

static inline exact exact_dot(exact3 a, exact3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline exact3 exact_cross(exact3 a, exact3 b) {
    return (exact3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// Uniform in [-1, 1)³.
static inline vec3 in_cube(rng *g) {
    const real x = 2 * rng_real(g) - 1, y = 2 * rng_real(g) - 1, z = 2 * rng_real(g) - 1;
    return (vec3){x, y, z};
}

#endif
