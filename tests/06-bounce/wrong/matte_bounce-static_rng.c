// Wrong: a generator that lives from call to call: every run of the threads is another picture.
// Expect: numbers that do not come from g
#include "chapters/06-bounce/bounce.h"

vec3 matte_bounce(vec3 n, rng *g) {
    static rng own = {1, 3};
    (void)g;
    for (;;) {
        const vec3 v = add(n, unit_vector(&own));
        if (dot(v, v) > (real)1e-6 && dot(v, n) > 0) return normalize(v);
    }
}
