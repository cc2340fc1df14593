// Wrong: all is 2 % too dark.
// Expect: all light is multiplied by 0.98
// Stage: path
#include "solutions/homework/raytracer.h"

static void spoil(image *img) {
    for (int i = 0; i < img->width * img->height; i++) {
        color *c = &img->pixels[i];
        *c = scale((real)0.98, *c);
    }
}
#define image_write(img, path) (spoil(img), image_write(img, path))
#include "solutions/homework/main.c"
