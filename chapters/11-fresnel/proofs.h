// proofs.h: two pictures that prove what they show. Each is drawn by glass_trace and then measured;
// one line a claim is printed, measured beside expected with both standard errors.
#ifndef CHAPTER_PROOFS_H
#define CHAPTER_PROOFS_H

#include "chapters/11-fresnel/glass.h"

// The light that a glass ball throws on floors at 0.8, 1 and 2 focal lengths from its centre, each
// opt->width / 3 wide and high, 1 being the sun's own light: every ring is what light traced
// forwards gives, and the focus is where it must be. Returns how many claims fail: with
// 16 claims at 5 standard errors a right program fails once in 100,000 runs.
enum { FLOORS = 3 };
int prove_caustic(const options *opt, image floors[FLOORS]);

// The sky from under water: its radiance is n² (1 - R), and it ends at h tan(asin(1/n)).
int prove_window(const options *opt, image *window);

#endif
