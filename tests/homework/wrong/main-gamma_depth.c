// Wrong: gamma 2.2 on distances.
// Expect: gamma 2.2 was applied
// Stage: depth
#include "solutions/homework/raytracer.h"

static void spoil(image *img) {
    for (int i = 0; i < img->width * img->height; i++) {
        color *c = &img->pixels[i];
        *c = (color){pow(c->x, (real)(1 / 2.2)), pow(c->y, (real)(1 / 2.2)),
                     pow(c->z, (real)(1 / 2.2))};
    }
}
#define image_write(img, path) (spoil(img), image_write(img, path))
#include "solutions/homework/main.c"
