// Wrong: distances above 1 are cut off.
// Expect: values above 1 are cut off
// Stage: depth
#include "solutions/homework/raytracer.h"

static void spoil(image *img) {
    for (int i = 0; i < img->width * img->height; i++) {
        color *c = &img->pixels[i];
        *c = (color){fmin(c->x, 1), fmin(c->y, 1), fmin(c->z, 1)};
    }
}
#define image_write(img, path) (spoil(img), image_write(img, path))
#include "solutions/homework/main.c"
