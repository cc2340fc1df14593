// shapes.h: meshes of any size by formula, closed where the name is of a solid, triangles
// counter-clockwise from outside (the cave: from inside, where its camera is).
#ifndef CHAPTER_SHAPES_H
#define CHAPTER_SHAPES_H

#include "chapters/05-triangle/triangle.h"
#include "common/rng.h"

// Every shape fits in about a ball of radius 1 around the origin. `triangles` is how many are
// wanted, 1 to 1e8: the nearest number that the shape's construction has is taken (icosphere
// 20 k², sphereflake and sponge: whole levels or copies, never more than 1.5 times as many).
// The same number gives the same mesh, bit for bit. Free them with mesh_free.

// A sphere: each face of the icosahedron in k² triangles. Smooth normals.
mesh shape_icosphere(long triangles);

// Hills over a square: a sum of octaves of gradient noise. Smooth normals. Open at its rim.
mesh shape_hills(long triangles);

// A tube around the torus knot (2, 3). Smooth normals.
mesh shape_knot(long triangles);

// A ball with nine balls a third its size on it, and so on; each ball an icosphere.
mesh shape_sphereflake(long triangles);

// Menger's sponge: flat, axis-aligned, many triangles in one plane. Only outer faces, no two
// coincide.
mesh shape_sponge(long triangles);

// One wrinkled closed surface seen from inside: a sphere whose radius is octaves of noise, deep
// enough to hide itself. No normals (flat). shape_cave_eye is a point well inside.
mesh shape_cave(long triangles);

// A uniform cloud: small triangles of random place and orientation, that fill 1/1000 of the
// view or so whatever their number.
mesh shape_cloud(long triangles);

// The teapot in the stadium: a knot of all triangles but a few, the size of 1/500 of a hall of
// 12 large triangles around it.
mesh shape_stadium(long triangles);

// All of them, for programs, tests and measuring; the last row is {0}.
typedef struct {
    const char *name, *what;
    mesh (*make)(long triangles);
    vec3 eye, target; // a view: a camera with 40° of width there sees the shape
} shape;
extern const shape shapes[];

#endif
