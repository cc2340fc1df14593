// image.h: a picture in linear light, and writing it to a file.
#ifndef COMMON_IMAGE_H
#define COMMON_IMAGE_H

#include "common/vec3.h"

typedef struct {
    int width, height;
    color *pixels; // row by row from the top left; linear
} image;

// A black picture; dies when there is no memory. Free it with image_free.
image image_new(int width, int height);
void image_free(image *img);

static inline color *image_at(const image *img, int x, int y) {
    return &img->pixels[(size_t)y * (size_t)img->width + (size_t)x];
}

// Pictures of one height in one, from left to right. Frees them.
image image_side_by_side(image *parts, int count);

// The width of part i of count that fill `width` together, each at least 1 wide.
int image_part_width(int width, int i, int count);

// [0, 1] linear to [0, 255] sRGB (IEC 61966-2-1), clamped, rounded to nearest.
int srgb_byte(real linear);

// The other way: an sRGB value in [0, 1] to linear light.
real srgb_light(real encoded);

// Writes `path`: .png (clamped, sRGB) or .pfm (linear 32-bit float, rows from
// the bottom up). Written to a temporary file beside it and renamed, so a
// failure leaves an older picture whole. Dies with the reason when it cannot
// write. Values that are not finite are counted, reported on stderr and drawn
// in magenta (a .pfm keeps them): never hidden. Returns how many pixels were not
// finite. A device or pipe (/dev/null) is written straight, as PNG by default.
long image_write(const image *img, const char *path);

// Dies with EXIT_USAGE when `path` ends in neither .png nor .pfm (devices and
// pipes may), and with EXIT_RUN when it is a folder or cannot be written: before
// a long rendering, not after.
void image_check_path(const char *path);

#endif
