// Right: a direction below the surface is drawn again.
#include "chapters/09-path-tracer/path.h"

vec3 hemisphere_direction(vec3 n, rng *g) {
    vec3 v;
    do v = unit_vector(g);
    while (dot(v, n) < 0);
    return v;
}
