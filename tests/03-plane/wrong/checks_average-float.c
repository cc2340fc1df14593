// Wrong: float throughout: x + w/2 has no digits left far out.
// Expect: x + w/2 needs more digits than a float has
#include "chapters/03-plane/plane.h"

static float wave_integral(float x) {
    const float in_period = x - 2 * floor(x / 2);
    return in_period < 1 ? in_period : 2 - in_period;
}

static float wave_mean(float x, float w) {
    return (wave_integral(x + w / 2) - wave_integral(x - w / 2)) / w;
}

real checks_average(real x, real z, real w) {
    return (1 - wave_mean((float)x, (float)w) * wave_mean((float)z, (float)w)) / 2;
}
