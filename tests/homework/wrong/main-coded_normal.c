// Wrong: the normals are made colours.
// Expect: coded as 0.5 n + 0.5
// Stage: normal
#include "solutions/homework/raytracer.h"

static void spoil(image *img) {
    for (int i = 0; i < img->width * img->height; i++) {
        color *c = &img->pixels[i];
        *c = scale((real)0.5, add(*c, (vec3){1, 1, 1}));
    }
}
#define image_write(img, path) (spoil(img), image_write(img, path))
#include "solutions/homework/main.c"
