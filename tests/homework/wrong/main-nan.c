// Wrong: a pixel divides 0 by 0.
// Expect: 1 pixel is not finite (NaN or infinity), the first at x 5, y 0
// Stage: depth
#include "solutions/homework/raytracer.h"

static void spoil(image *img) {
    for (int i = 0; i < img->width * img->height; i++) {
        color *c = &img->pixels[i];
        if (i == 5) c->x = (real)NAN;
    }
}
#define image_write(img, path) (spoil(img), image_write(img, path))
#include "solutions/homework/main.c"
