// Right: a direction below the surface is mirrored in it.
#include "chapters/09-path-tracer/path.h"

vec3 hemisphere_direction(vec3 n, rng *g) {
    const vec3 v = unit_vector(g);
    if (dot(v, n) >= 0) return v;
    const vec3 up = normalize(reflect(v, n));
    return dot(up, n) < 0 ? n : up;
}
