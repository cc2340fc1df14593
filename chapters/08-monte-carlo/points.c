// points.c: point sets of the unit square, from random to as even as can be. A coordinate
// is a 64-bit fraction: the integer x stands for x / 2^64, so that sums modulo 1 wrap
// around by themselves and nothing is rounded before the end. See monte_carlo.h.
#include "chapters/08-monte-carlo/monte_carlo.h"

const char *const point_names[POINT_KINDS] = {"random", "stratified", "Halton", "R2", "Sobol"};

static double fraction(uint64_t x) {
    return (double)(x >> 11) * 0x1p-53; // 53 bits are exact: rounding never gives 1
}

static uint64_t random_64(rng *g) {
    const uint64_t high = rng_bits(g);
    return high << 32 | rng_bits(g);
}

// A generator of its own for number i of this seed and kind.
static rng generator(uint64_t seed, uint64_t i, int kind) {
    return rng_sample(seed, (int)(i & INT32_MAX), (int)(i >> 31), kind);
}

// ---- random and stratified ---------------------------------------------------------

static point2 random_point(rng g) {
    const double u = rng_double(&g), v = rng_double(&g);
    return (point2){u, v};
}

static point2 stratified(long i, long n, rng g) {
    return stratified_point(i, lround(sqrt((double)n)), &g);
}

// ---- shifted sequences ---------------------------------------------------------------

// x + shift modulo 1. Source: Cranley and Patterson 1976.
static double shifted(double x, double shift) {
    const double sum = x + shift;
    return sum < 1 ? sum : sum - 1;
}

static point2 halton(uint64_t i, rng g) {
    const double a = rng_double(&g), b = rng_double(&g);
    return (point2){shifted(radical_inverse(2, i), a), shifted(radical_inverse(3, i), b)};
}

// Multiples of (1/p, 1/p²) modulo 1, p³ = p + 1: what the golden ratio is on a line, p is
// in the plane. The two constants are 2^64/p and 2^64/p². Source: Roberts 2018.
static point2 r2(uint64_t i, rng g) {
    const uint64_t a = random_64(&g), b = random_64(&g);
    return (point2){fraction(a + i * 0xc13fa9a902a6328fu),
                    fraction(b + i * 0x91e10da5c79e7b1du)};
}

// ---- Sobol's points, scrambled -------------------------------------------------------

// The lower half of each pair of blocks of 1, 2, 4, ... 32 bits.
static const uint64_t lower[6] = {0x5555555555555555, 0x3333333333333333, 0x0f0f0f0f0f0f0f0f,
                                  0x00ff00ff00ff00ff, 0x0000ffff0000ffff, 0x00000000ffffffff};

// The 64 bits mirrored: neighbours change places, then pairs, then fours.
static uint64_t mirrored(uint64_t x) {
    for (int k = 0; k < 6; k++) x = (x >> (1 << k) & lower[k]) | (x & lower[k]) << (1 << k);
    return x;
}

// Digit k of the result is the sum modulo 2 of the digits j of i with C(j, k) odd. That
// is so where k's ones are among j's (Lucas 1878): Pascal's triangle in six steps.
static uint64_t pascal(uint64_t i) {
    for (int k = 0; k < 6; k++) i ^= i >> (1 << k) & lower[k];
    return i;
}

point2 sobol_point(uint64_t i) {
    return (point2){fraction(mirrored(i)), fraction(mirrored(pascal(i)))};
}

// Owen's scrambling, of x with its first digit in the lowest bit: each digit is flipped or
// not, at random, by what all digits before it are. Sums and products carry only
// upwards, so every step here is of that kind; the first alone makes each x uniform. An
// odd factor loses no digit; an even one moves all upwards: what flips a digit is below it.
// Sources: Owen 1995; Laine and Karras 2011; Burley 2020.
static uint64_t scrambled(uint64_t x, rng *g) {
    x += random_64(g);
    x *= random_64(g) | 1;        // odd
    x ^= x * 0x9e3779b97f4a7c16u; // even
    x ^= x * 0xbf58476d1ce4e5b8u; // even
    return x;
}

static point2 scrambled_sobol(uint64_t i, rng g) {
    const uint64_t x = scrambled(i, &g), y = scrambled(pascal(i), &g);
    return (point2){fraction(mirrored(x)), fraction(mirrored(y))};
}

// ---- all of them -----------------------------------------------------------------------

point2 point_of(point_kind kind, long i, long n, uint64_t seed) {
    const uint64_t k = (uint64_t)i;
    switch (kind) {
    case STRATIFIED:
        return stratified(i, n, generator(seed, k, kind));
    case HALTON:
        return halton(k, generator(seed, 0, kind));
    case R2:
        return r2(k, generator(seed, 0, kind));
    case SOBOL:
        return scrambled_sobol(k, generator(seed, 0, kind));
    default:
        return random_point(generator(seed, k, kind));
    }
}

static double mean_of_set(point_kind kind, integrand f, const void *data, long n,
                          uint64_t seed) {
    double sum = 0;
    for (long i = 0; i < n; i++) {
        const point2 p = point_of(kind, i, n, seed);
        sum += f(data, (const double[]){p.u, p.v});
    }
    return sum / (double)n;
}

estimate points_estimate(point_kind kind, integrand f, const void *data, long n, int sets,
                         uint64_t seed) {
    running means = {0};
    for (int k = 0; k < sets; k++) {
        rng g = generator(seed, (uint64_t)k, POINT_KINDS); // of no kind: it draws seeds
        running_add(&means, mean_of_set(kind, f, data, n, random_64(&g)));
    }
    return (estimate){means.mean, running_standard_error(&means), n * sets};
}
