// raytracer.h: a ray tracer for the homework's three scenes.
//
//     main.c     command line, the loop over pixels
//     scenes.c   the scenes in numbers
//     camera.c   the ray through a point of the picture
//     shapes.c   where rays meet spheres, planes and triangles
//     mirror.c   the light of the mirror scene
//     path.c     the light of the box, by random paths
//     sample.c   random directions and points of the lamp
#ifndef HOMEWORK_RAYTRACER_H
#define HOMEWORK_RAYTRACER_H

#include "common/image.h"
#include "common/rng.h"

enum { WIDTH = 128, HEIGHT = 96 };
enum { BOUNCES = 1000 }; // of a path; roulette ends it long before
#ifndef SAMPLES
#define SAMPLES 64 // of a pixel of the box
#endif

typedef struct {
    vec3 O, d;
} ray;

typedef enum { SPHERE, PLANE, TRIANGLE } shape;
typedef enum { MATTE, MIRROR, GLOW } finish;

typedef struct {
    shape shape;
    vec3 p[3]; // SPHERE: its centre; PLANE: a point; TRIANGLE: its corners
    vec3 n;    // PLANE: unit
    real r;    // SPHERE
    finish finish;
    color color;  // MATTE: albedo, MIRROR: what it reflects, GLOW: the radiance of its front
    color color2; // of the odd checks
    bool checkered;
} body;

typedef struct {
    real t;        // along the ray, in |d|
    const body *b; // NULL: nothing was hit
    vec3 p, n;     // n: unit, on the side that the ray came from
    bool front;
} hit;

typedef struct {
    vec3 corner, a, b; // the points corner + u a + v b
    vec3 n;            // unit: where it shines to
    real area;
    color radiance;
} lamp;

typedef struct {
    vec3 eye, target;
    real fov; // vertical, in degrees
    const body *bodies;
    int count;
    bool sky;
    lamp lamp;
} scene;

extern const scene shapes_scene, mirror_scene, box_scene;

// The ray through the point (x, y) of the picture, in pixels from the top left corner. d is unit.
ray camera_ray(const scene *sc, real x, real y);

// The nearest hit with t_min < t < t_max.
hit nearest(const scene *sc, ray r, real t_min, real t_max);
enum { FAR = 1000000 };
#define NEAR ((real)1e-4) // a hundred roundings of the scenes' lengths

// Is anything between the two points, which lie on surfaces?
bool blocked(const scene *sc, vec3 x, vec3 y);

// cos θ cos θ' / |y - x|², 0 where one surface turns away from the other; n at x, m at y.
real geometry(vec3 x, vec3 n, vec3 y, vec3 m);

// Unit, with the density cos θ / π about the unit normal n.
vec3 cosine_direction(vec3 n, rng *g);

// A point of the lamp, each as likely.
vec3 lamp_point(const lamp *l, rng *g);

// What a pixel shows: the light that comes back along r after at most so many bounces.
typedef color (*look)(const scene *sc, ray r, int bounces, rng *g);
color mirror_light(const scene *sc, ray r, int bounces, rng *g);
color path_light(const scene *sc, ray r, int bounces, rng *g);

#endif
