// camera.h: rays, the pinhole camera, and the loop over pixels.
#ifndef CHAPTER_CAMERA_H
#define CHAPTER_CAMERA_H

#include "common/image.h"
#include "common/options.h"
#include "common/rng.h"

// The points O + t d, t >= 0. d need not have unit length: t counts in |d|.
typedef struct {
    vec3 O, d;
} ray;

static inline vec3 ray_at(ray r, real t) {
    return add(r.O, scale(t, r.d));
}

typedef enum { PINHOLE, ORTHOGRAPHIC, THIN_LENS } camera_kind;

typedef struct {
    vec3 eye;                // the centre of projection
    vec3 right, up, forward; // unit, perpendicular, right-handed: right x up = -forward
    int width, height;       // pixels
    real focal;              // from the eye to the image plane, in pixels
    camera_kind kind;        // PINHOLE unless set
    real span;               // ORTHOGRAPHIC: the picture's height in the scene's units
    real lens_radius;        // THIN_LENS
    real focus;              // THIN_LENS: the distance along forward that is sharp
} camera;

// A pinhole camera at `eye` that looks at `target`, with `up` upwards in the
// picture. up may have any length and may be parallel to the view. Dies when eye
// and target coincide or are not finite, and unless 0 < fov_degrees < 180
// (vertical) and focal = (height / 2) / tan(fov / 2) is a finite number.
camera camera_look_at(vec3 eye, vec3 target, vec3 up, real fov_degrees, int width, int height);

// The same, upright (up = (0, 1, 0)), by what is to be seen: `half_width` > 0 to both sides of
// the target, whatever the picture's shape.
camera camera_across(vec3 eye, vec3 target, real half_width, int width, int height);

// A uniform point (u, v) of the unit disc.
void lens_point(rng *g, real *u, real *v);

// The ray through the point (x, y) of the picture, by the camera's kind. The
// random numbers choose the point of the lens; the other kinds draw none.
ray camera_sample(const camera *cam, real x, real y, rng *g);

// The light that comes back along r. The generator belongs to this sample alone.
typedef color (*radiance)(const void *scene, ray r, rng *g);

// The loop over pixels: each pixel becomes the mean of opt->samples calls of f.
// One sample goes through the pixel's centre, several go through random points
// of the pixel. Any number of threads gives the same picture. Samples that are
// negative or not finite are counted and reported on stderr, and stay in the picture.
image render(const char *what, const camera *cam, radiance f, const void *scene,
             const options *opt);

// Exercises: exercises/02-camera/ ------------------------------------------

// The ray from the eye through the point (x, y) of the image plane, in pixels
// from the top left corner, y down; (0.5, 0.5) is the centre of the first pixel.
// O = eye; d reaches from the eye to that point, in pixels, not of unit length:
// d = (x - w/2) right + (h/2 - y) up + focal forward.
ray camera_ray(const camera *cam, real x, real y);

// All rays parallel: d = forward; O in the plane through the eye, so that the
// picture's height is cam->span units and its pixels are square.
ray orthographic_ray(const camera *cam, real x, real y);

// The pinhole ray bent by a thin lens: it starts in the point (u, v) of the
// lens, in units of lens_radius along right and up, u² + v² <= 1, and passes
// through the point where the pinhole ray meets the plane in focus, which lies
// `focus` before the eye along forward. t = 1 there.
ray thin_lens_ray(const camera *cam, real x, real y, real u, real v);

// The unit vector to the right: perpendicular to `forward` (unit) and to `up`
// (any length), along forward x up. When up says nothing, since it is zero, not
// finite or parallel to forward: any unit vector perpendicular to forward. What
// may be taken for parallel: a sine of the angle below 8 REAL_EPSILON. Never NaN,
// and in float as in double perpendicular to forward within rounding (3e-7 and
// 6e-16), however near up comes to it.
vec3 camera_right(vec3 forward, vec3 up);

#endif
