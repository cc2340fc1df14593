// fresnel.h: what a smooth boundary reflects and what it lets through.
//
// eta = n_transmitted / n_incident: above 1 into the denser side, below 1 out of it.
// cosine: of the angle between the ray and the normal on the ray's own side, 0 to 1 but
// for rounding.
#ifndef CHAPTER_FRESNEL_H
#define CHAPTER_FRESNEL_H

#include "chapters/10-importance-sampling/importance.h"

// R0 + (1 - R0)(1 - cos θ)^5 as on the slide, with R0 = ((eta - 1)/(eta + 1))² that it
// leaves out: right when the ray comes from the less dense side.
real schlick_slide(real cosine, real eta);

// Schlick for a conductor with the index eta + i k, colour by colour:
// R0 = ((eta - 1)² + k²)/((eta + 1)² + k²).
color schlick_conductor(real cosine, color eta, color k);

// A metal's index eta + i k in air for red, green and blue light (650, 550, 450 nm).
typedef struct {
    const char *name;
    color eta, k;
} metal;
extern const metal metals[]; // Au Ag Cu Al Fe Cr W, ended by a name of NULL

// Exercises: exercises/11-fresnel/ -----------------------------------------------

// Snell's law: the direction *t, unit, of the ray d behind a surface with the normal n on
// the ray's side: sin θ_t = sin θ / eta, in the plane of d and n. d and n are unit,
// d·n <= 0. False on total reflection, with *t untouched; at the critical angle itself the
// light goes on along the surface. eta = 1: d. Double inside.
bool refract(vec3 d, vec3 n, real eta, vec3 *t);

// The share of unpolarised light that is reflected, exactly: (r_s² + r_p²)/2; 1 on total
// reflection, and at the critical angle; 0 for eta = 1. Within a rounding, relatively, for
// all angles and all eta, near 1 too (with REAL=double not near the critical angle).
// Double inside.
real fresnel_dielectric(real cosine, real eta);

// Schlick's approximation with the cosine on the less dense side, whichever the ray is on;
// 1 on total reflection; 0 for eta = 1.
real schlick(real cosine, real eta);

// The next direction at a glass surface: d mirrored with the probability R =
// fresnel_dielectric, else refracted; unit. R cancels: the path's weight stays as it is.
// d and n are unit, d·n <= 0 (but for rounding). Draws at most one number.
vec3 glass_bounce(vec3 d, vec3 n, real eta, rng *g);

// As fresnel_dielectric, for conductors of the index eta + i k, colour by colour: eta > 0,
// k >= 0 (0 is glass), but not both those of air. Exact, within a rounding of 1.
color fresnel_conductor(real cosine, color eta, color k);

// What is left of light after the way t >= 0 through a medium that absorbs sigma >= 0 per
// unit of length: e^(-sigma t), colour by colour. sigma = 0 leaves 1, also for
// t = INFINITY. Source: Bouguer 1729; Lambert 1760; Beer 1852.
color absorb(color sigma, real t);

#endif
