// Wrong: float throughout: seven digits are not enough at grazing angles.
// Expect: Work out both dot products in double
#include "chapters/03-plane/plane.h"

real plane_hit(plane P, ray r, real t_min, real t_max) {
    const float along =
        (float)r.d.x * (float)P.n.x + (float)r.d.y * (float)P.n.y + (float)r.d.z * (float)P.n.z;
    if (along == 0) return NO_HIT;
    const vec3 to = sub(P.x, r.O);
    const float above =
        (float)to.x * (float)P.n.x + (float)to.y * (float)P.n.y + (float)to.z * (float)P.n.z;
    const real t = above / along;
    return t > t_min && t < t_max ? t : NO_HIT;
}
