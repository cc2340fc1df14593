// contest.c: see contest.h.
#include "chapters/14-octree/contest.h"

#include "chapters/06-bounce/bounce.h"

const searcher *const contestants[CONTESTANTS] = {&by_bvh_sah, &by_bvh_median, &by_bvh_midpoint,
                                                  &by_kd_tree, &by_octree,     &by_brute_force};

static const vec3 up = {0, 1, 0};

static ray_list list_of(int most) {
    return (ray_list){mesh_room(most, sizeof(ray)), 0};
}

ray_list primary_rays(const shape *s, int side) {
    const camera cam = camera_look_at(s->eye, s->target, up, 40, side, side);
    ray_list list = list_of(side * side);
    for (int i = 0; i < side * side; i++)
        list.rays[list.count++] =
            camera_ray(&cam, (real)(i % side) + (real)0.5, (real)(i / side) + (real)0.5);
    return list;
}

ray_list bounce_rays(const mesh *m, const searcher *s, const void *tree, ray_list primary) {
    ray_list list = list_of(primary.count);
    for (int i = 0; i < primary.count; i++) {
        const ray r = primary.rays[i];
        int index = 0;
        const triangle_point q = s->nearest(tree, r, 0, NO_HIT, &index, NULL);
        if (q.t == NO_HIT) continue;
        const hit h = triangle_surface(mesh_triangle(m, index), r, q);
        const vec3 n = h.front ? h.n : neg(h.n);
        rng g = rng_seed(14, (uint64_t)i);
        const vec3 d = matte_bounce(n, &g);
        list.rays[list.count++] = (ray){offset_origin(h.p, h.error, n, n), d};
    }
    return list;
}

effort spent_on(const searcher *s, const void *tree, ray_list list, int count, bool any) {
    effort spent = {0, 0};
    for (int i = 0; i < count; i++) {
        int index = 0;
        if (any)
            s->any(tree, list.rays[i], 0, NO_HIT, &spent);
        else
            s->nearest(tree, list.rays[i], 0, NO_HIT, &index, &spent);
    }
    return spent;
}

enum { TESTS_BORNE = 4000000 };
int bearable(const searcher *s, const mesh *m, int count) {
    const long few = TESTS_BORNE / (m->count + 1) + 1;
    return s != &by_brute_force || few > count ? count : (int)few;
}
