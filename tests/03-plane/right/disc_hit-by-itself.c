// Right: works the plane out anew, in long double, and compares distances.
#include "chapters/03-plane/plane.h"

real disc_hit(disc D, ray r, real t_min, real t_max) {
    const vec3 n = D.P.n, x = D.P.x;
    const long double along =
        (long double)r.d.x * n.x + (long double)r.d.y * n.y + (long double)r.d.z * n.z;
    const long double above = ((long double)x.x - r.O.x) * n.x +
                              ((long double)x.y - r.O.y) * n.y +
                              ((long double)x.z - r.O.z) * n.z;
    if (along == 0 || D.radius <= 0) return NO_HIT;
    const long double t = above / along;
    const long double px = r.O.x + t * r.d.x - x.x, py = r.O.y + t * r.d.y - x.y,
                      pz = r.O.z + t * r.d.z - x.z;
    if (!(t > t_min && t < t_max) || sqrtl(px * px + py * py + pz * pz) > D.radius)
        return NO_HIT;
    return (real)t;
}
