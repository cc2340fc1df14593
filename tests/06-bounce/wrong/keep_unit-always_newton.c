// Wrong: one Newton step for every length, also far from 1.
// Expect: one Newton step, from a guess that was far off
#include "chapters/06-bounce/bounce.h"

vec3 keep_unit(vec3 d) {
    return scale((3 - dot(d, d)) / 2, d);
}
