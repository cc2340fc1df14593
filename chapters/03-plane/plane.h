// plane.h: what a hit is, and where a ray meets a plane.
#ifndef CHAPTER_PLANE_H
#define CHAPTER_PLANE_H

#include "chapters/02-camera/camera.h"
#include "common/wide3.h"

#define NO_HIT ((real)INFINITY)

// The point in which a ray meets a surface. Every *_hit function returns only
// t, the smallest with t_min < t < t_max, or NO_HIT; the rest is worked out
// once, for the nearest, by the surface's *_surface function.
typedef struct {
    real t;     // in units of |d|
    vec3 p;     // O + t d, rounded
    vec3 error; // |p - surface| per axis: at most this much through rounding
    vec3 n;     // geometric, unit, outward: not turned towards the ray
    bool front; // d·n < 0: the ray comes from outside
} hit;

// The hit at t of a surface with the unit normal n: p, error and front.
// error per axis: rounding_bound(4) (|O| + |t d|), for a t within one rounding
// of the true one. Source: PBRT 4th ed., section 6.8.
hit hit_at(ray r, real t, vec3 n);

// All points p with (p - x)·n = 0.
typedef struct {
    vec3 x; // a point of the plane
    vec3 n; // its normal, outward, of any length but 0
} plane;

// The hit at t, which plane_hit gave: hit_at's, and in `error` also what plane_hit may have lost
// in double.
hit plane_surface(plane P, ray r, real t);

// Planes as the equations n·p = D, side by side, for planes that many rays ask for. What
// all rays would do again is done once: numbers made double, n·x worked out, n made a unit
// vector; and the processor works out several planes with one instruction.
enum { EQUATIONS = 8 };
typedef struct {
    double x[EQUATIONS], y[EQUATIONS], z[EQUATIONS]; // n, of any length
    double D[EQUATIONS];  // n·x, worked out with twice a double's digits, and then rounded
    vec3 unit[EQUATIONS]; // n / |n|
} plane_equations;

// Of `count` planes, or of the first EQUATIONS if they are more; the places that are left are
// 0 = 0, which no ray hits.
plane_equations plane_equations_of(const plane *planes, int count);

// As plane_hit, of each: t[i] = (D - n·O) / n·d, when that, rounded to real, is above t_min; else
// NO_HIT. Double inside: off by one rounding of t, and by a few DBL_EPSILON of
// |n|(|O| + |t d|) / |n·d|.
void equations_hit(const plane_equations *E, ray r, real t_min, real t[EQUATIONS]);

// As plane_surface, of the plane in place i.
hit equations_surface(const plane_equations *E, int i, ray r, real t);

typedef struct {
    plane P; // through the centre P.x
    real radius;
} disc;

// Which square of a board with sides of one unit holds (x, z)? 0 or 1,
// alternating; a border belongs to the square with the larger coordinates.
int checks(real x, real z);

// Exercises: exercises/03-plane/ -------------------------------------------

// t = (x - O)·n / d·n, when that, rounded to real, has t_min < t < t_max; else NO_HIT. A ray parallel to
// the plane (d·n exactly 0) misses, also inside it. Double inside: the
// difference x - O and both dot products.
real plane_hit(plane P, ray r, real t_min, real t_max);

// As plane_hit, for the points at most `radius` from the centre (rim included).
// Radius 0 is never hit.
real disc_hit(disc D, ray r, real t_min, real t_max);

// The mean of checks() over the box [x - w/2, x + w/2] x [z - w/2, z + w/2],
// w > 0: exact but for rounding in double, by integrals, not by sampling.
real checks_average(real x, real z, real w);

#endif
