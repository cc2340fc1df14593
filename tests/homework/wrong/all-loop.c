// Wrong: never ends.
// Expect: endless loop? stopped after
// Stage: depth
// Seconds: 1
#include "solutions/homework/raytracer.h"

int main(void) {
    for (volatile int i = 0;; i = !i) {
    }
}
