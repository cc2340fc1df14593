// sphere.h: the quadratic equation, and where a ray meets a sphere.
#ifndef CHAPTER_SPHERE_H
#define CHAPTER_SPHERE_H

#include "chapters/03-plane/plane.h"

typedef struct {
    vec3 c; // centre
    real r; // radius, > 0; 0 is never hit
} sphere;

typedef struct {
    int count;     // 0, 1 or 2 real roots
    double t0, t1; // t0 <= t1; a double root counts as two equal ones
} roots;

// The roots of a t² + b t + c = 0 as on the slide: (-b ± sqrt(b² - 4ac)) / 2a.
// a = 0: the one root of the line, or none. Loses digits when b² >> 4ac.
roots solve_quadratic(double a, double b, double c);

// The slide's formula in real arithmetic throughout: right nearby, noise far
// away (the chapter measures it). t, or NO_HIT.
real sphere_hit_slide(sphere S, ray r, real t_min, real t_max);

// The nearest hit with t_min < t < t_max, or NO_HIT. A tangent is a hit.
// The variant that the chapter's measurements justify.
real sphere_hit(sphere S, ray r, real t_min, real t_max);

hit sphere_surface(sphere S, ray r, real t);

typedef struct {
    vec3 a, b; // the ends of the axis, a != b
    real r;    // radius, > 0; an open tube, without caps
} cylinder;

// Exercises: exercises/04-sphere/ ------------------------------------------

// Which root? The smallest with t_min < t < t_max, or NO_HIT.
real nearest_root(roots q, real t_min, real t_max);

// As solve_quadratic, for coefficients of any size: no cancellation in -b ± sqrt
// (q = -(b + sign(b) sqrt(..)) / 2, roots q/a and c/q), none in b² - 4ac
// (Kahan's difference of products), no overflow. Count exact for exact input.
roots stable_quadratic(double a, double b, double c);

// A quarter of the discriminant b² - 4ac of the sphere's quadratic, for a
// sphere far away: a (r² - |v - (v·d/d·d) d|²). In real arithmetic. Source: Ray
// Tracing Gems, ch. 7. Negative: the ray misses.
real far_discriminant(sphere S, ray r);

// The nearest hit of the open tube, from outside or inside, or NO_HIT. A ray
// parallel to the axis misses.
real cylinder_hit(cylinder C, ray r, real t_min, real t_max);

#endif
