// Right: with a unit direction, and r² - l² as the product (r + l)(r - l).
#include "chapters/04-sphere/sphere.h"

real far_discriminant(sphere S, ray r) {
    const vec3 v = sub(r.O, S.c), unit = normalize(r.d);
    const real l = length(sub(v, scale(dot(v, unit), unit)));
    return dot(r.d, r.d) * (S.r + l) * (S.r - l);
}
