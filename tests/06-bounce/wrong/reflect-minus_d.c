// Wrong: all of d is turned round.
// Expect: -d: all of d was turned round, not only its part along n
#include "chapters/06-bounce/bounce.h"

vec3 reflect(vec3 d, vec3 n) {
    (void)n;
    return neg(d);
}
