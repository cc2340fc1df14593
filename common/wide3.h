// wide3.h: a vec3 in double, whatever real is, for the formulas in which float
// would lose too much: float in, double inside, float out.
#ifndef COMMON_WIDE3_H
#define COMMON_WIDE3_H

#include "common/vec3.h"

typedef struct {
    double x, y, z;
} wide3;

static inline wide3 widen(vec3 a) {
    return (wide3){a.x, a.y, a.z};
}

// a - b. Exact for floats of not too different size.
static inline wide3 wide_sub(vec3 a, vec3 b) {
    return (wide3){(double)a.x - b.x, (double)a.y - b.y, (double)a.z - b.z};
}

// a + s b
static inline wide3 wide_along(wide3 a, double s, wide3 b) {
    return (wide3){a.x + s * b.x, a.y + s * b.y, a.z + s * b.z};
}

static inline double wide_dot(wide3 a, wide3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline wide3 wide_cross(wide3 a, wide3 b) {
    return (wide3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// a / |a|
static inline wide3 wide_unit(wide3 a) {
    const double size = sqrt(wide_dot(a, a));
    return (wide3){a.x / size, a.y / size, a.z / size};
}

static inline vec3 narrow(wide3 a) {
    return (vec3){(real)a.x, (real)a.y, (real)a.z};
}

#endif
