// pfm.c: reads a PFM and says exactly what is wrong with one; draws differences.
// Source: Debevec, PFM portable float map: "PF", width height, scale, and then rows from the
// bottom up of red, green, blue as 32-bit floats; a negative scale: little end first.
#include "tests/homework/homework.h"

#include <stdio.h>
#include <string.h>

static const char *not_pfm(const char *magic) {
    if (memcmp(magic, "\x89P", 2) == 0) return "a PNG file: a PFM is asked for";
    if (memcmp(magic, "P6", 2) == 0 || memcmp(magic, "P3", 2) == 0)
        return "a PPM file: a PFM is asked for, with floats";
    if (memcmp(magic, "Pf", 2) == 0) return "a grey PFM (Pf): colour (PF) is asked for";
    return "not a PFM: the file does not begin with PF";
}

static float float_of(const unsigned char *bytes, bool little) {
    uint32_t bits = 0;
    for (int i = 0; i < 4; i++) bits |= (uint32_t)bytes[little ? i : 3 - i] << 8 * i;
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

// As light, distances and normals are.
static bool is_sane(float v) {
    return fabsf(v) > 1e-5f && fabsf(v) < 1e5f;
}

// What remains in the file, at most `size` bytes and one.
static size_t rest(FILE *f, unsigned char *bytes, size_t size) {
    const size_t n = fread(bytes, 1, size, f);
    return n == size && fgetc(f) != EOF ? n + 1 : n;
}

static const char *read_open(FILE *f, int width, int height, float *values) {
    static unsigned char bytes[4 * 128 * 1024 * CHANNELS];
    char magic[2] = {0};
    int w = 0, h = 0;
    double scale = 0;
    if (fread(magic, 1, 2, f) != 2) return "the file is empty";
    if (memcmp(magic, "PF", 2) != 0) return not_pfm(magic);
    if (fscanf(f, "%d %d %lf", &w, &h, &scale) != 3 || scale == 0)
        return "not a PFM: after PF come width, height and -1.0, as text";
    if (w != width || h != height)
        return text_kept("the picture has %dx%d pixels: %dx%d are asked for", w, h, width,
                         height);
    fgetc(f); // the one white space character after the scale
    const size_t count = (size_t)(width * height * CHANNELS), got = rest(f, bytes, 4 * count);
    if (got < 4 * count)
        return text_kept("the file ends too soon: %zu bytes of pixels, not %zu", got,
                         4 * count);
    if (got > 4 * count)
        return "the file is too long: are the numbers 32-bit floats, three a pixel?";
    size_t shown = 0, sane = 0, sane_swapped = 0;
    for (size_t i = 0; i < count; i++) {
        const size_t row = i / (size_t)(width * CHANNELS),
                     column = i % (size_t)(width * CHANNELS);
        const float v = float_of(bytes + 4 * i, scale < 0),
                    u = float_of(bytes + 4 * i, scale > 0);
        shown += v != 0, sane += v != 0 && is_sane(v), sane_swapped += v != 0 && is_sane(u);
        values[((size_t)height - 1 - row) * (size_t)(width * CHANNELS) + column] = v;
    }
    // Of random bits an eighth is sane.
    if (2 * sane < shown && 10 * sane_swapped > 9 * shown)
        return scale > 0
                   ? "the bytes of the floats are the other way round: a scale of 1.0 says "
                     "big end first, write -1.0"
                   : "the bytes of the floats are the other way round: a scale of -1.0 "
                     "says little end first";
    return NULL;
}

const char *pfm_read(const char *path, int width, int height, float *values) {
    FILE *f = fopen(path, "rb");
    if (!f) return "no picture was written: the second argument is the file's name";
    const char *reason = read_open(f, width, height, values);
    fclose(f);
    return reason;
}

// ---- the picture of the difference ------------------------------------------------------

enum { SHOWN_WIDTH = 256 };

static color signed_color(double s) {
    const double v = fmin(fmax(s, -1), 1), grey = 0.2;
    if (v > 0)
        return (color){(real)(grey + 0.8 * v), (real)(grey - grey * v),
                       (real)(grey - grey * v)};
    return (color){(real)(grey + grey * v), (real)(grey + grey * v), (real)(grey - 0.8 * v)};
}

static color shown_color(const double *v, double offset, double factor) {
    return (color){(real)(factor * (v[0] + offset)), (real)(factor * (v[1] + offset)),
                   (real)(factor * (v[2] + offset))};
}

// Magenta: no value for a picture.
static color shown_or_magenta(const double *v, double offset, double factor) {
    const bool finite = isfinite(v[0]) && isfinite(v[1]) && isfinite(v[2]);
    const bool negative = offset == 0 && (v[0] < 0 || v[1] < 0 || v[2] < 0);
    return finite && !negative ? shown_color(v, offset, factor) : (color){1, 0, 1};
}

static double worst_difference(const double *a, const double *b) {
    double worst = 0;
    for (int c = 0; c < CHANNELS; c++)
        if (fabs(a[c] - b[c]) > fabs(worst)) worst = a[c] - b[c];
    return worst;
}

void draw_difference(const char *name, const picture *yours, int width, int height,
                     const double *means, const double *right, double full, double offset,
                     double shown) {
    const int zoom = SHOWN_WIDTH / width, w = zoom * width, h = zoom * height;
    image parts[] = {image_new(w, h), image_new(w, h), image_new(w, h)};
    for (int y = 0; y < h; y++)
        for (int x = 0; x < w; x++) {
            const int i = CHANNELS * (y / zoom * width + x / zoom);
            const double *v = yours->at[y * HEIGHT / h][x * WIDTH / w];
            const color mine = shown_or_magenta(v, offset, shown);
            const bool bad = mine.x == 1 && mine.y == 0 && mine.z == 1;
            *image_at(&parts[0], x, y) = mine;
            *image_at(&parts[1], x, y) = shown_color(right + i, offset, shown);
            *image_at(&parts[2], x, y) =
                bad ? mine : signed_color(worst_difference(means + i, right + i) / full);
        }
    image all = image_side_by_side(parts, COUNT(parts));
    char path[4096];
    snprintf(path, sizeof path, "%s/%s.png", program_folder(), name);
    image_write(&all, path);
    image_free(&all);
}
