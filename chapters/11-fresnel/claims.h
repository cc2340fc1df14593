// claims.h: what two of the pictures must show, worked out without a path tracer.
#ifndef CHAPTER_CLAIMS_H
#define CHAPTER_CLAIMS_H

#include "chapters/11-fresnel/glass.h"

// ---- a glass ball under the sun ------------------------------------------------------

// A ball of radius 1 with its centre in 0, and the floor y = -depth below it. The sun
// stands straight up and is the cone of directions within the angle `sun` (radians).
typedef struct {
    double n, depth, sun;
} ball_lens;

// Where rays near the axis meet, from the centre of a ball of radius 1: n / (2(n - 1)).
double ball_focus(double n);

// The floor's light as a map of size x size pixels, |x|, |z| < half_width < 0.8: the irradiance
// through the ball, divided by what the sun alone gives. By light traced forwards: `photons` rays
// from the sun, each followed through the ball by angles alone, with all its
// reflections inside. Free it with image_free.
image caustic_forwards(const ball_lens *B, double half_width, int size, long photons, rng *g);

// The same for one point of the floor, backwards: one sample by glass_trace. The ball is
// sc's only body, its sky is 1 in the sun and 0 outside.
double caustic_backwards(const glass_room *sc, const ball_lens *B, double x, double z, rng *g);

// ---- from under water ----------------------------------------------------------------

// The radius of the window through which the sky is seen from the depth h: all directions above are
// squeezed into the cone of the critical angle. h tan(asin(1/n)).
double window_radius(double n, double h);

// The radiance that arrives at an eye in a medium of index n from a uniform sky of radiance 1 beyond
// its flat surface, at this cosine: n² (1 - R), 0 beyond the critical angle. In double.
double window_light(double n, double cosine);

// ---- comparing -------------------------------------------------------------------------

// The mean of green over the pixels whose centres lie at r0 <= r < r1 from the
// picture's centre, in pixels. The picture must be symmetric about its upright middle line but for
// its noise: the standard error comes from the differences of mirrored pixels.
estimate ring_mean(const image *img, double r0, double r1);

// measured - expected, in standard errors of both.
double errors_apart(estimate measured, estimate expected);

#endif
