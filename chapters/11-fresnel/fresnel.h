// fresnel.h: what a smooth boundary reflects and what it lets through.
//
// eta = n_transmitted / n_incident: above 1 into the denser side, below 1 out of it.
// cosine: of the angle between the ray and the normal on its own side, 0 to 1.
#ifndef CHAPTER_FRESNEL_H
#define CHAPTER_FRESNEL_H

#include "chapters/10-importance-sampling/importance.h"

// R0 + (1 - R0)(1 - cos θ)^5 as on the slide, with R0 = ((eta - 1)/(eta + 1))² that it
// leaves out: right when the ray comes from the less dense side.
real schlick_slide(real cosine, real eta);

// Schlick for a conductor with the index eta + i k, R0 = ((eta-1)² + k²)/((eta+1)² + k²).
color schlick_conductor(real cosine, color eta, color k);

// A metal's index for red, green and blue light (650, 550, 450 nm).
typedef struct {
    const char *name;
    color eta, k;
} metal;
extern const metal metals[]; // Au Ag Cu Al Fe Cr W, ended by a name of NULL

// Exercises: exercises/11-fresnel/ -----------------------------------------------

// Snell's law: the direction of the unit ray d behind a surface with the unit normal
// n on the ray's side (d·n <= 0). False on total reflection, *t untouched; at the critical angle itself the
// light goes on along the surface. *t is unit. eta = 1: *t = d.
bool refract(vec3 d, vec3 n, real eta, vec3 *t);

// The share of unpolarised light that is reflected, exactly: (r_s² + r_p²)/2; 1 on total
// reflection. 0 for eta = 1. Relative error: a rounding of the result, but for the critical angle. Double inside.
real fresnel_dielectric(real cosine, real eta);

// Schlick's approximation with the cosine on the less dense side; 1 on total reflection;
// 0 for eta = 1.
real schlick(real cosine, real eta);

// The next direction at a glass surface: d mirrored with the probability R =
// fresnel_dielectric, else refracted. R cancels: the path's weight stays as it is.
// d and n unit, d·n <= 0. Draws one number.
vec3 glass_bounce(vec3 d, vec3 n, real eta, rng *g);

// The same share for a conductor with the index eta + i k, colour by colour. Exact.
color fresnel_conductor(real cosine, color eta, color k);

// What is left of light after the way t through a medium that absorbs sigma per unit:
// e^(-sigma t), colour by colour (Beer 1852, Lambert 1760). sigma = 0 leaves 1, also for
// t = INFINITY.
color absorb(color sigma, real t);

#endif
