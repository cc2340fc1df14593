// Right: is there a nearest one?.
#include "chapters/12-bvh/bvh.h"

bool bvh_any(const bvh *b, ray r, real t_min, real t_max, effort *spent) {
    int index;
    return bvh_nearest(b, r, t_min, t_max, &index, spent).t != NO_HIT;
}
