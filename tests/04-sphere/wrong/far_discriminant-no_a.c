// Wrong: r² - l² alone, right only for d of unit length.
// Expect: r² - l² without the factor a = d·d
#include "chapters/04-sphere/sphere.h"

real far_discriminant(sphere S, ray r) {
    const vec3 v = sub(r.O, S.c);
    const vec3 l = sub(v, scale(dot(v, r.d) / dot(r.d, r.d), r.d));
    return S.r * S.r - dot(l, l);
}
