// Right: n plus a random unit vector, as in chapter 06.
#include "chapters/10-importance-sampling/importance.h"

vec3 cosine_direction(vec3 n, rng *g) {
    return matte_bounce(n, g);
}
