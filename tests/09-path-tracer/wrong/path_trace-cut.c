// Wrong: the slide's recursion, cut after 10 bounces, in place of roulette.
// Expect: a closed room, to the end
#include "chapters/09-path-tracer/path.h"

color path_trace(const room *sc, ray r, int s, rng *g) {
    return trace_ray(sc, r, s < 4 ? s : 4, g);
}
