// Wrong: the slide's discriminant, a difference of large numbers.
// Expect: wrong decisions far away
// Expect: Do not subtract large numbers
#include "chapters/04-sphere/sphere.h"

real far_discriminant(sphere S, ray r) {
    const vec3 v = sub(r.O, S.c);
    const real a = dot(r.d, r.d), half_b = dot(v, r.d), c = dot(v, v) - S.r * S.r;
    return half_b * half_b - a * c;
}
