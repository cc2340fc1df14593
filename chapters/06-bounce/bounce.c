// bounce.c: see bounce.h. The derivations are in README.md.
#include "chapters/06-bounce/bounce.h"

color clear_sky(vec3 d) {
    const real height = d.y / length(d); // -1 straight down, 1 straight up
    return lerp((color){1, 1, 1}, (color){(real)0.35, (real)0.6, 1}, fmax(height, 0));
}

hit scene_hit(const scene *sc, ray r, real t_min, real t_max, const material **m) {
    hit nearest = {.t = NO_HIT};
    int sphere_index = -1, plane_index = -1, mesh_index = -1, triangle_index = -1;
    triangle_point on_triangle = {NO_HIT, 0, 0};
    for (int i = 0; i < sc->sphere_count; i++) {
        const real t = sphere_hit(sc->spheres[i], r, t_min, t_max);
        if (t < t_max) t_max = t, sphere_index = i;
    }
    for (int i = 0; i < sc->plane_count; i++) {
        const real t = plane_hit(sc->planes[i], r, t_min, t_max);
        if (t < t_max) t_max = t, plane_index = i;
    }
    for (int i = 0; i < sc->mesh_count; i++) {
        const triangle_point q = mesh_hit(&sc->meshes[i], r, t_min, t_max, &triangle_index);
        if (q.t < t_max) t_max = q.t, mesh_index = i, on_triangle = q;
    }
    if (mesh_index >= 0) {
        *m = &sc->mesh_materials[mesh_index];
        return triangle_surface(mesh_triangle(&sc->meshes[mesh_index], triangle_index), r,
                                on_triangle);
    }
    if (plane_index >= 0) {
        *m = &sc->plane_materials[plane_index];
        return plane_surface(sc->planes[plane_index], r, t_max);
    }
    if (sphere_index >= 0) {
        *m = &sc->sphere_materials[sphere_index];
        return sphere_surface(sc->spheres[sphere_index], r, t_max);
    }
    return nearest;
}

color albedo_at(const material *m, vec3 p) {
    return m->checkered && checks(p.x, p.z) ? m->albedo_2 : m->albedo;
}

vec3 unit_vector(rng *g) {
    real a, b, s;
    do {
        a = 2 * rng_real(g) - 1;
        b = 2 * rng_real(g) - 1;
        s = a * a + b * b;
    } while (s >= 1);
    const real k = 2 * sqrt(1 - s);
    return (vec3){k * a, k * b, 1 - 2 * s};
}

real start_t_min(start_rule start) {
    return start == START_EPSILON ? (real)1e-4 : 0;
}

ray bounce(const scene *sc, const material *m, ray r, hit h, rng *g) {
    const vec3 n = h.front ? h.n : neg(h.n);
    const vec3 d = m->finish == MATTE   ? matte_bounce(n, g)
                   : m->finish == FUZZY ? fuzzy_bounce(r.d, n, m->fuzz, g)
                                        : reflect(r.d, n);
    return (ray){sc->start == START_BOUND ? offset_origin(h.p, h.error, n, d) : h.p, d};
}

color trace_slide(const scene *sc, ray r, int s, rng *g) {
    color C = {1, 1, 1};
    real t_min = 0;
    while (s > 0) {
        const material *m = NULL;
        const hit h = scene_hit(sc, r, t_min, NO_HIT, &m);
        if (h.t == NO_HIT) {
            C = mul(C, sc->sky(r.d));
            break;
        }
        r = bounce(sc, m, r, h, g);
        C = mul(C, albedo_at(m, h.p));
        t_min = start_t_min(sc->start);
        s = s - 1;
        if (s == 0) C = (color){0, 0, 0};
    }
    return C;
}
