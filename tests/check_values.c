// check_values.c: is the answer right? How far it may be off, and the checks
// themselves. What a wrong answer looks like stands in check_diagnosis.c.
#define _POSIX_C_SOURCE 200809L

#include <stdio.h>
#include <string.h>

#include "tests/check.h"
#include "tests/check_inside.h"

// ---- Allowances -----------------------------------------------------------

allowance exactly(void) {
    return (allowance){0, 0, "exactly this"};
}

allowance roundings(double n, const char *why) {
    return (allowance){
        .relative = n * (double)REAL_EPSILON / 2,
        .why = text_kept("%g roundings of a %s: %s", n, REAL_NAME, why),
    };
}

allowance relative_to(double relative, const char *why) {
    return (allowance){.relative = relative, .why = text_kept("%g of it: %s", relative, why)};
}

allowance absolute_of(double absolute, const char *why) {
    return (allowance){.absolute = absolute, .why = why};
}

allowance standard_errors(double z, double standard_error) {
    return (allowance){
        .absolute = z * standard_error,
        .why =
            text_kept("%g standard errors of %.2g; a right answer fails with probability %.1g",
                      z, standard_error, erfc(z / sqrt(2.0))),
    };
}

double allowance_slack(allowance allowed, double size) {
    return allowed.absolute + allowed.relative * fabs(size);
}

double length_in_double(vec3 v) {
    return hypot(hypot((double)v.x, (double)v.y), (double)v.z);
}

double distance_in_double(vec3 a, vec3 b) {
    return hypot(hypot((double)a.x - (double)b.x, (double)a.y - (double)b.y),
                 (double)a.z - (double)b.z);
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

// ---- Checks ---------------------------------------------------------------

static text message_about(const char *call) {
    text t = {0};
    if (*given_text()) text_row(&t, "given", "%s", given_text());
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
    const double slack = isfinite(size) ? allowance_slack(allowed, size) : 0;
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

// As floats they may look alike: show what differs.
static void tell_apart(short_text *one, double a, short_text *other, double b) {
    if (strcmp(one->chars, other->chars) != 0) return;
    snprintf(one->chars, sizeof one->chars, "%.17g", a);
    snprintf(other->chars, sizeof other->chars, "%.17g", b);
}

void check_real(const char *file, int line, const char *call, double got, double expected,
                allowance allowed) {
    if (agrees(got, expected, allowance_slack(allowed, expected))) return;
    const char *likely = diagnose_real(got, expected, allowed);
    text t = message_about(call);
    short_text want = text_number(expected), have = text_number(got);
    tell_apart(&want, expected, &have, got);
    add_answers(&t, want.chars, have.chars, fabs(got - expected), fabs(expected));
    add_allowed(&t, allowed, expected);
    if (likely) text_row(&t, "looks like", "%s", likely);
    test_failed(&t, file, line);
}

static bool agrees_vec3(vec3 got, vec3 expected, allowance allowed) {
    if (is_finite(got) && is_finite(expected))
        return distance_in_double(got, expected) <=
               allowance_slack(allowed, length_in_double(expected));
    return agrees((double)got.x, (double)expected.x,
                  allowance_slack(allowed, (double)expected.x)) &&
           agrees((double)got.y, (double)expected.y,
                  allowance_slack(allowed, (double)expected.y)) &&
           agrees((double)got.z, (double)expected.z,
                  allowance_slack(allowed, (double)expected.z));
}

void check_vec3(const char *file, int line, const char *call, vec3 got, vec3 expected,
                allowance allowed) {
    if (agrees_vec3(got, expected, allowed)) return;
    const char *likely = diagnose_vec3(got, expected, allowed);
    text t = message_about(call);
    add_answers(&t, text_vec3(expected).chars, text_vec3(got).chars,
                distance_in_double(got, expected), length_in_double(expected));
    add_allowed(&t, allowed, length_in_double(expected));
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
    if (likeness_given()) text_row(&t, "looks like", "%s", likeness_given());
    test_failed(&t, file, line);
}

void check_at_most(const char *file, int line, const char *call, double got, double bound,
                   const char *why) {
    if (got <= bound) return; // false for NaN
    text t = message_about(call);
    short_text most = text_number(bound), have = text_number(got);
    tell_apart(&most, bound, &have, got);
    text_row(&t, "expected", "at most %s (%s)", most.chars, why);
    text_row(&t, "got", "%s", have.chars);
    const char *likely = isfinite(got)
                             ? suspected_real(got, bound, (aim){fabs(got - bound), 2e-2})
                             : diagnose_odd(got, 0);
    if (likely) text_row(&t, "looks like", "%s", likely);
    test_failed(&t, file, line);
}

void check_that(const char *file, int line, const char *text_of, bool holds,
                const char *claim) {
    if (holds) return;
    text t = {0};
    if (*given_text()) text_row(&t, "given", "%s", given_text());
    text_row(&t, "expected", "%s", claim);
    text_row(&t, "got", "not so: %s", text_of);
    if (likeness_given()) text_row(&t, "looks like", "%s", likeness_given());
    test_failed(&t, file, line);
}
