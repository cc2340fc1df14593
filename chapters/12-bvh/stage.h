// stage.h: a mesh with its tree, a lamp and a floor, and a camera that sees it all.
#ifndef CHAPTER_STAGE_H
#define CHAPTER_STAGE_H

#include "chapters/10-importance-sampling/importance.h"
#include "chapters/12-bvh/bvh.h"

// What a mesh is set up with; lengths in the mesh's own units.
typedef struct {
    surface mesh, floor;
    bool inside; // the eye is in it: no floor, no sky
    sphere lamp;
    real radiance; // the lamp's
    vec3 eye, target;
    real fov; // degrees, vertical
} setting;

// One of shapes.h, of the size that the pictures have; NULL: there is none of that name.
typedef struct {
    const char *name;
    mesh (*make)(long triangles);
    long triangles;
    setting how;
} exhibit;
const exhibit *exhibit_named(const char *name);

// The box of all points of the mesh that triangles use.
aabb mesh_box(const mesh *m);

// For any mesh: a camera that sees its box from the front, right and above, the lamp behind the
// left shoulder, all by the size of the box.
setting setting_around(aabb box, int width, int height);

// Everything that light_trace needs. Made in its place, since its parts point at each other; free it
// with stage_free (mesh and tree are the caller's).
enum { STAGE_BODIES = 3 };
typedef struct {
    mesh m;
    finder by_tree;
    plane floor;
    setting how;
    surface surfaces[STAGE_BODIES];
    lit_room room;
} stage;
void stage_set(stage *s, const mesh *m, const bvh *tree, setting how);
void stage_free(stage *s);

// What a ray has cost, as a colour: black for at most `black` steps, then purple, blue, green, yellow,
// red and white, from one to the next twice as many.
color heat(long steps, long black);

#endif
