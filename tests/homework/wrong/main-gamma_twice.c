// Wrong: gamma, and once more.
// Expect: gamma was applied, and twice
// Stage: path
#include "solutions/homework/raytracer.h"

static void spoil(image *img) {
    for (int i = 0; i < img->width * img->height; i++) {
        color *c = &img->pixels[i];
        *c = (color){pow(c->x, (real)0.2066), pow(c->y, (real)0.2066), pow(c->z, (real)0.2066)};
    }
}
#define image_write(img, path) (spoil(img), image_write(img, path))
#include "solutions/homework/main.c"
