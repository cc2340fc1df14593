// frame.c: directions in the frame of a normal, and back. It calls nothing of this chapter.
#include "chapters/10-importance-sampling/importance.h"

// copysign keeps the division away from 1 + n.z = 0.
frame orthonormal_basis(vec3 n) {
    const real sign = copysign((real)1, n.z);
    const real a = -1 / (sign + n.z), b = n.x * n.y * a;
    return (frame){
        {1 + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}, n};
}

vec3 to_local(frame f, vec3 v) {
    return (vec3){dot(v, f.s), dot(v, f.t), dot(v, f.n)};
}

vec3 to_world(frame f, vec3 v) {
    return add(add(scale(v.x, f.s), scale(v.y, f.t)), scale(v.z, f.n));
}
