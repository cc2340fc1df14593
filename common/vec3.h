// vec3.h: vectors with three components, by value. Points, directions and
// colours are all vec3; the name of the variable says which.
#ifndef COMMON_VEC3_H
#define COMMON_VEC3_H

#include "common/real.h"

typedef struct {
    real x, y, z;
} vec3;

typedef vec3 color; // linear red, green, blue; 1 is the white of the picture

static inline vec3 add(vec3 a, vec3 b) {
    return (vec3){a.x + b.x, a.y + b.y, a.z + b.z};
}

static inline vec3 sub(vec3 a, vec3 b) {
    return (vec3){a.x - b.x, a.y - b.y, a.z - b.z};
}

// Component by component: a colour filtered by a colour.
static inline vec3 mul(vec3 a, vec3 b) {
    return (vec3){a.x * b.x, a.y * b.y, a.z * b.z};
}

static inline vec3 scale(real s, vec3 a) {
    return (vec3){s * a.x, s * a.y, s * a.z};
}

static inline vec3 neg(vec3 a) {
    return (vec3){-a.x, -a.y, -a.z};
}

static inline real dot(vec3 a, vec3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline vec3 cross(vec3 a, vec3 b) {
    return (vec3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static inline real length(vec3 a) {
    return sqrt(dot(a, a));
}

// a / |a|. The zero vector has no direction and gives NaN: ask before.
// |a|² must not overflow or vanish: 1e-18 < |a| < 1e19 in float.
static inline vec3 normalize(vec3 a) {
    return scale(1 / length(a), a);
}

// (1 - s) a + s b
static inline vec3 lerp(vec3 a, vec3 b, real s) {
    return add(scale(1 - s, a), scale(s, b));
}

static inline vec3 absolute(vec3 a) {
    return (vec3){fabs(a.x), fabs(a.y), fabs(a.z)};
}

static inline bool is_finite(vec3 a) {
    return isfinite(a.x) && isfinite(a.y) && isfinite(a.z);
}

#endif
