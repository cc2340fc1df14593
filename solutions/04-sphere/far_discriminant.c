#include "chapters/04-sphere/sphere.h"

real far_discriminant(sphere S, ray r) {
    const vec3 v = sub(r.O, S.c);
    const real a = dot(r.d, r.d);
    const vec3 remainder = sub(v, scale(dot(v, r.d) / a, r.d)); // perpendicular to d
    return a * (S.r * S.r - dot(remainder, remainder));
}
