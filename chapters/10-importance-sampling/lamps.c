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

// Do all corners lie in the plane of the first triangle, whose unit normal is n, but for
// rounding? Not when its area is 0.
static bool is_flat(const mesh *m, vec3 n) {
    if (dot(n, n) == 0) return false;
    const vec3 x = mesh_triangle(m, 0).p1;
    for (int i = 0; i < m->count; i++)
        for (int k = 0; k < 3; k++) {
            const vec3 y = m->points[m->corners[i][k]];
            const real rounding = dot(absolute(n), add(absolute(x), absolute(y)));
            if (fabs(dot(n, sub(y, x))) > 4 * REAL_EPSILON * rounding) return false;
        }
    return true;
}

static lamp mesh_lamp(int body, const mesh *m) {
    facet *facets = memory((size_t)m->count, sizeof *facets);
    double sum = 0;
    vec3 most = {0, 0, 0};
    for (int i = 0; i < m->count; i++) {
        const triangle T = mesh_triangle(m, i);
        const vec3 n = triangle_normal(T);
        const real twice = length(n);
        sum += (double)twice / 2;
        facets[i] = (facet){T, scale(twice > 0 ? 1 / twice : 0, n), (real)sum};
        const vec3 sizes = add(add(absolute(T.p1), absolute(T.p2)), absolute(T.p3));
        most = (vec3){fmax(most.x, sizes.x), fmax(most.y, sizes.y), fmax(most.z, sizes.z)};
    }
    return (lamp){.body = body,
                  .facets = facets,
                  .count = m->count,
                  .area = (real)sum,
                  .error = scale(rounding_bound(6), most),
                  .hides_itself = !is_flat(m, facets[0].n)};
}

lamps lamps_find(const scene *bodies, const surface *surfaces) {
    const int planes = bodies->sphere_count, meshes = planes + bodies->plane_count,
              count = meshes + bodies->mesh_count;
    int *of_body = memory((size_t)count, sizeof *of_body);
    lamps all = {.lamps = memory((size_t)count, sizeof *all.lamps), .of_body = of_body};
    for (int i = 0; i < count; i++) {
        of_body[i] = -1;
        if (!shines(surfaces[i].emittance) || (i >= planes && i < meshes)) continue;
        of_body[i] = all.count;
        all.lamps[all.count++] = i < planes ? (lamp){.body = i, .S = &bodies->spheres[i]}
                                            : mesh_lamp(i, &bodies->meshes[i - meshes]);
    }
    if (all.count > 0) all.chance = 1 / (real)all.count;
    return all;
}

void lamps_free(lamps *all) {
    for (int i = 0; i < all->count; i++) free((void *)all->lamps[i].facets);
    free(all->lamps);
    free((void *)all->of_body);
    *all = (lamps){0};
}

// ---- a room ----------------------------------------------------------------------------

lit_room lit(scene bodies, const surface *surfaces, strategy how) {
    return (lit_room){scene_prepare(bodies), surfaces, lamps_find(&bodies, surfaces), how};
}

void lit_free(lit_room *sc) {
    scene_release(&sc->bodies);
    lamps_free(&sc->lamps);
}

// ---- towards a sphere --------------------------------------------------------------

// A direction to a sphere that looks tiny has few digits for it, and some pass the rim by a
// rounding: they stand for the rim.
static aim aim_at_sphere(const lamp *l, vec3 x, rng *g) {
    const vec3 w = sub(l->S->c, x);
    if (dot(w, w) <= l->S->r * l->S->r) return (aim){.body = -1};
    const vec3 v = sphere_direction(*l->S, x, g);
    const ray r = {x, v};
    const real t = fmin(sphere_hit(*l->S, r, 0, NO_HIT), dot(w, v));
    hit on = sphere_surface(*l->S, r, t);
    on.front = true;
    return (aim){l->body, on, v, on.p, l->body};
}

// ---- towards a mesh ------------------------------------------------------------------

// The first facet whose sum is above a random share of the area.
static const facet *some_facet(const lamp *l, rng *g) {
    const real goal = rng_real(g) * l->area;
    int passed = 0; // counted, not searched: no branch that depends on chance
    for (int i = 0; i < l->count - 1; i++) passed += l->facets[i].up_to <= goal;
    return &l->facets[passed];
}

static aim aim_at_mesh(const lamp *l, vec3 x, rng *g) {
    const facet *f = some_facet(l, g);
    const triangle T = f->T;
    const triangle_point q = triangle_sample(T, g);
    const vec3 y = add(add(scale(1 - q.u - q.v, T.p1), scale(q.u, T.p2)), scale(q.v, T.p3));
    const real t = length(sub(y, x));
    if (!(t > 0)) return (aim){.body = -1};
    const vec3 v = scale(1 / t, sub(y, x));
    const hit on = {t, y, l->error, f->n, dot(v, f->n) < 0};
    if (!l->hides_itself) return (aim){l->body, on, v, y, l->body};
    return (aim){l->body, on, v, offset_origin(y, l->error, f->n, f->n), -1};
}

// ---- any of them ---------------------------------------------------------------------

aim lamps_aim(const lamps *all, vec3 x, rng *g) {
    if (all->count == 0) return (aim){.body = -1};
    const int i = (int)(rng_real(g) * (real)all->count);
    const lamp *l = &all->lamps[i < all->count ? i : all->count - 1];
    return l->S ? aim_at_sphere(l, x, g) : aim_at_mesh(l, x, g);
}

// That of a sphere is the same in the whole cone, also where the direction to h was rounded
// out of it: so it is asked for the middle.
real lamps_probability(const lamps *all, int body, vec3 x, hit h) {
    if (all->of_body[body] < 0) return 0;
    const lamp *l = &all->lamps[all->of_body[body]];
    const real p = l->S ? sphere_probability(*l->S, x, normalize(sub(l->S->c, x)))
                        : solid_angle_probability(x, h.p, h.n, l->area);
    return p * all->chance;
}

bool scene_blocked(const scene *sc, ray r, real t_max, int except) {
    for (int i = 0; i < sc->sphere_count; i++)
        if (i != except && sphere_hit(sc->spheres[i], r, 0, t_max) < t_max) return true;
    if (planes_block(sc, r, 0, t_max)) return true;
    const int meshes = sc->sphere_count + sc->plane_count;
    for (int i = 0; i < sc->mesh_count; i++)
        if (meshes + i != except && mesh_any(&sc->meshes[i], r, 0, t_max)) return true;
    return false;
}
