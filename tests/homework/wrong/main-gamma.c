// Wrong: the sRGB curve on linear light.
// Expect: the sRGB curve (gamma) was applied
// Stage: path
#include "solutions/homework/raytracer.h"

static real encode(real v) {
    return v <= (real)0.0031308 ? (real)12.92 * v
                                : (real)1.055 * pow(v, (real)(1 / 2.4)) - (real)0.055;
}

static void spoil(image *img) {
    for (int i = 0; i < img->width * img->height; i++) {
        color *c = &img->pixels[i];
        *c = (color){encode(c->x), encode(c->y), encode(c->z)};
    }
}
#define image_write(img, path) (spoil(img), image_write(img, path))
#include "solutions/homework/main.c"
