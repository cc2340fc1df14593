// mirror.c: the lecture's bounce loop, for surfaces that mirror or shine.
#include "solutions/homework/raytracer.h"

static color sky(vec3 d) {
    const real s = d.y > 0 ? d.y : 0;
    return lerp((color){1, 1, 1}, (color){(real)0.25, (real)0.45, (real)0.9}, s);
}

static color color_at(const body *b, vec3 p) {
    const bool odd = b->checkered && ((int)floor(p.x) + (int)floor(p.z)) % 2 != 0;
    return odd ? b->color2 : b->color;
}

color mirror_light(const scene *sc, ray r, int bounces, rng *g) {
    (void)g;
    color C = {1, 1, 1};
    for (int bounce = 0; bounce <= bounces; bounce++) {
        const hit h = nearest(sc, r, NEAR, FAR);
        if (!h.b) return mul(C, sky(r.d));
        C = mul(C, color_at(h.b, h.p));
        if (h.b->finish == GLOW) return C;
        r = (ray){h.p, sub(r.d, scale(2 * dot(r.d, h.n), h.n))};
    }
    return (color){0, 0, 0};
}
