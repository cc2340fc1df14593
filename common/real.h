// real.h: the number type of the course.
// float unless the build says REAL=double (make REAL=double). <tgmath.h> picks
// the function for the type, so that sqrt(b*b - 4*a*c) reads as on the slide.
#ifndef COMMON_REAL_H
#define COMMON_REAL_H

#include <float.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <tgmath.h>

#ifdef REAL_IS_DOUBLE
typedef double real;
#define REAL_NAME "double"
#define REAL_EPSILON DBL_EPSILON // the step from 1 to the next number: 2^-52
#define REAL_MAX DBL_MAX
#define REAL_MIN DBL_MIN
#else
typedef float real;
#define REAL_NAME "float"
#define REAL_EPSILON FLT_EPSILON // 2^-23
#define REAL_MAX FLT_MAX
#define REAL_MIN FLT_MIN
#endif

#define PI 3.14159265358979323846 // a double: cast to real where float arithmetic is meant

#define COUNT(array) ((int)(sizeof(array) / sizeof *(array)))

// Bound on the relative error of n roundings in a row: n u / (1 - n u) with
// u = REAL_EPSILON / 2. Source: Higham, Accuracy and Stability of Numerical
// Algorithms, section 3.1; PBRT 4th ed., section 6.8.1.
static inline real rounding_bound(int n) {
    const real u = REAL_EPSILON / 2;
    return n * u / (1 - n * u);
}

#endif
