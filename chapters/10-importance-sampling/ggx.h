// ggx.h: a rough mirror whose microscopic normals are distributed by GGX.
// Directions here are unit and local: z along the surface's normal. alpha is the
// roughness, 0.001 to 1. Source: Walter et al. 2007; Heitz 2014 (masking), 2018.
#ifndef CHAPTER_GGX_H
#define CHAPTER_GGX_H

#include "chapters/09-path-tracer/path.h"

// D(h): the density of the microscopic normals, ∫ D(h) h.z dh = 1. In 1/sr.
real ggx_density(vec3 h, real alpha);

// f_r without the Fresnel factor: D G2 / (4 o.z v.z), h half way between o and v, with
// Smith's height-correlated G2. 0 unless o.z > 0 and v.z > 0.
real ggx_brdf(vec3 o, vec3 v, real alpha);

// G2(o, v) / G1(o): what is left of f_r v.z / probability (and of the Fresnel factor)
// when v is o mirrored in a visible normal. At most 1.
real ggx_weight(vec3 o, vec3 v, real alpha);

// Schlick's reflectance for the reflectance F0 straight on; cosine = o·h, clamped to [0, 1].
color schlick_color(color F0, real cosine);

// Exercises: exercises/10-importance-sampling/ -------------------------------------

// A microscopic normal that is seen from o (o.z >= 0), chosen by its share of the view: the density
// ggx_normal_probability. Source: Heitz 2018; Dupuy and Benyoub 2023.
vec3 ggx_normal(vec3 o, real alpha, rng *g);

// The density of ggx_normal: G1(o) max(0, o·h) D(h) / o.z, per steradian of h; written so
// that o.z = 0 is no division by zero.
real ggx_normal_probability(vec3 o, vec3 h, real alpha);

#endif
