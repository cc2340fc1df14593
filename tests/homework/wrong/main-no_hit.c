// Wrong: -1 where nothing is hit.
// Expect: a sign for "no hit" is left in the picture
// Stage: depth
#include "solutions/homework/raytracer.h"

static void spoil(image *img) {
    for (int i = 0; i < img->width * img->height; i++) {
        color *c = &img->pixels[i];
        if (c->x == 0) *c = (color){-1, -1, -1};
    }
}
#define image_write(img, path) (spoil(img), image_write(img, path))
#include "solutions/homework/main.c"
