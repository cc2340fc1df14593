// importance.h: directions chosen where the light is, and the densities that belong to them.
#ifndef CHAPTER_IMPORTANCE_H
#define CHAPTER_IMPORTANCE_H

#include "chapters/10-importance-sampling/ggx.h"

// ---- frames (frame.c) --------------------------------------------------------------

// Two unit vectors s, t that make a right-handed frame with the unit normal n: s x t = n.
// For any n, also (0, 0, -1). Source: Duff et al. 2017.
typedef struct {
    vec3 s, t, n;
} frame;
frame orthonormal_basis(vec3 n);

// The coordinates of v in the frame: (v·s, v·t, v·n); and back.
vec3 to_local(frame f, vec3 v);
vec3 to_world(frame f, vec3 v);

// ---- surfaces --------------------------------------------------------------------

typedef enum { LAMBERT, GGX } lobe;

typedef struct {
    lobe lobe;
    color albedo;    // LAMBERT: rho; GGX: the reflectance straight on, F0
    color emittance; // L_e of the front side
    real alpha;      // GGX: the roughness, 0.001 to 1
} surface;

// n is unit, on the side of o; o and v are unit and point away from the surface.
// f_r(v, o) in 1/sr; black unless n·o > 0 and n·v > 0.
color surface_brdf(const surface *m, vec3 n, vec3 o, vec3 v);

// The density with which surface_scatter chooses v.
real surface_probability(const surface *m, vec3 n, vec3 o, vec3 v);

typedef struct {
    vec3 v;       // the direction, unit
    color weight; // f_r (n·v) / p
    real p;       // its density per steradian; 0: the path ends
} scattered;

// A direction where the surface sends much: of a density proportional to the cosine (LAMBERT), or
// o mirrored in a visible normal (GGX). n and o as for surface_brdf.
scattered surface_scatter(const surface *m, vec3 n, vec3 o, rng *g);

// ---- lamps -----------------------------------------------------------------------

// A triangle of a lamp, with all that aiming at it needs.
typedef struct {
    triangle T;
    vec3 n;     // unit
    real up_to; // the area of the triangles so far, this one included
} facet;

// A body that shines and can be aimed at: a sphere or a mesh.
typedef struct {
    int body;            // as scene_nearest numbers it
    const sphere *S;     // or NULL: a mesh
    const facet *facets; // of a mesh; or NULL
    int count;           // of facets
    real area;           // of all of them
    vec3 error;          // bounds that of a point of any facet, as in a hit
    bool hides_itself;   // can one part of it stand before another? Not of a flat mesh
} lamp;

typedef struct {
    lamp *lamps;
    int count;
    real chance;        // of each to be aimed at: 1 / count
    const int *of_body; // which lamp a body is; -1: none
} lamps;

// Finds the spheres and meshes that shine; a plane cannot be aimed at. It points into `bodies`.
// Free it with lamps_free.
lamps lamps_find(const scene *bodies, const surface *surfaces);
void lamps_free(lamps *all);

// A point of a lamp, as seen from x.
typedef struct {
    int body;   // -1: there is none to be seen from x
    hit on;     // the point; on.t is the distance
    vec3 v;     // the direction, unit
    vec3 end;   // where a shadow ray ends: off the surface, if the lamp could hide itself
    int except; // and which body it may touch; -1: none
} aim;

// A lamp, each as likely; of a sphere a uniform direction in the cone in which x sees it, of a
// mesh a uniform point.
aim lamps_aim(const lamps *all, vec3 x, rng *g);

// The density per steradian with which lamps_aim at x chooses the direction to the point h of
// the body; 0 for what is no lamp.
real lamps_probability(const lamps *all, int body, vec3 x, hit h);

// Is anything but the sphere or mesh `except` (-1: but nothing) at a point of the ray with
// 0 < t < t_max?
bool scene_blocked(const scene *sc, ray r, real t_max, int except);

// ---- the path tracer ---------------------------------------------------------------

typedef enum {
    BY_UNIFORM, // as in chapter 09
    BY_BRDF,    // where the surface sends most
    BY_LAMPS,   // where the lamps are; the path goes on by the BRDF
    BY_BALANCE, // both, balance heuristic
    BY_POWER,   // both, power heuristic
} strategy;

typedef struct {
    scene bodies;
    const surface *surfaces; // one for each body
    lamps lamps;
    strategy strategy;
} lit_room;

// A room, made ready for many rays: its lamps are found, the equations of its planes worked out.
// It points to what `bodies` points to and to `surfaces`. Free it with lit_free.
lit_room lit(scene bodies, const surface *surfaces, strategy how);
void lit_free(lit_room *sc);

// A path_tracer for lit rooms: the radiance that arrives along r after at most s bounces.
color light_trace(const lit_room *sc, ray r, int s, rng *g);

// Where a path stands: on a surface, at a hit.
typedef struct {
    const surface *m;
    vec3 n, o;  // unit; o: where the path came from, n: the hit's normal on the side of o
    vec3 start; // where rays leave from: the hit's point, off the surface on the side of n
} stop;
stop stop_at(const surface *m, ray r, hit h); // r.d is unit

// One sample of the lamps: the radiance that comes from them without a bounce and is sent on
// to o, weighted as the strategy says. Black for BY_UNIFORM and BY_BRDF.
color direct_light(const lit_room *sc, const stop *at, rng *g);

// The other half of it, the weight of what a body shines that the path runs into by itself:
// r starts where the path was scattered with the density p, and hits the body at h. 1 for
// what direct_light never aims at.
real share_of_hit(const lit_room *sc, int body, ray r, hit h, real p);

// p² / (p² + q²); Veach's power heuristic. p and q as for balance_heuristic.
real power_heuristic(real p, real q);

// Exercises: exercises/10-importance-sampling/ -------------------------------------

// A unit vector v with the density cos θ / π about the unit normal n. v·n >= 0, but for a
// rounding.
vec3 cosine_direction(vec3 n, rng *g);

// The density of cosine_direction at the unit vector v: 0 below the surface.
real cosine_probability(vec3 n, vec3 v);

// A unit direction from x, uniform in the cone in which the sphere is seen, for x outside
// it. Also where it looks tiny (r/|x - c| down to 1e-6) and from close by: double inside.
vec3 sphere_direction(sphere S, vec3 x, rng *g);

// The density of sphere_direction at the unit vector v: 1 / (2π (1 - cos θ_max)) in the cone,
// to the last digits for small cones and large ones: double inside, and no cancellation.
// 0 where the ray (x, v) misses the sphere, and for x in it. For x on the surface itself, at
// |x - c| = r to the last digit, either is right: rounding decides who is there.
real sphere_probability(sphere S, vec3 x, vec3 v);

// A uniform point of the triangle: u, v of triangle_point (t is set to 0).
triangle_point triangle_sample(triangle T, rng *g);

// The density per steradian at x of a point y that was chosen uniformly on a surface of
// this area with the unit normal n_y there: |y - x|² / (area |cos θ'|), θ' the angle between
// n_y and y - x; INFINITY edge-on. y != x. Double inside: lengths may be 1e-15 or 1e15.
real solid_angle_probability(vec3 x, vec3 y, vec3 n_y, real area);

// The balance heuristic: the weight p / (p + q) of a sample that had the density p, and
// would have had q by the other way. p, q >= 0, not both 0, and one of them may be INFINITY.
// Right to a few roundings of the weight itself, however small it is.
real balance_heuristic(real p, real q);

#endif
