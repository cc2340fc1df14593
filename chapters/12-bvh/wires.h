// wires.h: the boxes of a tree, drawn as wires over its mesh.
#ifndef CHAPTER_WIRES_H
#define CHAPTER_WIRES_H

#include "chapters/12-bvh/bvh.h"

// Draws the edges of all boxes `depth` levels below the root, and of leaves above: bright where the
// eye sees them, faint where a triangle stands before them.
void wires_draw(image *img, const camera *cam, const bvh *tree, int depth, color c);

#endif
