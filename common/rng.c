// rng.c: PCG-XSH-RR 64/32. A linear congruential generator walks the state; a
// shift and a rotation that depend on the state hide its weak low bits.
// Source: O'Neill, PCG: A Family of Simple Fast Space-Efficient Statistically
// Good Algorithms for Random Number Generation, HMC-CS-2014-0905.
#include "common/rng.h"

static const uint64_t multiplier = 6364136223846793005u; // Knuth's MMIX; the paper's choice
static const uint64_t golden = 0x9e3779b97f4a7c15u;      // 2^64 / golden ratio, odd

rng rng_seed(uint64_t seed, uint64_t stream) {
    rng g = {.state = 0, .increment = stream << 1 | 1}; // odd: the full period 2^64
    rng_bits(&g);
    g.state += seed;
    rng_bits(&g);
    return g;
}

// The finaliser of splitmix64: one to one, and each bit of x changes about half
// the bits of the result. Source: Steele, Lea, Flood 2014; constants by Stafford.
static uint64_t mix(uint64_t x) {
    x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9u;
    x = (x ^ x >> 27) * 0x94d049bb133111ebu;
    return x ^ x >> 31;
}

// The steps are one to one, so the samples of one seed never share both state and stream.
rng rng_sample(uint64_t seed, int x, int y, int sample) {
    const uint64_t pixel = (uint64_t)(uint32_t)y << 32 | (uint32_t)x;
    const uint64_t of_seed = mix(seed + golden);
    const uint64_t of_pixel = mix((of_seed ^ pixel) + golden);
    const uint64_t of_sample = mix((of_pixel ^ (uint32_t)sample) + golden);
    return rng_seed(of_sample, of_pixel);
}

uint32_t rng_bits(rng *g) {
    const uint64_t old = g->state;
    g->state = old * multiplier + g->increment;
    const uint32_t word = (uint32_t)((old >> 18 ^ old) >> 27);
    const uint32_t turn = (uint32_t)(old >> 59);
    return word >> turn | word << (-turn & 31);
}

real rng_real(rng *g) {
#ifdef REAL_IS_DOUBLE
    return rng_double(g);
#else
    return (real)(rng_bits(g) >> 8) * 0x1p-24f; // 24 bits are exact: rounding never gives 1
#endif
}

double rng_double(rng *g) {
    const uint64_t high = rng_bits(g) >> 5; // 27 bits
    const uint64_t low = rng_bits(g) >> 6;  // 26 bits
    return (double)(high << 26 | low) * 0x1p-53;
}
