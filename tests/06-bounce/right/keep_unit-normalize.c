// Right: always a root and a division; only slower.
#include "chapters/06-bounce/bounce.h"

vec3 keep_unit(vec3 d) {
    return normalize(d);
}
