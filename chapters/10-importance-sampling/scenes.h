// scenes.h: what chapter 10 draws and measures.
#ifndef CHAPTER_SCENES_H
#define CHAPTER_SCENES_H

#include "chapters/09-path-tracer/box.h"
#include "chapters/10-importance-sampling/importance.h"

// The surfaces of chapter 09's room: all matte for alpha = 0; else the left ball is of a
// metal with this roughness.
void fill_box_surfaces(surface surfaces[BOX_BODIES], real alpha);

// The scene by Veach: four metal plates, the nearest the roughest, each turned so that it
// mirrors four round lamps of different sizes and equal power into the camera.
enum { PLATES = 4, ROUND_LAMPS = 4, PLATE_WALLS = 2 };
typedef struct {
    sphere balls[ROUND_LAMPS];
    plane walls[PLATE_WALLS];
    vec3 points[PLATES][4];
    mesh plates[PLATES];
    surface surfaces[ROUND_LAMPS + PLATE_WALLS + PLATES];
} veach_plates;
scene veach_build(veach_plates *v);
camera veach_camera(int width, int height);

// Metal balls from nearly smooth to rough, on a floor, under a lamp and the clear sky.
enum { ROW = 6 };
extern const scene row_bodies;
extern const surface row_surfaces[];
camera row_camera(int width, int height);

#endif
