// Wrong: blue first.
// Expect: red and blue are swapped
// Stage: mirror
#include "solutions/homework/raytracer.h"

static void spoil(image *img) {
    for (int i = 0; i < img->width * img->height; i++) {
        color *c = &img->pixels[i];
        *c = (color){c->z, c->y, c->x};
    }
}
#define image_write(img, path) (spoil(img), image_write(img, path))
#include "solutions/homework/main.c"
