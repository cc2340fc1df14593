// obj_number.c: see obj_inside.h. Most numbers of a file have few digits: one multiplication
// or division rounds them correctly. The C library does the others.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "chapters/12-bvh/obj_inside.h"

// No number halfway between two doubles has more significant digits than (2^54 - 1) 2^-1075: of
// those beyond it only matters whether one is other than 0.
enum { MOST_DIGITS = 768 };

// 0.digits times 10 to the power of (count + exponent).
typedef struct {
    bool minus, cut; // cut: there were more digits, not all 0
    int count;
    int64_t exponent;
    char digits[MOST_DIGITS + 32]; // the first of them is not 0; the rest is for an exponent
} decimal;

static bool is_digit(const char *p, const char *end) {
    return p < end && *p >= '0' && *p <= '9';
}

static void add_digit(decimal *d, char c) {
    if (d->count == 0 && c == '0') return;
    if (d->count < MOST_DIGITS) {
        d->digits[d->count++] = c;
        return;
    }
    d->exponent++;
    d->cut = d->cut || c != '0';
}

static const char *skip_sign(const char *p, const char *end, bool *minus) {
    *minus = p < end && *p == '-';
    return p < end && (*p == '-' || *p == '+') ? p + 1 : p;
}

// "e-12" and nothing behind it. Further than FAR the exact value does not matter: no text is
// long enough to bring it back.
static bool scan_exponent(const char *p, const char *end, int64_t *exponent) {
    const int64_t far = INT64_MAX / 100;
    bool minus;
    int64_t e = 0;
    if (*p != 'e' && *p != 'E') return false;
    p = skip_sign(p + 1, end, &minus);
    if (!is_digit(p, end)) return false;
    for (; is_digit(p, end); p++)
        if (e < far) e = 10 * e + (*p - '0');
    *exponent += minus ? -e : e;
    return p == end;
}

static bool scan_decimal(obj_word w, decimal *d) {
    const char *p = skip_sign(w.begin, w.end, &d->minus);
    d->cut = false, d->count = 0, d->exponent = 0;
    bool any = false;
    for (; is_digit(p, w.end); p++, any = true) add_digit(d, *p);
    if (p < w.end && *p == '.')
        for (p++; is_digit(p, w.end); p++, any = true) {
            add_digit(d, *p);
            d->exponent--;
        }
    return any && (p == w.end || scan_exponent(p, w.end, &d->exponent));
}

// Halfway between two floats (of normal size)? double keeps 29 bits more.
static bool is_tie(double x) {
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return (bits & 0x1fffffff) == 0x10000000;
}

// Digits below 2^53 and a power of ten up to 10^22 are doubles without rounding, so one
// operation rounds once. Source: Clinger 1990. Rounding again, to float, may go wrong only if
// the first one came to a tie. false: another way is needed.
static bool round_at_once(const decimal *d, real *x) {
    static const double power[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                   1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                   1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    if (d->count > DBL_DIG || d->exponent <= -COUNT(power) || d->exponent >= COUNT(power))
        return false;
    int64_t digits = 0;
    for (int i = 0; i < d->count; i++) digits = 10 * digits + (d->digits[i] - '0');
    const double exact = (double)digits;
    const double size =
        d->exponent < 0 ? exact / power[-d->exponent] : exact * power[d->exponent];
    *x = (real)size;
    return sizeof(real) == sizeof size || !is_tie(size);
}

// A text without decimal point, which each locale writes its own way: the digits, a 1 for those
// that were cut off, and the exponent behind them.
static real round_by_library(decimal *d) {
    enum { BEYOND = 400 }; // 10^400 and 10^-400 are infinity and 0 in float and double
    const int64_t power = d->count + d->exponent;
    if (d->count == 0 || power < -BEYOND) return 0;
    if (power > BEYOND) return (real)INFINITY;
    snprintf(d->digits + d->count, sizeof d->digits - (size_t)d->count, "%se%d",
             d->cut ? "1" : "", (int)d->exponent - d->cut);
    return sizeof(real) == sizeof(float) ? (real)strtof(d->digits, NULL)
                                         : (real)strtod(d->digits, NULL);
}

bool obj_number(obj_word w, real *x) {
    decimal d;
    if (!scan_decimal(w, &d)) return false;
    real size;
    if (!round_at_once(&d, &size)) size = round_by_library(&d);
    *x = d.minus ? -size : size;
    return true;
}
