// obj.h: a mesh from a file. Wavefront OBJ: points, normals and faces; all else is skipped.
#ifndef CHAPTER_OBJ_H
#define CHAPTER_OBJ_H

#include "chapters/05-triangle/triangle.h"

// What the file held besides its triangles.
typedef struct {
    long polygons;   // faces of more than three corners, cut into fans from their first corner
    long degenerate; // triangles without area, left out
    long bare;       // corners without a normal where others have one: all is then flat
    long skipped;    // lines not about shape: groups, materials, texture coordinates
} obj_report;

enum { OBJ_ERROR = 256 };

// Reads `length` bytes of text; `name` is the file's, for messages. Understands
//   v x y z     a point; more numbers (weight, colour) are ignored
//   vn x y z    a normal, of any length but 0; kept unit
//   f a b c …   a face of three or more corners, each point, point/texture, point//normal or
//               point/texture/normal; from 1, or from the last one back with -1, -2 …
// comments (#), empty lines, CR LF, lines continued with a backslash. A point that is used
// with two normals becomes two points with the same coordinates.
// false: a line is broken, and `error` says which and why in one line "name:12: …", without a
// newline; *m is then empty. Broken are: a number that is none, is not finite or overflows real,
// a normal of length 0, an index that is 0 or out of range of what stands above it, a face of
// less than three corners, a file without any triangle, more than INT_MAX triangles, no memory.
// Free *m with mesh_free.
bool obj_parse(const char *text, size_t length, const char *name, mesh *m, obj_report *report,
               char error[OBJ_ERROR]);

// The same from the file at `path`; a missing file, a directory or one that cannot be read is
// an error too: "path: No such file or directory".
bool obj_read(const char *path, mesh *m, obj_report *report, char error[OBJ_ERROR]);

#endif
