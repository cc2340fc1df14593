#include "chapters/06-bounce/bounce.h"

vec3 reflect(vec3 d, vec3 n) {
    return sub(d, scale(2 * dot(d, n), n));
}
