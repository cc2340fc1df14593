// Wrong: a scale of 1.0, and yet the little end first.
// Expect: a scale of 1.0 says big end first, write -1.0
// Stage: depth
#include "solutions/homework/raytracer.h"

#include <stdio.h>
#include <string.h>

static void change_sign(const char *path) {
    FILE *f = fopen(path, "r+b");
    if (!f) return;
    fseek(f, (long)strlen("PF\n128 96\n"), SEEK_SET);
    fputc('+', f);
    fclose(f);
}
#define image_write(img, path) (image_write(img, path), change_sign(path))
#include "solutions/homework/main.c"
