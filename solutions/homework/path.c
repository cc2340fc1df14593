// path.c: the rendering equation for matte surfaces, by random paths. Each bounce asks the
// lamp for its light and goes on in a direction chosen by the cosine.
#include "solutions/homework/raytracer.h"

// What arrives from the lamp without a bounce and is sent on by a surface of albedo 1:
// ∫ L cos θ cos θ' / (π |y - x|²) over the lamp's area, by one point y.
static color lamp_light(const scene *sc, vec3 x, vec3 n, rng *g) {
    const lamp *l = &sc->lamp;
    const vec3 y = lamp_point(l, g);
    const real G = geometry(x, n, y, l->n);
    if (G == 0 || blocked(sc, x, y)) return (color){0, 0, 0};
    return scale((real)(1 / PI) * G * l->area, l->radiance);
}

// Roulette: the chance to go on is the largest part of what the path still lets through.
static real survival(color C, int bounce) {
    return bounce < 3 ? 1 : fmax(C.x, fmax(C.y, C.z));
}

color path_light(const scene *sc, ray r, int bounces, rng *g) {
    color C = {1, 1, 1}, L = {0, 0, 0};
    for (int bounce = 0;; bounce++) {
        const hit h = nearest(sc, r, NEAR, FAR);
        if (!h.b) return L;
        if (h.b->finish == GLOW) // later it counts as lamp_light
            return bounce == 0 && h.front ? h.b->color : L;
        if (bounce == bounces) return L;
        C = mul(C, h.b->color);
        L = add(L, mul(C, lamp_light(sc, h.p, h.n, g)));
        const real q = survival(C, bounce);
        if (rng_real(g) >= q) return L;
        C = scale(1 / q, C); // 1/pi cos θ over the density cos θ / pi: the albedo alone is left
        r = (ray){h.p, cosine_direction(h.n, g)};
    }
}
