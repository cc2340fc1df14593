// image.c: sRGB, PNG (through stb_image_write) and PFM, written so that a
// failure is reported and never spoils an older picture.
#define _POSIX_C_SOURCE 200809L
#include "common/image.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h> // through -isystem: its warnings are not ours

#include "common/die.h"

enum { CHANNELS = 3 };

image image_new(int width, int height) {
    const image img = {width, height, calloc((size_t)width * (size_t)height, sizeof(color))};
    if (!img.pixels) die(EXIT_RUN, "no memory for a picture of %dx%d pixels", width, height);
    return img;
}

void image_free(image *img) {
    free(img->pixels);
    *img = (image){0};
}

image image_side_by_side(image *parts, int count) {
    int width = 0;
    for (int i = 0; i < count; i++) width += parts[i].width;
    image all = image_new(width, parts[0].height);
    for (int i = 0, left = 0; i < count; i++) {
        for (int y = 0; y < all.height; y++)
            for (int x = 0; x < parts[i].width; x++)
                *image_at(&all, left + x, y) = *image_at(&parts[i], x, y);
        left += parts[i].width;
        image_free(&parts[i]);
    }
    return all;
}

int image_part_width(int width, int i, int count) {
    const int part = (i + 1) * width / count - i * width / count;
    return part > 0 ? part : 1;
}

int srgb_byte(real linear) {
    if (!(linear > 0)) return 0; // NaN too
    if (linear >= 1) return 255;
    const double c = (double)linear;
    const double encoded = c <= 0.0031308 ? 12.92 * c : 1.055 * pow(c, 1 / 2.4) - 0.055;
    return (int)(255 * encoded + 0.5);
}

real srgb_light(real encoded) {
    const double v = (double)encoded;
    return (real)(v <= 0.04045 ? v / 12.92 : pow((v + 0.055) / 1.055, 2.4));
}

// Where the bytes go, and errno of the first failure.
typedef struct {
    FILE *file;
    int error;
} sink;

static void put(void *context, void *data, int size) {
    sink *to = context;
    if (to->error) return;
    errno = 0;
    if (fwrite(data, 1, (size_t)size, to->file) == (size_t)size) return;
    to->error = errno ? errno : EIO;
}

static void encode_row(const color *row, int width, unsigned char *bytes) {
    for (int x = 0; x < width; x++) {
        const color c = is_finite(row[x]) ? row[x] : (color){1, 0, 1};
        bytes[CHANNELS * x] = (unsigned char)srgb_byte(c.x);
        bytes[CHANNELS * x + 1] = (unsigned char)srgb_byte(c.y);
        bytes[CHANNELS * x + 2] = (unsigned char)srgb_byte(c.z);
    }
}

static void put_png(const image *img, sink *to) {
    const size_t stride = CHANNELS * (size_t)img->width;
    unsigned char *bytes = malloc(stride * (size_t)img->height);
    for (int y = 0; bytes && y < img->height; y++)
        encode_row(image_at(img, 0, y), img->width, bytes + stride * (size_t)y);
    const bool encoded = bytes && stbi_write_png_to_func(put, to, img->width, img->height,
                                                         CHANNELS, bytes, (int)stride);
    if (!encoded) to->error = ENOMEM; // stb fails for nothing else
    free(bytes);
}

static void put_float(real value, sink *to) {
    const float narrow = (float)value;
    uint32_t bits;
    memcpy(&bits, &narrow, sizeof bits);
    unsigned char bytes[4]; // the little end first, whatever the machine does
    for (int i = 0; i < 4; i++) bytes[i] = (unsigned char)(bits >> 8 * i);
    put(to, bytes, sizeof bytes);
}

// Source: Debevec, PFM portable float map. A negative scale means little-endian.
static void put_pfm(const image *img, sink *to) {
    char head[64];
    put(to, head, snprintf(head, sizeof head, "PF\n%d %d\n-1.0\n", img->width, img->height));
    for (int y = img->height - 1; y >= 0; y--) {
        for (int x = 0; x < img->width; x++) {
            const color c = *image_at(img, x, y);
            put_float(c.x, to);
            put_float(c.y, to);
            put_float(c.z, to);
        }
    }
}

static bool ends_in(const char *path, const char *extension) {
    const size_t length = strlen(path), tail = strlen(extension);
    return length >= tail && strcasecmp(path + length - tail, extension) == 0;
}

// 0, or errno of what went wrong. fclose flushes: a full disk may show only there.
static int save(const image *img, const char *path, bool pfm) {
    sink to = {.file = fopen(path, "wb")};
    if (!to.file) return errno;
    (pfm ? put_pfm : put_png)(img, &to);
    if (fclose(to.file) != 0 && !to.error) to.error = errno;
    return to.error;
}

// A device or a pipe is written straight: a rename would put a file in its place.
static bool is_special(const char *path) {
    struct stat about;
    return stat(path, &about) == 0 && !S_ISREG(about.st_mode);
}

static char *temporary_name(const char *path) {
    const size_t size = strlen(path) + sizeof ".tmp" + 3 * sizeof(long);
    char *name = malloc(size);
    if (!name) die(EXIT_RUN, "no memory");
    snprintf(name, size, "%s.tmp%ld", path, (long)getpid());
    return name;
}

static long report_not_finite(const image *img, const char *path, const char *fate) {
    long count = 0;
    int first_x = 0, first_y = 0;
    for (int y = img->height - 1; y >= 0; y--) // backwards: the first is found last
        for (int x = img->width - 1; x >= 0; x--) {
            if (is_finite(*image_at(img, x, y))) continue;
            count++, first_x = x, first_y = y;
        }
    if (count)
        fprintf(stderr, "warning: %s: %ld pixel%s not finite, the first at x %d, y %d: %s\n",
                path, count, count == 1 ? " is" : "s are", first_x, first_y, fate);
    return count;
}

long image_write(const image *img, const char *path) {
    const bool pfm = ends_in(path, ".pfm");
    char *temporary = is_special(path) ? NULL : temporary_name(path);
    int error = save(img, temporary ? temporary : path, pfm);
    if (!error && temporary && rename(temporary, path) != 0) error = errno;
    if (error && temporary) remove(temporary);
    if (error) die(EXIT_RUN, "cannot write %s: %s", path, strerror(error));
    free(temporary);
    return report_not_finite(img, path, pfm ? "kept as they are" : "drawn in magenta");
}

// The surest way to know whether a file can be made is to make it.
static int try_to_create(const char *path) {
    char *temporary = temporary_name(path);
    FILE *file = fopen(temporary, "wb");
    const int error = file ? 0 : errno;
    if (file) {
        fclose(file);
        remove(temporary);
    }
    free(temporary);
    return error;
}

void image_check_path(const char *path) {
    struct stat about;
    const bool exists = stat(path, &about) == 0;
    if (exists && S_ISDIR(about.st_mode))
        die(EXIT_RUN, "cannot write %s: it is a folder", path);
    if (exists && access(path, W_OK) != 0)
        die(EXIT_RUN, "cannot write %s: %s", path, strerror(errno));
    if (is_special(path)) return; // /dev/null needs no extension and no temporary file
    if (!ends_in(path, ".png") && !ends_in(path, ".pfm"))
        die(EXIT_USAGE, "--out: expected a name that ends in .png or .pfm, got \"%s\"", path);
    const int error = try_to_create(path);
    if (!error) return;
    const char *slash = strrchr(path, '/');
    const int folder = slash ? (int)(slash - path) + 1 : 1;
    die(EXIT_RUN, "cannot write %s in folder %.*s: %s", slash ? slash + 1 : path, folder,
        slash ? path : ".", strerror(error));
}
