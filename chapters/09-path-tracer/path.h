// path.h: light by random paths: the rendering equation solved by Monte Carlo.
#ifndef CHAPTER_PATH_H
#define CHAPTER_PATH_H

#include "chapters/08-monte-carlo/monte_carlo.h"

// A matte surface that may shine.
typedef struct {
    color albedo;    // rho: the share of the light that both sides reflect, 0 to 1
    color emittance; // L_e: the radiance that the front side sends out, >= 0
} matte;

typedef struct {
    scene bodies;          // their places; of the sky, NULL is black; materials are unused
    const matte *surfaces; // one for each body, as scene_nearest numbers them
} room;

// The radiance that arrives along r after at most s bounces, 0 <= s: what the first
// hit emits counts for s = 0 too, and so does the sky. d of any length; a hit has t > 0.
typedef color (*path_tracer)(const room *sc, ray r, int s, rng *g);

// L_e towards where the ray came from: the front's emittance, black from behind.
color emitted(const matte *m, hit h);

// The sky in the direction d; black where the scene has none.
color sky_light(const scene *bodies, vec3 d);

// The lecture's trace_ray: the nearest hit, and bounce_ray there; the sky on a miss;
// only what is emitted when s is 0. Recursive.
color trace_ray(const room *sc, ray r, int s, rng *g);

// The lecture's bounce_ray with its slip, dot(d, v) for dot(n, v), and the trace_ray
// around it: its light is negative.
color trace_ray_slide(const room *sc, ray r, int s, rng *g);

// The chance that path_trace gives a path of the weight C to go on after bounce number
// `bounce`, 0, 1, ...: 1 for the first few, then C's largest component, at most 0.95.
// 0 where C is black: such a path brings nothing.
real survival(color C, int bounce);

// Exercises: exercises/09-path-tracer/ -------------------------------------------

// Uniform on the hemisphere about the unit normal n: unit, density 1/(2π), v·n >= 0.
vec3 hemisphere_direction(vec3 n, rng *g);

// The lecture's bounce_ray, mended: the radiance that leaves the hit h of the ray r
// back along it: L_e + f_r trace_ray(..) (n·v) / (1/(2π)), with one uniform direction v,
// whose ray has s - 1 bounces left. n is the side that r came from. s = 0: only L_e.
color bounce_ray(const room *sc, const matte *m, ray r, hit h, int s, rng *g);

// trace_ray as a loop: the same mean, no recursion, and roulette(survival(..)) after
// each bounce.
color path_trace(const room *sc, ray r, int s, rng *g);

// Russian roulette: 1/q with probability q, else 0: the mean is 1. 0 <= q <= 1; for
// q = 1 always 1, for q = 0 always 0.
real roulette(real q, rng *g);

// The furnace test: n >= 2 paths of f, of at least one bounce, towards a lone sphere of
// this albedo that shines with the radiance 1, under a sky of 1 everywhere. Each path ought to
// bring 1 + albedo in the mean, in all three colours: how many standard errors is the
// mean (over paths, of the three colours' mean) above it? Right tracers: less than 5 in
// size. The right mean within rounding: 0. A wrong one without any spread: ±INFINITY. A
// sample that is not finite: NaN.
double furnace_test(path_tracer f, real albedo, long n, rng *g);

#endif
