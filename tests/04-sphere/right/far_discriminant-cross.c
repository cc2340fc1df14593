// Right: by Lagrange's identity a l² = |v x d|².
#include "chapters/04-sphere/sphere.h"

real far_discriminant(sphere S, ray r) {
    const vec3 w = cross(sub(r.O, S.c), r.d);
    return dot(r.d, r.d) * S.r * S.r - dot(w, w);
}
