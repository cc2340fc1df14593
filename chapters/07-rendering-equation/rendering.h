// rendering.h: the rendering equation, its symbols as types, its integral by quadrature.
//
//     L_o(x, w_o) = L_e(x, w_o) + ∫ f_r(x, w_i, w_o) L_i(x, w_i) (w_i·n) dw_i
//
// over the hemisphere of unit directions w_i with w_i·n > 0. Both w_i and w_o point
// away from x. Radiance is in W/(m² sr); a picture needs it up to one factor, so
// that 1 is the white of the picture.
#ifndef CHAPTER_RENDERING_H
#define CHAPTER_RENDERING_H

#include "chapters/06-bounce/bounce.h"

// L_i: the radiance that arrives at x from the direction w (unit, away from x).
typedef double (*radiance_field)(const void *scene, vec3 x, vec3 w);

// f_r in 1/sr, for the unit normal n and unit w_i, w_o with w·n > 0: the radiance sent
// to w_o for each unit of irradiance from w_i. Never negative, f_r(w_i, w_o) =
// f_r(w_o, w_i) (reciprocity), and ∫ f_r (w_i·n) dw_i <= 1 for all w_o (energy).
typedef double (*brdf)(const void *material, vec3 n, vec3 w_i, vec3 w_o);

// ---- quadrature ------------------------------------------------------------------

typedef enum { // the error falls as, for smooth integrands
    MIDPOINT,  // n^-2
    SIMPSON,   // n^-4; n odd, >= 3
    GAUSS,     // faster than any power; exact for polynomials up to degree 2n - 1
} quadrature;

// The n points and weights of a rule on [0, 1], in double. n >= 1.
void quadrature_rule(quadrature rule, int n, double *x, double *weight);

// ∫ f over the unit cube in `dimensions` (1 to 8) dimensions: the rule's grid with n
// points along each axis, n^dimensions evaluations.
typedef double (*integrand)(const void *data, const double *x);
double integrate_cube(quadrature rule, int n, int dimensions, integrand f, const void *data);

// ---- lights in closed form and as integrals over the light --------------------------

// A rectangle: corner, and the two sides that leave it; it shines to the side of
// side1 x side2 with the radiance 1.
typedef struct {
    vec3 corner, side1, side2;
} rectangle;

// What lights x: an L_i for irradiance(). `scene` points to the light. Each has
// radiance 1 in all directions; 0 where the ray (x, w) misses it.
double from_uniform_sky(const void *nothing, vec3 x, vec3 w);
double from_sphere(const void *sphere, vec3 x, vec3 w);
double from_disc(const void *disc, vec3 x, vec3 w);           // both sides
double from_rectangle(const void *rectangle, vec3 x, vec3 w); // its front

// E of a whole sphere of radiance 1 above the horizon, in closed form: π (r/d)² cos θ.
double sphere_irradiance(sphere S, vec3 x, vec3 n);

// E of a rectangle of radiance 1, all of it above the horizon, in closed form: Lambert's
// formula, half the sum over the edges of (angle of the edge seen from x) times
// (unit normal of edge's plane through x)·n. Source: Lambert 1760; Arvo 1994.
double rectangle_irradiance(rectangle R, vec3 x, vec3 n);

// E as an integral over the light instead of the hemisphere, with n x n points:
// dw = cos θ' dA / |y - x|².
double rectangle_irradiance_by_area(quadrature rule, int n, rectangle R, vec3 x, vec3 normal);

// Form factor of two rectangles, a to b: the share of what a sends out that b receives,
// 4-dimensional, n points an axis. Both fully visible, fronts facing.
double form_factor(quadrature rule, int n, rectangle a, rectangle b);

// Exercises: exercises/07-rendering-equation/ ------------------------------------

// Lambert's f_r for the albedo rho: the same in all directions, and reflecting the
// share rho of what arrives: rho / π.
double lambert_brdf(double rho);

// E = ∫ L_i (w·n) dw over the hemisphere about the unit normal n, by the midpoint
// rule in spherical coordinates: n_theta x n_phi directions, θ in [0, π/2], φ in [0, 2π),
// dw = sin θ dθ dφ. For the sky of radiance 1: π, with an error of n_theta^-2.
double irradiance(radiance_field L_i, const void *scene, vec3 x, vec3 n, int n_theta,
                  int n_phi);

// E of a disc of radiance 1 (both sides shine) at x, by the midpoint rule over its
// surface, n_r rings of n_phi points: dw = |cos θ'| dA / |y - x|², dA = r dr dφ.
// Points of the disc below the horizon of x give nothing.
double disc_irradiance(disc D, vec3 x, vec3 n, int n_r, int n_phi);

// The share of the light from w_o that f reflects into all directions (which by
// reciprocity is the share that is sent to w_o under a uniform sky):
// ∫ f(w_i, w_o) (w_i·n) dw_i, by the midpoint rule of n_theta x n_phi directions.
double directional_albedo(brdf f, const void *material, vec3 n, vec3 w_o, int n_theta,
                          int n_phi);

// A BRDF of your own, with a lobe: anything but Lambert's that is not negative,
// reciprocal, and never reflects more than the share rho (0 to 1). The solution is the
// modified Phong lobe, (k + 2)/(2π) rho max(0, r·w_o)^k, r = w_i mirrored. shine = k.
// Source: Lafortune and Willems 1994.
double own_brdf(double rho, double shine, vec3 n, vec3 w_i, vec3 w_o);

#endif
