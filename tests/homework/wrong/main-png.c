// Wrong: a PNG.
// Expect: a PNG file: a PFM is asked for
// Stage: depth
#include "solutions/homework/raytracer.h"

#include <stdio.h>
#include <string.h>

static long as_png(const image *img, const char *path) {
    char other[100];
    snprintf(other, sizeof other, "%s.png", path);
    const long count = image_write(img, other);
    rename(other, path);
    return count;
}
#define image_write(img, path) as_png(img, path)
#include "solutions/homework/main.c"
