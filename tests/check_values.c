// check_values.c: the checks: is the answer right, and if not, what does it
// look like? Processes and reports stand in check.c.
#define _POSIX_C_SOURCE 200809L

#include "tests/check.h"
#include "tests/check_inside.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// ---- Text -----------------------------------------------------------------

static void add_v(text *t, const char *format, va_list args) {
    const size_t room = sizeof t->chars - t->length;
    const int n = vsnprintf(t->chars + t->length, room, format, args);
    if (n > 0) t->length += (size_t)n < room ? (size_t)n : room - 1;
}

void text_add(text *t, const char *format, ...) {
    va_list args;
    va_start(args, format);
    add_v(t, format, args);
    va_end(args);
}

void text_row(text *t, const char *label, const char *format, ...) {
    text words = {0};
    va_list args;
    va_start(args, format);
    add_v(&words, format, args);
    va_end(args);
    text_add(t, "%-10s ", label);
    for (const char *line = words.chars;;) {
        const int length = (int)strcspn(line, "\n");
        text_add(t, "%.*s\n", length, line);
        if (!line[length]) return;
        line += length + 1;
        text_add(t, "%11s", "");
    }
}

typedef struct {
    char chars[96];
} short_text;

// As few digits as give the same number again.
static short_text number(double x) {
    if (isinf(x)) return x > 0 ? (short_text){"infinity"} : (short_text){"-infinity"};
    short_text s;
    const int most = sizeof(real) == sizeof(float) ? 9 : 17;
    for (int digits = 1; digits <= most; digits++) {
        snprintf(s.chars, sizeof s.chars, "%.*g", digits, x);
        if (digits >= 6 && (real)strtod(s.chars, NULL) == (real)x) break;
    }
    return s;
}

static short_text vector(vec3 v) {
    short_text s;
    const short_text x = number((double)v.x), y = number((double)v.y), z = number((double)v.z);
    snprintf(s.chars, sizeof s.chars, "(%.29s, %.29s, %.29s)", x.chars, y.chars, z.chars);
    return s;
}

// ---- What is given, and what wrong answers the test foresees ---------------

typedef struct {
    enum { VALUE, VECTOR, FACTOR } kind;
    const char *what;
    double number; // the value or the factor
    vec3 vector;
} suspect;

static struct {
    char given[2048];
    suspect suspects[16];
    int count;
} about;

void given(const char *format, ...) {
    va_list args;
    va_start(args, format);
    vsnprintf(about.given, sizeof about.given, format, args);
    va_end(args);
    about.count = 0;
}

const char *given_text(void) {
    return about.given;
}

static void add_suspect(suspect s) {
    if (about.count == COUNT(about.suspects)) {
        fprintf(stderr, "check: more than %d suspects\n", about.count);
        abort();
    }
    about.suspects[about.count++] = s;
}

void suspect_value(const char *what, double value) {
    add_suspect((suspect){.kind = VALUE, .what = what, .number = value});
}

void suspect_vec3(const char *what, vec3 value) {
    add_suspect((suspect){.kind = VECTOR, .what = what, .vector = value});
}

void suspect_factor(const char *what, double factor) {
    add_suspect((suspect){.kind = FACTOR, .what = what, .number = factor});
}

// ---- Allowances -----------------------------------------------------------

// Reasons live until eight more are made: longer than any one check.
static const char *reason(const char *format, ...) {
    static char reasons[8][200];
    static int next;
    char *r = reasons[next++ % COUNT(reasons)];
    va_list args;
    va_start(args, format);
    vsnprintf(r, sizeof reasons[0], format, args);
    va_end(args);
    return r;
}

allowance exactly(void) {
    return (allowance){0, 0, "exactly this"};
}

allowance roundings(double n, const char *why) {
    return (allowance){
        .relative = n * (double)REAL_EPSILON / 2,
        .why = reason("%g roundings of a %s: %s", n, REAL_NAME, why),
    };
}

allowance relative_to(double relative, const char *why) {
    return (allowance){.relative = relative, .why = reason("%g of it: %s", relative, why)};
}

allowance absolute_of(double absolute, const char *why) {
    return (allowance){.absolute = absolute, .why = why};
}

allowance standard_errors(double z, double standard_error) {
    return (allowance){
        .absolute = z * standard_error,
        .why = reason("%g standard errors of %.2g; a right answer fails with probability %.1g",
                      z, standard_error, erfc(z / sqrt(2.0))),
    };
}

static double slack_of(allowance allowed, double size) {
    return allowed.absolute + allowed.relative * fabs(size);
}

// The x that a standard normal variable exceeds with probability p, by halving.
static double normal_limit(double p) {
    double low = -40, high = 40;
    for (int i = 0; i < 100; i++) {
        const double x = (low + high) / 2;
        if (erfc(x / sqrt(2.0)) / 2 > p)
            low = x;
        else
            high = x;
    }
    return high;
}

// Wilson, Hilferty 1931: the cube root of chi²/dof is nearly normal.
double chi2_limit(int dof, double false_alarm) {
    const double variance = 2 / (9.0 * dof);
    const double root = 1 - variance + normal_limit(false_alarm) * sqrt(variance);
    return dof * root * root * root;
}

// ---- Diagnosis ------------------------------------------------------------
// A guess must be near got, and much nearer than expected is: with expected = 1
// the square, the root and the reciprocal say nothing.

typedef struct {
    double far;   // |got - expected|
    double slack; // relative: how near a guess must be
} aim;

static aim aim_at(double far, double size, allowance allowed) {
    const double own = size > 0 ? slack_of(allowed, size) / size : 0;
    return (aim){far, fmin(fmax(own, 1e-3), 2e-2)};
}

static bool hits(aim a, double distance, double size) {
    return distance <= a.slack * size && 4 * distance < a.far;
}

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

static const char *odd_number(double got, double expected) {
    if (isnan(got)) return "NaN: 0/0, or the square root of a negative?";
    if (isinf(got) && got > 0) return "infinity: division by zero? or: reported as a miss";
    if (isinf(got)) return "minus infinity: division by zero?";
    if (isinf(expected) && expected > 0) return "a hit was reported where there is none";
    return NULL;
}

static const char *diagnose_real(double got, double expected, allowance allowed) {
    const aim a = aim_at(fabs(got - expected), fabs(expected), allowed);
    for (const suspect *s = about.suspects; s < about.suspects + about.count; s++) {
        const double guess = s->kind == FACTOR ? s->number * expected : s->number;
        if (s->kind == VECTOR || (s->kind == FACTOR && expected == 0)) continue;
        if (got == guess || hits(a, fabs(got - guess), fabs(guess))) return s->what;
    }
    if (odd_number(got, expected)) return odd_number(got, expected);
    if (expected == 0) return NULL;
    if (got == 0) return "nothing was computed?";
    for (int i = 0; i < COUNT(factors); i++) {
        const double guess = factors[i].factor * expected;
        if (hits(a, fabs(got - guess), fabs(guess))) return factors[i].what;
    }
    const tell_tale functions[] = {
        {"the square of the expected", expected * expected},
        {"the square root of the expected", expected > 0 ? sqrt(expected) : NAN},
        {"the reciprocal of the expected", 1 / expected},
    };
    for (int i = 0; i < COUNT(functions); i++)
        if (hits(a, fabs(got - functions[i].factor), fabs(functions[i].factor)))
            return functions[i].what;
    return NULL;
}

// In double: the square of a large float must not overflow.
static double size_of(vec3 v) {
    return hypot(hypot((double)v.x, (double)v.y), (double)v.z);
}

static double distance(vec3 a, vec3 b) {
    return hypot(hypot((double)a.x - (double)b.x, (double)a.y - (double)b.y),
                 (double)a.z - (double)b.z);
}

typedef struct {
    const char *what;
    vec3 value;
} guess3;

static const char *nearest_guess(const guess3 *guesses, int count, vec3 got, aim a) {
    for (int i = 0; i < count; i++)
        if (hits(a, distance(got, guesses[i].value), size_of(guesses[i].value)))
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
    const double size = size_of(expected), factor = size_of(got) / size;
    const vec3 stretched = scale((real)factor, expected);
    if (!hits(a, distance(got, stretched), size_of(stretched))) return NULL;
    if (fabs(factor - 1) < 1e-3) return NULL; // as good as the same length
    for (int i = 1; i < COUNT(factors); i++)  // 0: minus, a length is positive
        if (fabs(factor / factors[i].factor - 1) <= a.slack) return factors[i].what;
    const char *why = fabs(size - 1) < 1e-3 ? ": not normalised?" : "";
    return reason("the right direction, but %.4g times as long%s", factor, why);
}

static const char *diagnose_vec3(vec3 got, vec3 expected, allowance allowed) {
    const aim a = aim_at(distance(got, expected), size_of(expected), allowed);
    for (const suspect *s = about.suspects; s < about.suspects + about.count; s++) {
        const bool factor = s->kind == FACTOR;
        const guess3 guess = {s->what, factor ? scale((real)s->number, expected) : s->vector};
        if (s->kind == VALUE || (factor && size_of(expected) == 0)) continue;
        if (distance(got, guess.value) == 0 || nearest_guess(&guess, 1, got, a)) return s->what;
    }
    const double components[] = {(double)got.x, (double)got.y, (double)got.z};
    for (int i = 0; i < 3; i++)
        if (!isfinite(components[i])) return odd_number(components[i], 0);
    if (size_of(expected) == 0 || !is_finite(expected)) return NULL;
    if (size_of(got) == 0) return "nothing was computed?";
    const char *order = diagnose_order(got, expected, a);
    return order ? order : diagnose_length(got, expected, a);
}

static const char *diagnose_int(long got, long expected) {
    for (const suspect *s = about.suspects; s < about.suspects + about.count; s++)
        if (s->kind == VALUE && (double)got == s->number) return s->what;
    if (got == expected + 1) return "one too many";
    if (got == expected - 1) return "one too few";
    return NULL;
}

// ---- Checks ---------------------------------------------------------------

static text message_about(const char *call) {
    text t = {0};
    if (*about.given) text_row(&t, "given", "%s", about.given);
    text_row(&t, "called", "%s", call);
    return t;
}

static void add_answers(text *t, const char *expected, const char *got, double off,
                        double size) {
    const bool slightly = off > 0 && off < 1e-2 * size;
    text_row(t, "expected", "%s", expected);
    if (slightly)
        text_row(t, "got", "%s (off by %.2g)", got, off);
    else
        text_row(t, "got", "%s", got);
}

static void add_allowed(text *t, allowance allowed, double size) {
    const double slack = isfinite(size) ? slack_of(allowed, size) : 0;
    const char *why = allowed.why ? allowed.why : "";
    if (slack > 0)
        text_row(t, "allowed", "± %.2g (%s)", slack, why);
    else
        text_row(t, "allowed", "exactly this");
}

// Equal, both NaN, or near enough; an infinity is near nothing else.
static bool agrees(double got, double expected, double slack) {
    if (isnan(expected)) return isnan(got);
    if (got == expected) return true;
    return isfinite(got) && isfinite(expected) && fabs(got - expected) <= slack;
}

void check_real(const char *file, int line, const char *call, double got, double expected,
                allowance allowed) {
    if (agrees(got, expected, slack_of(allowed, expected))) return;
    const char *likely = diagnose_real(got, expected, allowed);
    text t = message_about(call);
    add_answers(&t, number(expected).chars, number(got).chars, fabs(got - expected),
                fabs(expected));
    add_allowed(&t, allowed, expected);
    if (likely) text_row(&t, "looks like", "%s", likely);
    test_failed(&t, file, line);
}

static bool agrees_vec3(vec3 got, vec3 expected, allowance allowed) {
    if (is_finite(got) && is_finite(expected))
        return distance(got, expected) <= slack_of(allowed, size_of(expected));
    return agrees((double)got.x, (double)expected.x, slack_of(allowed, (double)expected.x)) &&
           agrees((double)got.y, (double)expected.y, slack_of(allowed, (double)expected.y)) &&
           agrees((double)got.z, (double)expected.z, slack_of(allowed, (double)expected.z));
}

void check_vec3(const char *file, int line, const char *call, vec3 got, vec3 expected,
                allowance allowed) {
    if (agrees_vec3(got, expected, allowed)) return;
    const char *likely = diagnose_vec3(got, expected, allowed);
    text t = message_about(call);
    add_answers(&t, vector(expected).chars, vector(got).chars, distance(got, expected),
                size_of(expected));
    add_allowed(&t, allowed, size_of(expected));
    if (likely) text_row(&t, "looks like", "%s", likely);
    test_failed(&t, file, line);
}

void check_int(const char *file, int line, const char *call, long got, long expected) {
    if (got == expected) return;
    text t = message_about(call);
    text_row(&t, "expected", "%ld", expected);
    text_row(&t, "got", "%ld", got);
    const char *likely = diagnose_int(got, expected);
    if (likely) text_row(&t, "looks like", "%s", likely);
    test_failed(&t, file, line);
}

void check_bool(const char *file, int line, const char *call, bool got, bool expected) {
    if (got == expected) return;
    text t = message_about(call);
    text_row(&t, "expected", "%s", expected ? "true" : "false");
    text_row(&t, "got", "%s", got ? "true" : "false");
    test_failed(&t, file, line);
}

void check_at_most(const char *file, int line, const char *call, double got, double bound,
                   const char *why) {
    if (got <= bound) return; // false for NaN
    text t = message_about(call);
    text_row(&t, "expected", "at most %s (%s)", number(bound).chars, why);
    text_row(&t, "got", "%s", number(got).chars);
    if (!isfinite(got)) text_row(&t, "looks like", "%s", odd_number(got, 0));
    test_failed(&t, file, line);
}

void check_that(const char *file, int line, const char *text_of, bool holds,
                const char *claim) {
    if (holds) return;
    text t = {0};
    if (*about.given) text_row(&t, "given", "%s", about.given);
    text_row(&t, "expected", "%s", claim);
    text_row(&t, "got", "not so: %s", text_of);
    test_failed(&t, file, line);
}
