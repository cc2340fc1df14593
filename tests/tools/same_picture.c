// same_picture: do two PNG files show the same picture? Exit status 0 or 1.
// The files may differ (other versions of stb pack differently), and a pixel by
// one level of 255: the last bit of another system's mathematics library.
#include <stdio.h>
#include <stdlib.h>

#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#include <stb_image.h>

int main(int argc, char **argv) {
    if (argc != 3) {
        fprintf(stderr, "usage: same_picture A.png B.png\n");
        return 2;
    }
    int w[2], h[2], channels;
    unsigned char *pixels[2];
    for (int i = 0; i < 2; i++) {
        pixels[i] = stbi_load(argv[i + 1], &w[i], &h[i], &channels, 3);
        if (!pixels[i]) {
            printf("%s: cannot be read as a PNG\n", argv[i + 1]);
            return 1;
        }
    }
    if (w[0] != w[1] || h[0] != h[1]) {
        printf("%s is %d x %d, but its command draws %d x %d\n", argv[1], w[0], h[0], w[1],
               h[1]);
        return 1;
    }
    long differ = 0;
    int worst = 0;
    for (long i = 0; i < 3L * w[0] * h[0]; i++) {
        const int by = abs(pixels[0][i] - pixels[1][i]);
        differ += by > 1;
        worst = by > worst ? by : worst;
    }
    if (differ > 0)
        printf("%s differs from what its command draws: in %ld of %ld values, by %d of 255 at "
               "most\n",
               argv[1], differ, 3L * w[0] * h[0], worst);
    return differ > 0;
}
