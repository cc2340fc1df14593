// Right: f stands where L_i does: the irradiance of f.
#include "chapters/07-rendering-equation/rendering.h"

typedef struct {
    brdf f;
    const void *paint;
    vec3 n, w_o;
} reflection;

static double towards(const void *data, vec3 x, vec3 w_i) {
    const reflection *r = data;
    (void)x;
    return r->f(r->paint, r->n, w_i, r->w_o);
}

double directional_albedo(brdf f, const void *paint, vec3 n, vec3 w_o, int n_theta, int n_phi) {
    const reflection r = {f, paint, n, w_o};
    return irradiance(towards, &r, (vec3){0, 0, 0}, n, n_theta, n_phi);
}
