// lamps.c: what shines, and directions towards it.
#include <stdlib.h>

#include "chapters/10-importance-sampling/importance.h"
#include "common/die.h"

static void *memory(size_t count, size_t size) {
    void *p = calloc(count + 1, size);
    if (!p) die(EXIT_RUN, "no memory for the lamps");
    return p;
}

static bool shines(color c) {
    return c.x > 0 || c.y > 0 || c.z > 0;
}

// The areas of the triangles, added up one after the other.
static const real *area_sums(const mesh *m) {
    real *sums = memory((size_t)m->count, sizeof *sums);
    double sum = 0;
    for (int i = 0; i < m->count; i++) {
        sum += (double)length(triangle_normal(mesh_triangle(m, i))) / 2;
        sums[i] = (real)sum;
    }
    return sums;
}

lamps lamps_find(const scene *bodies, const surface *surfaces) {
    const int planes = bodies->sphere_count, meshes = planes + bodies->plane_count,
              count = meshes + bodies->mesh_count;
    int *of_body = memory((size_t)count, sizeof *of_body);
    lamps all = {.lamps = memory((size_t)count, sizeof *all.lamps), .of_body = of_body};
    for (int i = 0; i < count; i++) {
        of_body[i] = -1;
        if (!shines(surfaces[i].emittance) || (i >= planes && i < meshes)) continue;
        const sphere *S = i < planes ? &bodies->spheres[i] : NULL;
        const mesh *m = S ? NULL : &bodies->meshes[i - meshes];
        of_body[i] = all.count;
        all.lamps[all.count++] = (lamp){i, S, m, m ? area_sums(m) : NULL};
    }
    return all;
}

void lamps_free(lamps *all) {
    for (int i = 0; i < all->count; i++) free((void *)all->lamps[i].areas);
    free(all->lamps);
    free((void *)all->of_body);
    *all = (lamps){0};
}

// ---- towards a sphere --------------------------------------------------------------

static aim aim_at_sphere(const lamp *l, vec3 x, rng *g) {
    const vec3 w = sub(x, l->S->c);
    if (dot(w, w) <= l->S->r * l->S->r) return (aim){.body = -1};
    const vec3 v = sphere_direction(*l->S, x, g);
    const ray r = {x, v};
    const real t = sphere_hit(*l->S, r, 0, NO_HIT);
    if (t == NO_HIT) return (aim){.body = -1}; // the rim, rounded
    return (aim){l->body, sphere_surface(*l->S, r, t), v, sphere_probability(*l->S, x, v)};
}

// ---- towards a mesh ------------------------------------------------------------------

// The first triangle whose sum is above a random share of the area.
static int some_triangle(const lamp *l, rng *g) {
    const int last = l->m->count - 1;
    const real goal = rng_real(g) * l->areas[last];
    int i = 0;
    while (i < last && l->areas[i] <= goal) i++;
    return i;
}

static aim aim_at_mesh(const lamp *l, vec3 x, rng *g) {
    const int i = some_triangle(l, g);
    const triangle T = mesh_triangle(l->m, i);
    const triangle_point q = triangle_sample(T, g);
    const vec3 y = add(add(scale(1 - q.u - q.v, T.p1), scale(q.u, T.p2)), scale(q.v, T.p3));
    const real t = length(sub(y, x));
    if (!(t > 0)) return (aim){.body = -1};
    const ray r = {x, scale(1 / t, sub(y, x))};
    const hit on = triangle_surface(T, r, (triangle_point){t, q.u, q.v});
    const real area = l->areas[l->m->count - 1];
    return (aim){l->body, on, r.d, solid_angle_probability(x, on.p, on.n, area)};
}

// ---- any of them ---------------------------------------------------------------------

aim lamps_aim(const lamps *all, vec3 x, rng *g) {
    if (all->count == 0) return (aim){.body = -1};
    const int i = (int)(rng_real(g) * (real)all->count);
    const lamp *l = &all->lamps[i < all->count ? i : all->count - 1];
    aim a = l->S ? aim_at_sphere(l, x, g) : aim_at_mesh(l, x, g);
    a.p /= (real)all->count;
    return a;
}

real lamps_probability(const lamps *all, int body, vec3 x, vec3 v, hit h) {
    if (all->of_body[body] < 0) return 0;
    const lamp *l = &all->lamps[all->of_body[body]];
    const real p = l->S ? sphere_probability(*l->S, x, v)
                        : solid_angle_probability(x, h.p, h.n, l->areas[l->m->count - 1]);
    return p / (real)all->count;
}

bool scene_blocked(const scene *sc, ray r, real t_max) {
    for (int i = 0; i < sc->sphere_count; i++)
        if (sphere_hit(sc->spheres[i], r, 0, t_max) < t_max) return true;
    int which;
    for (int i = 0; i < sc->mesh_count; i++)
        if (mesh_hit(&sc->meshes[i], r, 0, t_max, &which).t < t_max) return true;
    for (int i = 0; i < sc->plane_count; i++)
        if (plane_hit(sc->planes[i], r, 0, t_max) < t_max) return true;
    return false;
}
