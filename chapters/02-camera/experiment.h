// experiment.h: light forwards and backwards with as many rays, and the noise of both.
#ifndef CHAPTER_EXPERIMENT_H
#define CHAPTER_EXPERIMENT_H

#include "chapters/02-camera/lamp.h"

#define LENS_RADIUS ((real)0.05) // of the program's camera, if a unit is a metre: 5 cm
#define SMALL_LENS 0.001         // 1 mm

typedef struct {
    image mean;      // the picture; image_free it
    double variance; // of a pixel's value in it; the mean over pixels and colours
    double rays_per_second;
    long rays, reached; // all, and those that reached the camera
} experiment;

// The demo lamp, width x height x samples rays in each direction; an odd number
// of samples is rounded up.
void lamp_experiment(const options *opt, experiment *forwards, experiment *backwards);

// On stdout: how many rays reached the camera, the noise, and how long forwards
// would take for the noise of backwards.
void experiment_report(const experiment *forwards, const experiment *backwards);

#endif
