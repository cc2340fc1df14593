// lamp.h: the lecture's question as an experiment. A square lamp shines down on a
// matte checkered floor; light is followed from the lamp to the camera, and from
// the camera to the lamp.
#ifndef CHAPTER_LAMP_H
#define CHAPTER_LAMP_H

#include "chapters/02-camera/camera.h"

// The floor is y = 0; the lamp faces it. Nothing else is there: the camera casts
// no shadow, and lies below the lamp and looks down, so that it never sees it.
typedef struct {
    vec3 centre;   // of the lamp
    real side;     // of its square, parallel to x and z
    real radiance; // of its lower face, the same in all directions
} lamp;

extern const lamp demo_lamp;

// The camera of the experiment, with a lens of this radius.
camera lamp_camera(int width, int height, real lens_radius);

// Backwards, for render(): the light from the lamp that the floor sends back along
// r, for one random point of the lamp. `scene` is a lamp.
color lamp_backwards(const void *scene, ray r, rng *g);

// Forwards: `rays` rays leave the lamp, meet the floor, are scattered by it, and
// count when they pass the lens and land in the picture. The same expected value
// in every pixel as lamp_backwards. *reached: how many landed. The picture is
// the same for any number of threads. A lens of radius 0 has no area: no ray passes.
image lamp_forwards(const char *what, const camera *cam, const lamp *l, long rays,
                    uint64_t seed, long *reached);

#endif
