// shapes.h: meshes of any size by formula. Triangles are counter-clockwise seen from outside;
// from inside where the camera is inside.
#ifndef CHAPTER_SHAPES_H
#define CHAPTER_SHAPES_H

#include "chapters/05-triangle/triangle.h"
#include "common/rng.h"

// Every shape lies in the ball of radius 1 around the origin. `triangles` is how many are wanted,
// 1 to 1e8. As many are made as the construction allows that is named with each: the nearest
// such number, at most 1.6 times as many and at least 0.4 times, or the smallest. The same
// number gives the same mesh, bit for bit. Closed: the triangles share their points, and on
// every edge there are two, which go along it in opposite directions. Where no normals are
// mentioned the mesh is flat. Dies when there is no memory. Free them with mesh_free.

// A sphere of radius 1: each face of the icosahedron in k², 20 k² in all. Smooth normals. Closed.
mesh shape_icosphere(long triangles);

// Hills over the square |x|, |z| <= 0.7: a sum of octaves of gradient noise; y is up. 2 k²
// triangles. Smooth normals. Open at its rim.
mesh shape_hills(long triangles);

// A tube of radius 0.17 around the knot
//   ((0.55 + 0.28 cos 3t) cos 2t, (0.55 + 0.28 cos 3t) sin 2t, 0.28 sin 3t),
// a grid of 12 x 3 squares at least. Smooth normals. Closed.
mesh shape_knot(long triangles);

// A ball with nine balls a third its size on it, and so on; each an icosphere, with triangles
// about as large as on the others. Smooth normals. Closed, each ball by itself.
mesh shape_sphereflake(long triangles);

// Menger's sponge, a cube of side 1: flat, axis-aligned, many triangles in one plane. Of level l
// it has 2 20^l + 4 8^l squares, each cut in k² and these in two triangles: l is the largest
// without more than 1.5 times what is wanted. Closed: no face lies between two of its cubes.
mesh shape_sponge(long triangles);

// A cave, to be seen from inside, from the origin for one: a sphere with wrinkles of five sizes
// that overhang and hide one another. 20 k² triangles: of a million 98 % have between a sixth and
// eight times the area of the middle one. Closed; encloses 4/3 π 0.62³ but for what the triangles cut off.
mesh shape_cave(long triangles);

// A cloud: equilateral triangles of random place (uniform in a ball) and orientation, in any
// number n; their corners are 1 / (1 + √n) from their centres, so that about a quarter of the
// rays through the middle hit one, whatever n.
mesh shape_cloud(long triangles);

// The teapot in the stadium: a knot a thousandth the size of shape_knot's around the origin, on
// the floor of a hall about 1 wide, seen from inside, of 12 large triangles: the last ones.
// Closed, both.
mesh shape_stadium(long triangles);

// All of them, for programs, tests and measuring; the last row is {0}.
typedef struct {
    const char *name, *what;
    mesh (*make)(long triangles);
    vec3 eye, target; // a camera there that is 40° wide and upright sees the shape
} shape;
extern const shape shapes[];

#endif
