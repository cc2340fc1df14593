#include "chapters/06-bounce/bounce.h"

// n plus a point of the unit sphere is cosine-distributed around n. The point
// -n, which leaves no direction, is drawn again.
vec3 matte_bounce(vec3 n, rng *g) {
    for (;;) {
        const vec3 v = add(n, unit_vector(g));
        if (dot(v, v) > 64 * REAL_EPSILON * REAL_EPSILON && dot(v, n) > 0) return normalize(v);
    }
}
