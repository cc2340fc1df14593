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
    double t0, t1; // t0 <= t1; equal for one root, and for a double root (count 2)
} roots;

// The roots of a t² + b t + c = 0 as on the slide: (-b ± sqrt(b² - 4ac)) / 2a.
// a = 0: the one root of the line, or none. Loses digits when b² >> 4ac.
roots solve_quadratic(double a, double b, double c);

// The slide's formula in real arithmetic throughout: right nearby, noise far
// away (the chapter measures it). t, or NO_HIT.
real sphere_hit_slide(sphere S, ray r, real t_min, real t_max);

// The nearest hit with t_min < t < t_max, or NO_HIT. A tangent is a hit; d = 0
// hits nothing. Double inside, the discriminant as a r² - |v x d|²: the variant that
// the chapter's measurements justify. All lengths may be anything a float can be; with
// REAL=double |d| r and |d| |v| must lie between 1e-150 and 1e150.
real sphere_hit(sphere S, ray r, real t_min, real t_max);

// The hit at t, which is sphere_hit's. p is put onto the sphere, so that its error
// does not grow with the distance from O: about one rounding of p itself.
hit sphere_surface(sphere S, ray r, real t);

typedef struct {
    vec3 a, b; // the ends of the axis, a != b
    real r;    // radius, > 0; an open tube, without caps
} cylinder;

// Exercises: exercises/04-sphere/ ------------------------------------------

// Which root? The smallest with t_min < t < t_max, or NO_HIT. A root is rounded to
// real before it is compared: what comes back lies in the interval. NaN lies in none.
real nearest_root(roots q, real t_min, real t_max);

// As solve_quadratic, without its losses: none in -b ± sqrt
// (q = -(b + sign(b) sqrt(..)) / 2 with sign(0) = +1, roots q/a and c/q), none in
// b² - 4ac (Kahan's difference of products). A discriminant that is NaN: count 0. The count is exact and the roots are within
// 4 roundings, for coefficients that are 0 or of a size from 1e-145 to 1e150.
// Beyond, products of two overflow or lose their last bits.
roots stable_quadratic(double a, double b, double c);

// A quarter of the discriminant b² - 4ac of the sphere's quadratic, for a
// sphere far away: a (r² - |v - (v·d/d·d) d|²). Negative: the ray misses. In real
// arithmetic, for |d|, |d| |v| and |d| r from 1e-15 to 1e15. Source: Ray Tracing
// Gems, ch. 7.
real far_discriminant(sphere S, ray r);

// The nearest hit of the open tube, from outside or inside, or NO_HIT. Its rims
// belong to it, a tangent is a hit; a ray parallel to the axis misses, and so does
// every ray when r = 0 or a = b, or with a NaN in it. Double inside.
real cylinder_hit(cylinder C, ray r, real t_min, real t_max);

#endif
