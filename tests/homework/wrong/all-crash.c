// Wrong: writes through a bad pointer.
// Expect: crashed: bad pointer
// Stage: depth
#include "solutions/homework/raytracer.h"

int main(void) {
    volatile int *volatile nowhere = NULL;
    *nowhere = 1;
}
