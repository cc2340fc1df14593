// noise.c: see noise.h.
#include "chapters/12-bvh/noise.h"

#include <math.h>

// One to one, and each bit of h changes about half the bits of the result.
// Source: Wellons, Prospecting for Hash Functions, 2018.
static uint32_t scramble(uint32_t h) {
    h = (h ^ h >> 16) * 0x7feb352du;
    h = (h ^ h >> 15) * 0x846ca68bu;
    return h ^ h >> 16;
}

// How much a whole number counts at the distance u, |u| <= 1, from it: 1 at 0, 0 at 1, flat
// at both.
static double weight(double u) {
    const double a = fabs(u);
    return 1 - a * a * a * (10 + a * (6 * a - 15));
}

static double weight_slope(double u) {
    const double a = fabs(u);
    return -30 * u * a * (1 - a) * (1 - a);
}

// The share of the corner (i, j): a plane through it of random slope, weighted.
static noise corner(int64_t i, int64_t j, double x, double y, uint32_t seed) {
    const uint32_t h = scramble((uint32_t)i + scramble((uint32_t)j + seed));
    const double gx = (double)(h & 0xffff) / 0x8000 - 1, gy = (double)(h >> 16) / 0x8000 - 1;
    const double u = x - (double)i, v = y - (double)j, plane = gx * u + gy * v;
    const double wu = weight(u), wv = weight(v);
    return (noise){wu * wv * plane, wu * wv * gx + weight_slope(u) * wv * plane,
                   wu * wv * gy + wu * weight_slope(v) * plane};
}

static noise plus(noise a, noise b) {
    return (noise){a.value + b.value, a.x + b.x, a.y + b.y};
}

noise noise_at(double x, double y, uint32_t seed) {
    const int64_t i = (int64_t)floor(x), j = (int64_t)floor(y);
    const uint32_t s = scramble(seed);
    return plus(plus(corner(i, j, x, y, s), corner(i + 1, j, x, y, s)),
                plus(corner(i, j + 1, x, y, s), corner(i + 1, j + 1, x, y, s)));
}

noise noise_sum(double x, double y, double f, int octaves, uint32_t seed) {
    noise sum = {0};
    for (int i = 0; i < octaves; i++, f *= 2) {
        const noise n = noise_at(f * x, f * y, seed + (uint32_t)i);
        sum = plus(sum, (noise){n.value / f, n.x, n.y});
    }
    return sum;
}
