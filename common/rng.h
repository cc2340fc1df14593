// rng.h: random numbers, PCG32 (O'Neill 2014, PCG-XSH-RR 64/32).
// The state is a parameter: one generator per pixel and sample, so that any
// number of threads draws the same picture.
#ifndef COMMON_RNG_H
#define COMMON_RNG_H

#include "common/real.h"

typedef struct {
    uint64_t state, increment;
} rng;

// The generator's reference seeding: two different streams never coincide.
rng rng_seed(uint64_t seed, uint64_t stream);

// The generator of one sample of one pixel: seed, pixel and sample are hashed,
// so neighbours are uncorrelated. 0 <= x, y, sample.
rng rng_sample(uint64_t seed, int x, int y, int sample);

// 32 random bits.
uint32_t rng_bits(rng *g);

// Uniform in [0, 1), never 1: 24 bits for float, 53 for double (two draws).
real rng_real(rng *g);

// Uniform in [0, 1) with 53 bits, whatever real is: for tests and measuring.
double rng_double(rng *g);

#endif
