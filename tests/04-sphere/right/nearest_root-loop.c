// Right: by search, the larger root first, so that the smaller one wins.
#include "chapters/04-sphere/sphere.h"

real nearest_root(roots q, real t_min, real t_max) {
    const double all[] = {q.t1, q.t0};
    real nearest = NO_HIT;
    for (int i = 2 - (q.count > 0 ? 2 : 0); i < 2; i++) {
        const real t = (real)all[i];
        if (t > t_min && t < t_max) nearest = t;
    }
    return nearest;
}
