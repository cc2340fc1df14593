// Wrong: what is negative is cut off.
// Expect: cut off to 0..1
// Stage: normal
#include "solutions/homework/raytracer.h"

static void spoil(image *img) {
    for (int i = 0; i < img->width * img->height; i++) {
        color *c = &img->pixels[i];
        *c = (color){fmax(c->x, 0), fmax(c->y, 0), fmax(c->z, 0)};
    }
}
#define image_write(img, path) (spoil(img), image_write(img, path))
#include "solutions/homework/main.c"
