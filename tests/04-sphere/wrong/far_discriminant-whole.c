// Wrong: the whole discriminant, not a quarter of it.
// Expect: b² - 4ac itself: a quarter of it is asked for
#include "chapters/04-sphere/sphere.h"

real far_discriminant(sphere S, ray r) {
    const vec3 v = sub(r.O, S.c);
    const real a = dot(r.d, r.d);
    const vec3 l = sub(v, scale(dot(v, r.d) / a, r.d));
    return 4 * a * (S.r * S.r - dot(l, l));
}
