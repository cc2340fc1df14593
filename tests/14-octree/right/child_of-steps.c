// Right: by three questions.
#include "chapters/14-octree/octree.h"

int child_of(vec3 p, vec3 middle) {
    int child = 0;
    if (!(p.x < middle.x)) child += 1;
    if (!(p.y < middle.y)) child += 2;
    if (!(p.z < middle.z)) child += 4;
    return child;
}
