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
//   vn x y z    a normal, of any length but 0; made unit, and kept as it is if it is unit but
//               for its rounding
//   f a b c …   a face of three or more corners, each point, point/texture, point//normal or
//               point/texture/normal; from 1, or from the last one back with -1, -2 …
//               The texture's index is ignored.
// comments (#, to the end of the line), empty lines, lines that end with LF, CR LF or CR, lines
// continued with a backslash, a byte order mark. Numbers are decimal ("-1", ".5", "5.", "+1e-5")
// and become the nearest real, in any locale.
// The points keep the file's order; those of no triangle are left out. A point that is used with
// two normals becomes two with the same coordinates: its further normals, in the order of their
// first use, make points behind the others. m->around holds them all.
// false: a line is broken, and `error` says which and why in one line "name:12: …", without a
// newline; *m is then empty. Broken are: a number that is none, is not finite or overflows real,
// a normal of length 0, an index that is 0 or out of range of what stands above it, a face of
// less than three corners, a byte 0. Without a line, "name: …": a file without any triangle,
// more than INT_MAX triangles or points, no memory. The line of a continued one is its first.
// Of the file's bytes `error` shows only printable ASCII; of a name of more than 100 bytes the
// end. Read: error is "". Free *m with mesh_free.
bool obj_parse(const char *text, size_t length, const char *name, mesh *m, obj_report *report,
               char error[OBJ_ERROR]);

// The same from the file or pipe at `path`; a missing file, a directory or one that cannot be
// read is an error too: "path: No such file or directory".
bool obj_read(const char *path, mesh *m, obj_report *report, char error[OBJ_ERROR]);

#endif
