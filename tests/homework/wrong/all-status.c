// Wrong: ends with exit status 3.
// Expect: ended with exit status 3
// Stage: depth
#include "solutions/homework/raytracer.h"

int main(void) {
    return 3;
}
