// Wrong: the file ends too soon.
// Expect: the file ends too soon: 1000 bytes
// Stage: depth
#define _XOPEN_SOURCE 700 // truncate
#include "solutions/homework/raytracer.h"

#include <stdlib.h>
#include <unistd.h>

#define image_write(img, path) (image_write(img, path), keep_some(path))
static void keep_some(const char *path) {
    if (truncate(path, sizeof "PF\n128 96\n-1.0\n" - 1 + 1000) != 0) _Exit(9);
}
#include "solutions/homework/main.c"
