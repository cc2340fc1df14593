// glass_bounce: reflected or refracted? The task is in README.md.
#include "chapters/11-fresnel/fresnel.h"
#include "common/todo.h"

vec3 glass_bounce(vec3 d, vec3 n, real eta, rng *g) {
    TODO("glass_bounce"); // your answer instead of these two lines
    return d;
}
