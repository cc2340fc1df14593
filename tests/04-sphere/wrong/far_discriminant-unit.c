// Wrong: takes d for a unit vector.
// Expect: a remainder that takes d for a unit vector
#include "chapters/04-sphere/sphere.h"

real far_discriminant(sphere S, ray r) {
    const vec3 v = sub(r.O, S.c);
    const vec3 l = sub(v, scale(dot(v, r.d), r.d));
    return dot(r.d, r.d) * (S.r * S.r - dot(l, l));
}
