// check-threads.h: is a picture the same with any number of threads?
#ifndef TESTS_CHECK_THREADS_H
#define TESTS_CHECK_THREADS_H

#include <string.h>
#ifdef _OPENMP
#include <omp.h>
#endif

#include "common/image.h"

// What is rendered from now on in this process uses n threads.
static inline void threads(int n) {
#ifdef _OPENMP
    omp_set_num_threads(n);
#else
    (void)n;
#endif
}

// The same size, and bit for bit the same numbers.
static inline bool same_pixels(image a, image b) {
    const size_t size = (size_t)a.width * (size_t)a.height * sizeof *a.pixels;
    return a.width == b.width && a.height == b.height && memcmp(a.pixels, b.pixels, size) == 0;
}

#endif
