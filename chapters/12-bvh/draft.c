// draft.c: see draft.h.
#include "chapters/12-bvh/draft.h"

#include <limits.h>

#include "common/die.h"

draft draft_new(long points, long triangles, bool smooth) {
    if (points > INT_MAX || triangles > INT_MAX)
        die(EXIT_USAGE, "a mesh of %ld triangles has too many to be counted", triangles);
    return (draft){.points = mesh_room(points, sizeof(vec3)),
                   .normals = smooth ? mesh_room(points, sizeof(vec3)) : NULL,
                   .corners = mesh_room(triangles, sizeof(int[3]))};
}

int draft_side(double n) {
    const double k = floor(sqrt(n)), below = n - k * k, above = (k + 1) * (k + 1) - n;
    return (int)fmax(1, below <= above ? k : k + 1);
}

mesh draft_done(draft d) {
    double rr = 0;
    for (int i = 0; i < d.made; i++) {
        const wide3 p = widen(d.points[i]);
        rr = fmax(rr, wide_dot(p, p));
    }
    return (mesh){.points = d.points,
                  .normals = d.normals,
                  .corners = (const int(*)[3])d.corners,
                  .count = d.count,
                  .around.r = (real)(sqrt(rr) * (1 + 2 * REAL_EPSILON))}; // not rounded inwards
}
