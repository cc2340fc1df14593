// check_diagnosis.c: what does a wrong answer look like? First the suspects that
// the test named, then too few digits and the usual slips: a sign, a factor,
// swapped axes.
#define _POSIX_C_SOURCE 200809L

#include "tests/check.h"
#include "tests/check_inside.h"

// ---- Aiming at a guess ----------------------------------------------------
// A guess must be near got, and much nearer than expected is: with expected = 1
// the square, the root and the reciprocal say nothing.

static aim aim_at(double far, double size, allowance allowed) {
    const double own = size > 0 ? allowance_slack(allowed, size) / size : 0;
    return (aim){far, fmin(fmax(own, 1e-3), 2e-2)};
}

bool aim_hits(aim a, double distance, double size) {
    return distance <= a.slack * size && 4 * distance < a.far;
}

// ---- Rounding --------------------------------------------------------------

// Off by so little, relatively, an answer is hardly a wrong formula's.
static const double NEARLY = 1e-4;
// An allowance larger than this is no rounding's: it speaks of statistics.
static const double LARGEST_ROUNDING = 1e-5;

static const char *nearly_right(double off, double size, allowance allowed) {
    if (!isfinite(off) || off > NEARLY * size) return NULL;
    if (allowance_slack(allowed, size) > LARGEST_ROUNDING * size) return NULL;
    const bool in_float = sizeof(real) == sizeof(float) && off > REAL_EPSILON / 8 * size;
    return in_float ? "the right formula with too few digits: rounding. Double inside?"
                    : "the right formula with too few digits: rounding that could be avoided";
}

// ---- Real numbers ---------------------------------------------------------

typedef struct {
    const char *what;
    double factor;
} tell_tale;

static const tell_tale factors[] = {
    {"minus the expected: the sign is wrong", -1},
    {"twice the expected", 2},
    {"half the expected", 0.5},
    {"4 times the expected", 4},
    {"a quarter of the expected", 0.25},
    {"π times the expected", PI},
    {"the expected divided by π", 1 / PI},
    {"2π times the expected", 2 * PI},
    {"the expected divided by 2π", 0.5 / PI},
};

const char *diagnose_odd(double got, double expected) {
    if (isnan(got)) return "NaN: 0/0, or the square root of a negative?";
    if (isinf(got) && got > 0)
        return "infinity: reported as a miss (NO_HIT), or a division by zero";
    if (isinf(got)) return "minus infinity: division by zero?";
    if (isinf(expected) && expected > 0)
        return "finite where infinity belongs; in a ray's test: a hit was reported where there "
               "is none";
    return NULL;
}

static bool looks_like(aim a, double got, double guess) {
    return aim_hits(a, fabs(got - guess), fabs(guess));
}

static const char *known_factor(double got, double expected, aim a) {
    for (int i = 0; i < COUNT(factors); i++)
        if (looks_like(a, got, factors[i].factor * expected)) return factors[i].what;
    return NULL;
}

static const char *known_function(double got, double e, aim a) {
    if (looks_like(a, got, e * e)) return "the square of the expected";
    if (e > 0 && looks_like(a, got, sqrt(e))) return "the square root of the expected";
    if (looks_like(a, got, 1 / e)) return "the reciprocal of the expected";
    return NULL;
}

const char *diagnose_real(double got, double expected, allowance allowed) {
    const aim a = aim_at(fabs(got - expected), fabs(expected), allowed);
    const char *suspected = suspected_real(got, expected, a);
    if (suspected) return suspected;
    if (diagnose_odd(got, expected)) return diagnose_odd(got, expected);
    if (expected == 0) return NULL;
    if (got == 0) return "nothing was computed?";
    const char *nearly = nearly_right(a.far, fabs(expected), allowed);
    if (nearly) return nearly;
    const char *factor = known_factor(got, expected, a);
    return factor ? factor : known_function(got, expected, a);
}

// ---- Vectors --------------------------------------------------------------

typedef struct {
    const char *what;
    vec3 value;
} guess3;

static const char *nearest_guess(const guess3 *guesses, int count, vec3 got, aim a) {
    for (int i = 0; i < count; i++)
        if (aim_hits(a, distance_in_double(got, guesses[i].value),
                     length_in_double(guesses[i].value)))
            return guesses[i].what;
    return NULL;
}

static const char *diagnose_order(vec3 got, vec3 e, aim a) {
    const guess3 guesses[] = {
        {"the expected negated: the sign is wrong", neg(e)},
        {"the sign of x is wrong", {-e.x, e.y, e.z}},
        {"the sign of y is wrong", {e.x, -e.y, e.z}},
        {"the sign of z is wrong", {e.x, e.y, -e.z}},
        {"x and y are swapped", {e.y, e.x, e.z}},
        {"y and z are swapped", {e.x, e.z, e.y}},
        {"x and z are swapped", {e.z, e.y, e.x}},
        {"x, y, z are shifted: y, z, x", {e.y, e.z, e.x}},
        {"x, y, z are shifted: z, x, y", {e.z, e.x, e.y}},
        {"each component squared", mul(e, e)},
    };
    return nearest_guess(guesses, COUNT(guesses), got, a);
}

static const char *diagnose_length(vec3 got, vec3 expected, aim a) {
    const double size = length_in_double(expected), factor = length_in_double(got) / size;
    const vec3 stretched = scale((real)factor, expected);
    if (!aim_hits(a, distance_in_double(got, stretched), length_in_double(stretched)))
        return NULL;
    if (fabs(factor - 1) < 1e-3) return NULL; // as good as the same length
    for (int i = 1; i < COUNT(factors); i++)  // 0: minus, a length is positive
        if (fabs(factor / factors[i].factor - 1) <= a.slack) return factors[i].what;
    const char *why = fabs(size - 1) < 1e-3 ? ": not normalised?" : "";
    return text_kept("the right direction, but %.4g times as long%s", factor, why);
}

static const char *odd_component(vec3 v) {
    const double components[] = {(double)v.x, (double)v.y, (double)v.z};
    for (int i = 0; i < 3; i++)
        if (!isfinite(components[i])) return diagnose_odd(components[i], 0);
    return NULL;
}

const char *diagnose_vec3(vec3 got, vec3 expected, allowance allowed) {
    const aim a =
        aim_at(distance_in_double(got, expected), length_in_double(expected), allowed);
    const char *suspected = suspected_vec3(got, expected, a);
    if (suspected) return suspected;
    if (!is_finite(got)) return odd_component(got);
    if (length_in_double(expected) == 0 || !is_finite(expected)) return NULL;
    if (length_in_double(got) == 0) return "nothing was computed?";
    const char *nearly = nearly_right(a.far, length_in_double(expected), allowed);
    if (nearly) return nearly;
    const char *order = diagnose_order(got, expected, a);
    return order ? order : diagnose_length(got, expected, a);
}

// ---- Whole numbers --------------------------------------------------------

const char *diagnose_int(long got, long expected) {
    if (suspected_int(got)) return suspected_int(got);
    if (got == expected + 1) return "one too many";
    if (got == expected - 1) return "one too few";
    return NULL;
}
