// bounce.c: see bounce.h. The derivations are in README.md.
#include "chapters/06-bounce/bounce.h"

#include <stdlib.h>

#include "common/die.h"

color clear_sky(vec3 d) {
    const real height = d.y / length(d); // -1 straight down, 1 straight up
    return lerp((color){1, 1, 1}, (color){(real)0.35, (real)0.6, 1}, fmax(height, 0));
}

// ---- a scene for many rays -------------------------------------------------------

// A few planes are met sooner one by one.
scene scene_prepare(scene sc) {
    sc.equations = NULL;
    if (sc.plane_count < EQUATIONS / 2) return sc;
    const int blocks = (sc.plane_count + EQUATIONS - 1) / EQUATIONS;
    plane_equations *all = calloc((size_t)blocks, sizeof *all);
    if (!all) die(EXIT_RUN, "no memory for %d planes", sc.plane_count);
    for (int k = 0; k < blocks; k++) {
        const int first = k * EQUATIONS;
        all[k] = plane_equations_of(sc.planes + first, sc.plane_count - first);
    }
    sc.equations = all;
    return sc;
}

void scene_release(scene *sc) {
    free((void *)sc->equations);
    sc->equations = NULL;
}

// ---- the nearest hit -----------------------------------------------------------

// What the ray meets first, of all that was tried so far.
typedef struct {
    int body;          // -1: nothing
    int corner;        // of a mesh: which triangle
    triangle_point at; // at.t: the new t_max
} nearest;

static nearest try_spheres(const scene *sc, ray r, real t_min, nearest best) {
    for (int i = 0; i < sc->sphere_count; i++) {
        const real t = sphere_hit(sc->spheres[i], r, t_min, best.at.t);
        if (t < best.at.t) best.body = i, best.at.t = t;
    }
    return best;
}

// Which of the planes is nearest is a matter of chance, on which the processor would often guess
// wrong: so nothing branches on it, and the body moves by 1 times or 0 times the way to the
// plane. This is why t is compared here, and plane_hit asked with t_max = NO_HIT.
static nearest nearer_of(nearest best, int body, real t) {
    best.body += (t < best.at.t) * (body - best.body);
    best.at.t = t < best.at.t ? t : best.at.t;
    return best;
}

static nearest try_planes(const scene *sc, ray r, real t_min, nearest best) {
    for (int i = 0; i < sc->plane_count; i++)
        best =
            nearer_of(best, sc->sphere_count + i, plane_hit(sc->planes[i], r, t_min, NO_HIT));
    return best;
}

static nearest try_equations(const scene *sc, ray r, real t_min, nearest best) {
    real t[EQUATIONS];
    for (int i = 0; i < sc->plane_count; i++) {
        const int k = i % EQUATIONS;
        if (k == 0) equations_hit(&sc->equations[i / EQUATIONS], r, t_min, t);
        best = nearer_of(best, sc->sphere_count + i, t[k]);
    }
    return best;
}

bool planes_block(const scene *sc, ray r, real t_min, real t_max) {
    bool blocked = false;
    if (!sc->equations) {
        for (int i = 0; i < sc->plane_count; i++)
            blocked |= plane_hit(sc->planes[i], r, t_min, NO_HIT) < t_max;
        return blocked;
    }
    for (int i = 0; i < sc->plane_count; i += EQUATIONS) {
        real t[EQUATIONS];
        equations_hit(&sc->equations[i / EQUATIONS], r, t_min, t);
        for (int k = 0; k < EQUATIONS; k++) blocked |= t[k] < t_max;
    }
    return blocked;
}

static nearest try_meshes(const scene *sc, ray r, real t_min, nearest best) {
    const int meshes = sc->sphere_count + sc->plane_count;
    for (int i = 0; i < sc->mesh_count; i++) {
        int which = 0;
        const triangle_point at = mesh_hit(&sc->meshes[i], r, t_min, best.at.t, &which);
        if (at.t < best.at.t) best = (nearest){meshes + i, which, at};
    }
    return best;
}

hit scene_nearest(const scene *sc, ray r, real t_min, real t_max, int *body) {
    nearest best = {-1, 0, {t_max, 0, 0}};
    best = try_spheres(sc, r, t_min, best);
    best = sc->equations ? try_equations(sc, r, t_min, best) : try_planes(sc, r, t_min, best);
    best = try_meshes(sc, r, t_min, best);
    if (best.body < 0) return (hit){.t = NO_HIT};
    *body = best.body;
    const int in_planes = best.body - sc->sphere_count, in_meshes = in_planes - sc->plane_count;
    if (in_planes < 0) return sphere_surface(sc->spheres[best.body], r, best.at.t);
    if (in_meshes < 0 && sc->equations)
        return equations_surface(&sc->equations[in_planes / EQUATIONS], in_planes % EQUATIONS,
                                 r, best.at.t);
    if (in_meshes < 0) return plane_surface(sc->planes[in_planes], r, best.at.t);
    return triangle_surface(mesh_triangle(&sc->meshes[in_meshes], best.corner), r, best.at);
}

static const material *material_of(const scene *sc, int body) {
    if (body < sc->sphere_count) return &sc->sphere_materials[body];
    body -= sc->sphere_count;
    if (body < sc->plane_count) return &sc->plane_materials[body];
    return &sc->mesh_materials[body - sc->plane_count];
}

hit scene_hit(const scene *sc, ray r, real t_min, real t_max, const material **m) {
    int body = 0;
    const hit h = scene_nearest(sc, r, t_min, t_max, &body);
    if (h.t != NO_HIT) *m = material_of(sc, body);
    return h;
}

// ---- the bounce ----------------------------------------------------------------

color albedo_at(const material *m, vec3 p) {
    return m->checkered && checks(p.x, p.z) ? m->albedo_2 : m->albedo;
}

// A point of the unit disc, lifted onto the sphere so that equal areas of the
// disc become equal areas of the sphere.
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

static vec3 new_direction(const material *m, vec3 d, vec3 n, rng *g) {
    if (m->finish == MATTE) return matte_bounce(n, g);
    if (m->finish == FUZZY) return fuzzy_bounce(d, n, m->fuzz, g);
    return keep_unit(reflect(d, n));
}

// The start is moved to the side that n was turned to: a grazing d may be rounded
// to the other.
ray bounce(const scene *sc, const material *m, ray r, hit h, rng *g) {
    const vec3 n = h.front ? h.n : neg(h.n);
    const vec3 d = new_direction(m, r.d, n, g);
    return (ray){sc->start == START_BOUND ? offset_origin(h.p, h.error, n, n) : h.p, d};
}

// ---- the loop ------------------------------------------------------------------

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
