// noise.h: a smooth random function of the plane, the same on every machine.
#ifndef CHAPTER_NOISE_H
#define CHAPTER_NOISE_H

#include <stdint.h>

typedef struct {
    double value, x, y; // n and its derivatives ∂n/∂x, ∂n/∂y
} noise;

// Gradient noise: -1 < n < 1, and n = 0 where x and y are whole numbers; there it has a random
// slope, and it has two continuous derivatives everywhere. |x|, |y| < 2^31. Each seed gives
// another function. Source: Perlin 1985; the weight 1 - 10 u³ + 15 u⁴ - 6 u⁵: Perlin 2002.
noise noise_at(double x, double y, uint32_t seed);

// n(f p) / f of `octaves` frequencies f, 2f, 4f ..., added.
noise noise_sum(double x, double y, double f, int octaves, uint32_t seed);

#endif
