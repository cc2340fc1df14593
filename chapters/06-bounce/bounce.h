// bounce.h: materials, a scene, and the bounce loop.
#ifndef CHAPTER_BOUNCE_H
#define CHAPTER_BOUNCE_H

#include "chapters/05-triangle/triangle.h"

typedef enum {
    MIRROR, // r = d - 2(d·n)n
    FUZZY,  // the lecture's matte: the mirrored direction and a small random vector
    MATTE,  // as much light in every direction that the eye can be in (Lambert)
} finish;

typedef struct {
    finish finish;
    color albedo;   // the share of light that is reflected, 0 to 1: the slide's F
    color albedo_2; // the other squares, when checkered
    bool checkered; // by checks() of the point's x and z
    real fuzz;      // FUZZY: the length of the random vector, 0 to 1
} material;

// Where the next ray starts.
typedef enum {
    START_BOUND,   // past the error bound of the hit: offset_origin
    START_EPSILON, // at the point, with the fixed t_min 1e-4
    START_NOTHING, // at the point, t_min = 0: acne
} start_rule;

typedef struct {
    const sphere *spheres;
    const material *sphere_materials;
    int sphere_count;
    const plane *planes;
    const material *plane_materials;
    int plane_count;
    const mesh *meshes;
    const material *mesh_materials;
    int mesh_count;
    color (*sky)(vec3 d); // the background F_B in the direction d, of any length
    start_rule start;
    const plane_equations *equations; // of the planes, from scene_prepare; or NULL
} scene;

// A clear sky: white at the horizon, blue above, by the height of d.
color clear_sky(vec3 d);

// The scene with the equations of its planes, if they are many, worked out once for many rays:
// what is asked of it below has the same answer sooner, but for what equations_hit may be off
// in t, and for the larger hit.error, with REAL=double, that covers it. The planes must stay as
// they are until scene_release, which frees the equations, and nothing else.
scene scene_prepare(scene sc);
void scene_release(scene *sc);

// Does the ray meet any of the planes with t_min < t < t_max?
bool planes_block(const scene *sc, ray r, real t_min, real t_max);

// The nearest hit with t_min < t < t_max of everything in the scene; t = NO_HIT
// on a miss. *body is the number of what was hit, untouched on a miss: the spheres are
// counted first, then the planes, then the meshes.
hit scene_nearest(const scene *sc, ray r, real t_min, real t_max, int *body);

// The same, with the material of what was hit, *m, untouched on a miss.
hit scene_hit(const scene *sc, ray r, real t_min, real t_max, const material **m);

// The reflected share at the point p: the slide's F.
color albedo_at(const material *m, vec3 p);

// The next ray after the hit h of the ray r, by the material and the scene's
// start rule: a unit direction, on the side of the surface that r came from.
ray bounce(const scene *sc, const material *m, ray r, hit h, rng *g);

// The smallest t that counts as a hit for rays that `bounce` made.
real start_t_min(start_rule start);

// The loop exactly as on the slide, slips included: s = 0 gives white, and a
// path of exactly s bounces is black before it can reach the sky.
color trace_slide(const scene *sc, ray r, int s, rng *g);

// Uniform on the unit sphere (Marsaglia 1972). Given; the text says why.
vec3 unit_vector(rng *g);

// Exercises: exercises/06-bounce/ ------------------------------------------

// d mirrored in a surface with the unit normal n, on either side: d - 2(d·n)n.
vec3 reflect(vec3 d, vec3 n);

// The lecture's matte, mended: the mirrored unit direction plus fuzz times a
// random unit vector, made a unit vector; a sum that is zero or points into the
// surface is drawn again. n is unit, d of any length, d·n < 0; result·n > 0.
vec3 fuzzy_bounce(vec3 d, vec3 n, real fuzz, rng *g);

// A unit vector around the unit normal n whose density is cos θ / π per
// steradian: Lambert's matte. Every correct method passes.
vec3 matte_bounce(vec3 n, rng *g);

// The bounce loop without the slide's slips: the light along r after at most s
// bounces. C = 1; nearest hit; missed: C times the sky; hit with no bounce
// left: black; else C times the albedo, and bounce. s = 0 still sees the sky.
color trace(const scene *sc, ray r, int s, rng *g);

// d, of any length but 0, with its length brought to 1, within a few roundings.
// |d|² near 1, as after some reflections: one Newton step, d (3 - |d|²) / 2,
// without root or division; else normalize.
vec3 keep_unit(vec3 d);

// A start for the next ray along d, certainly on the side of the surface that
// d points to: p moved along the unit normal n by the error bound of p and
// then rounded away from the surface. Source: PBRT 4th ed., section 6.8.6.
vec3 offset_origin(vec3 p, vec3 error, vec3 n, vec3 d);

#endif
