// check-rows.h: wrong answers, and what the runner says of each. check-fixtures.c
// makes a test of every row, check-self.c runs it and reads. SILENT: the runner
// does not say what the answer looks like.
#ifndef TESTS_CHECK_ROWS_H
#define TESTS_CHECK_ROWS_H

#include "common/real.h"

#define SILENT NULL
#define IN_DOUBLE \
    "looks like the right formula with too few digits: rounding that could be avoided\n"
#ifdef REAL_IS_DOUBLE
#define TOO_FEW_DIGITS IN_DOUBLE
#else
#define TOO_FEW_DIGITS \
    "looks like the right formula with too few digits: rounding. Double inside?\n"
#endif

// clang-format off

// X(name of the test, what is got, what is said)
#define REAL_EXPECTED 3.7
#define REAL_ROWS(X) \
    X(minus, -3.7, "the sign is wrong") \
    X(twice, 7.4, "looks like twice") \
    X(half, 1.85, "looks like half") \
    X(four, 14.8, "looks like 4 times") \
    X(quarter, 0.925, "looks like a quarter") \
    X(times_pi, 3.7 * PI, "looks like π times") \
    X(over_pi, 3.7 / PI, "divided by π\n") \
    X(times_2pi, 7.4 * PI, "looks like 2π times") \
    X(over_2pi, 1.85 / PI, "divided by 2π\n") \
    X(square, 3.7 * 3.7, "the square of") \
    X(root, 1.9235384, "the square root of") \
    X(reciprocal, 1 / 3.7, "the reciprocal of") \
    X(nothing, 0, "looks like nothing was computed?") \
    X(nan, NAN, "looks like NaN") \
    X(minus_nan, -NAN, "got        nan\n") \
    X(infinity, INFINITY, "reported as a miss") \
    X(minus_infinity, -INFINITY, "looks like minus infinity") \
    X(off_by, 3.7001, "got        3.7001 (off by 0.0001)") \
    X(nearly, 3.7001, TOO_FEW_DIGITS) \
    X(just_nearly, 3.69965, TOO_FEW_DIGITS) \
    X(not_nearly, 3.7005, SILENT) \
    X(no_idea, 5.55, SILENT)

// X(name of the test, x, y, z, what is said)
#define VEC3_EXPECTED {(real)0.48, (real)-0.6, (real)0.64}
#define VEC3_ROWS(X) \
    X(negated, -0.48, 0.6, -0.64, "the sign is wrong") \
    X(flip_x, -0.48, -0.6, 0.64, "the sign of x is wrong") \
    X(flip_y, 0.48, 0.6, 0.64, "the sign of y is wrong") \
    X(flip_z, 0.48, -0.6, -0.64, "the sign of z is wrong") \
    X(swap_xy, -0.6, 0.48, 0.64, "x and y are swapped") \
    X(swap_yz, 0.48, 0.64, -0.6, "y and z are swapped") \
    X(swap_xz, 0.64, -0.6, 0.48, "x and z are swapped") \
    X(shift, -0.6, 0.64, 0.48, "shifted: y, z, x") \
    X(longer, 1.2, -1.5, 1.6, "the right direction, but 2.5 times as long: not normalised?") \
    X(twice, 0.96, -1.2, 1.28, "looks like twice") \
    X(squared, 0.2304, 0.36, 0.4096, "each component squared") \
    X(nothing, 0, 0, 0, "looks like nothing was computed?") \
    X(one_zero, 0.48, 0, 0.64, SILENT) \
    X(nan, NAN, 0, 0, "looks like NaN") \
    X(minus_nan, -NAN, 0, 0, "got        (nan, 0, 0)\n") \
    X(nearly, 0.48003, -0.6, 0.64, TOO_FEW_DIGITS) \
    X(not_nearly, 0.4803, -0.6, 0.64, SILENT) \
    X(no_idea, 0.9, 0.2, 0.1, SILENT)

// clang-format on

#endif
