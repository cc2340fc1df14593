// Wrong: the distance from the rounded t: good nearby, a coin's toss far away.
// Expect: The t of plane_hit is rounded to real
#include "chapters/03-plane/plane.h"

real disc_hit(disc D, ray r, real t_min, real t_max) {
    const real t = plane_hit(D.P, r, t_min, t_max);
    if (t == NO_HIT || !(D.radius > 0)) return NO_HIT;
    return length(sub(ray_at(r, t), D.P.x)) <= D.radius ? t : NO_HIT;
}
