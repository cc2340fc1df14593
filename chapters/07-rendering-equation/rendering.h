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
#include "common/wide3.h"

// L_i: the radiance that arrives at x from the direction w (unit, away from x).
typedef double (*radiance_field)(const void *world, vec3 x, vec3 w);

// f_r in 1/sr, for the unit normal n and unit w_i, w_o with w·n > 0: the radiance sent
// to w_o for each unit of irradiance from w_i. Never negative, f_r(w_i, w_o) =
// f_r(w_o, w_i) (reciprocity), and ∫ f_r (w_i·n) dw_i <= 1 for all w_o (energy).
typedef double (*brdf)(const void *paint, vec3 n, vec3 w_i, vec3 w_o);

// ---- the equation ------------------------------------------------------------------

// A point of a surface, and all that the equation asks about it.
typedef struct {
    vec3 x, n;  // n: unit, on the side of w_o
    double L_e; // the same in all directions
    brdf f_r;
    const void *paint;
    radiance_field L_i;
    const void *world;
} lit_point;

// L_o(x, w_o), its integral by irradiance() with n_theta x n_phi directions.
double outgoing_radiance(const lit_point *at, vec3 w_o, int n_theta, int n_phi);

// The unit vector that is perpendicular to n (any length but 0), turned about n by phi
// from where it is for phi = 0. phi and phi + π: opposite directions.
wide3 perpendicular_at(vec3 n, double phi);

// The unit direction at the angle theta from n, towards perpendicular_at(n, phi).
vec3 direction_at(vec3 n, double theta, double phi);

// ---- quadrature --------------------------------------------------------------------

typedef enum { // the error falls as, for smooth integrands
    MIDPOINT,  // n^-2
    SIMPSON,   // n^-4; n odd, >= 3
    GAUSS,     // faster than any power; exact for polynomials up to degree 2n - 1
} quadrature;

enum { MOST_DIMENSIONS = 8 };

// The n >= 1 points and weights of a rule on [0, 1], in double, ascending.
void quadrature_rule(quadrature rule, int n, double *x, double *weight);

// ∫ f over the unit cube in `dimensions` (1 to 8) dimensions: the rule's grid with n
// points along each axis, n^dimensions evaluations.
typedef double (*integrand)(const void *data, const double *x);
double integrate_cube(quadrature rule, int n, int dimensions, integrand f, const void *data);

// ---- lights: as an L_i, in closed form, and as integrals over the light --------------

// A rectangle: corner, and the two perpendicular sides that leave it; it shines to the
// side of side1 x side2 with the radiance 1.
typedef struct {
    vec3 corner, side1, side2;
} rectangle;

// What lights x: an L_i for irradiance(). `world` points to the light. Each has
// radiance 1 in all directions; 0 where the ray (x, w) misses it.
double from_uniform_sky(const void *nothing, vec3 x, vec3 w);
double from_sphere(const void *S, vec3 x, vec3 w);
double from_disc(const void *D, vec3 x, vec3 w);      // both sides
double from_rectangle(const void *R, vec3 x, vec3 w); // its front, borders too

// E of a sphere of radiance 1 in closed form, for x outside it; what lies below the
// horizon of x gives nothing. All of it above: π (r/d)² cos θ. Derived in the text.
double sphere_irradiance(sphere S, vec3 x, vec3 n);

// E of a rectangle of radiance 1, all of it above the horizon, in closed form: Lambert's
// formula, half the sum over the edges of (angle of the edge seen from x) times
// (unit normal of edge's plane through x)·n. x on its back: 0. Source: Lambert 1760.
double rectangle_irradiance(rectangle R, vec3 x, vec3 n);

// E as an integral over the light instead of the hemisphere, with n x n points:
// dw = cos θ' dA / |y - x|². Points below the horizon, and all when x is on the back
// of R, give nothing.
double rectangle_irradiance_by_area(quadrature rule, int n, rectangle R, vec3 x, vec3 normal);

// Form factor of two rectangles, a to b: the share of what a sends out that b receives,
// 4-dimensional, n points an axis. Nothing stands between them.
double form_factor(quadrature rule, int n, rectangle a, rectangle b);

// The same with two of the four dimensions solved on paper: the mean over a of
// rectangle_irradiance() / π. All of b above the horizon of every point of a.
double form_factor_lambert(quadrature rule, int n, rectangle a, rectangle b);

// ---- BRDFs to hand around as f_r --------------------------------------------------------

typedef struct {
    double rho, shine;
} gloss;

double brdf_lambert(const void *rho, vec3 n, vec3 w_i, vec3 w_o); // a const double *
double brdf_own(const void *m, vec3 n, vec3 w_i, vec3 w_o);       // a const gloss *

// Exercises: exercises/07-rendering-equation/ --------------------------------------------

// Lambert's f_r for the albedo rho: the same in all directions, and reflecting the
// share rho of what arrives.
double lambert_brdf(double rho);

// E = ∫ L_i (w·n) dw over the hemisphere about the unit normal n, by the midpoint
// rule in spherical coordinates: n_theta x n_phi directions, θ in [0, π/2], φ in [0, 2π),
// dw = sin θ dθ dφ. For the sky of radiance 1: π, with an error of n_theta^-2.
double irradiance(radiance_field L_i, const void *world, vec3 x, vec3 n, int n_theta,
                  int n_phi);

// E of a disc of radiance 1 (both sides shine) at x, by the midpoint rule over its
// surface, n_r rings of n_phi points: dw = |cos θ'| dA / |y - x|², dA = r dr dφ.
// Points of the disc below the horizon of x give nothing. n is unit, D.P.n of any
// length but 0. Double inside.
double disc_irradiance(disc D, vec3 x, vec3 n, int n_r, int n_phi);

// The share of the light from w_o that f reflects into all directions (which by
// reciprocity is the radiance that is sent to w_o under a sky of radiance 1):
// ∫ f(w_i, w_o) (w_i·n) dw_i, by the midpoint rule of n_theta x n_phi directions.
double directional_albedo(brdf f, const void *paint, vec3 n, vec3 w_o, int n_theta, int n_phi);

// A BRDF of your own, with a lobe: anything but Lambert's that is finite, not negative,
// reciprocal, and never reflects more than the share rho (0 to 1) of the light from any
// direction, and at least rho / 10 straight on. shine >= 0: how narrow the lobe is, in
// a measure of your own; for shine up to 200 no narrower than 0.005 radians, or the tests'
// directions miss it. n, w_i, w_o unit, w·n > 0, all pointing away from the surface.
double own_brdf(double rho, double shine, vec3 n, vec3 w_i, vec3 w_o);

#endif
