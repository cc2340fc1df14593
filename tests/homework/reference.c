// reference.c: makes reference.pfm from many pictures by the solution: make homework-reference.
//
//     reference OUT LAYER.. where a layer is a file, or several joined by commas (their mean is
//     taken), with "-file" at its end for what is to be subtracted
//
// Every picture is reduced to the means of blocks; the layers stand one below the other.
#include "common/die.h"
#include "tests/homework/homework.h"

#include <stdlib.h>
#include <string.h>

static void add_file(const char *path, double factor, blocks sum) {
    static float values[HEIGHT][WIDTH][CHANNELS];
    const char *reason = pfm_read(path, WIDTH, HEIGHT, &values[0][0][0]);
    if (reason) die(EXIT_RUN, "%s: %s", path, reason);
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++)
            for (int c = 0; c < CHANNELS; c++)
                sum[y / BLOCK * ACROSS + x / BLOCK][c] +=
                    factor * (double)values[y][x][c] / (BLOCK * BLOCK);
}

static void add_layer(char *files, blocks sum) {
    char *minus = strstr(files, ",-");
    if (minus) {
        add_file(minus + 2, -1, sum);
        *minus = '\0';
    }
    int count = 1;
    for (const char *c = files; *c; c++) count += *c == ',';
    for (char *file = strtok(files, ","); file; file = strtok(NULL, ","))
        add_file(file, 1.0 / count, sum);
}

int main(int argc, char **argv) {
    if (argc != 2 + LAYERS) die(EXIT_USAGE, "expected a file to write and %d layers", LAYERS);
    image all = image_new(ACROSS, LAYERS * DOWN);
    for (int layer = 0; layer < LAYERS; layer++) {
        blocks sum = {{0}};
        add_layer(argv[2 + layer], sum);
        for (int b = 0; b < BLOCKS; b++)
            all.pixels[layer * BLOCKS + b] =
                (color){(real)sum[b][0], (real)sum[b][1], (real)sum[b][2]};
    }
    image_write(&all, argv[1]);
    image_free(&all);
}
