// Wrong: the slide's loop, which ends before the last ray could reach the sky.
// Expect: out of bounces before the sky could be reached
// Expect: the last bounce was not allowed to reach the sky
// Expect: white: the sky was never asked
#include "chapters/06-bounce/bounce.h"

color trace(const scene *sc, ray r, int s, rng *g) {
    return trace_slide(sc, r, s, g);
}
