// box.h: the room that chapters 09 to 11 draw: two balls between coloured walls, under
// a square lamp. The room is 2 wide and high, from (-1, 0) to (1, 2) in x and y.
#ifndef CHAPTER_BOX_H
#define CHAPTER_BOX_H

#include "chapters/09-path-tracer/path.h"

enum { // the bodies, as scene_nearest numbers them
    BALL_LEFT,
    BALL_RIGHT,
    WALL_LEFT,
    WALL_RIGHT,
    WALL_FLOOR,
    WALL_CEILING,
    WALL_BACK,
    WALL_FRONT, // behind the camera, black: it ends the paths that leave the picture
    LAMP,
    BOX_BODIES
};

extern const scene box_bodies;
extern const matte box_surfaces[BOX_BODIES];

// From within the room, through its whole width.
camera box_camera(int width, int height);

#endif
