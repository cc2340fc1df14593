// Right: d taken apart into the parts along n and across it.
#include "chapters/06-bounce/bounce.h"

vec3 reflect(vec3 d, vec3 n) {
    const vec3 along = scale(dot(d, n), n), across = sub(d, along);
    return sub(across, along);
}
