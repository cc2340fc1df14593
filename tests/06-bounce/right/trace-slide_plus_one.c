// Right: s bounces are s + 1 rays, and rays are what the slide's loop counts.
#include "chapters/06-bounce/bounce.h"

color trace(const scene *sc, ray r, int s, rng *g) {
    return trace_slide(sc, r, s + 1, g);
}
