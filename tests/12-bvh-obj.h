// 12-bvh-obj.h: the part of 12-bvh.c about the OBJ reader.
#ifndef TESTS_12_BVH_OBJ_H
#define TESTS_12_BVH_OBJ_H

#include <dirent.h>
#include <limits.h>
#include <locale.h>
#include <stdarg.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/check-generic.h"
#include "tests/check-obj.h"
#include "tests/check.h"

// ---- what is given, and what came of it --------------------------------------------------

typedef struct {
    bool done;
    mesh m;
    obj_report about;
    char error[OBJ_ERROR];
} obj_result;

// The beginning of a text for a message, line ends and strange bytes as in C.
typedef struct {
    char chars[400];
} obj_shown;
static obj_shown obj_show(const char *text, size_t length) {
    obj_shown s = {""};
    int used = 0;
    for (size_t i = 0; i < length && used < 300; i++) {
        const unsigned char c = (unsigned char)text[i];
        const char *format = c == '\n'              ? "\\n"
                             : c == '\r'            ? "\\r"
                             : c < ' ' || c >= 0x7f ? "\\x%02x"
                                                    : "%c";
        used += snprintf(s.chars + used, sizeof s.chars - (size_t)used, format, c);
        if (used >= 300) strcpy(s.chars + used, "...");
    }
    return s;
}

static obj_result obj_of_bytes(const char *text, size_t length) {
    given("the text \"%s\"", obj_show(text, length).chars);
    char *copy = malloc(length); // of just this size: the sanitizers notice a byte too far
    if (length) memcpy(copy, text, length);
    obj_result r;
    memset(&r.m, 0x55, sizeof r.m); // what was there before does not matter
    memset(&r.about, 0x55, sizeof r.about);
    r.done = obj_parse(copy, length, "t.obj", &r.m, &r.about, r.error);
    free(copy);
    const char *fault = obj_fault(r.done, &r.m, &r.about, "t.obj", r.error);
    given("the text \"%s\"\n%s%s", obj_show(text, length).chars, r.error, fault ? fault : "");
    CHECK(!fault, "a sound mesh, or none and one line that says why");
    return r;
}

static obj_result obj_of(const char *text) {
    return obj_of_bytes(text, strlen(text));
}

static void obj_check_error_of(const char *text, size_t length, const char *error) {
    obj_result r = obj_of_bytes(text, length);
    given("the text \"%s\"\nexpected  %s\ngot       %s", obj_show(text, length).chars, error,
          r.done ? "a mesh" : r.error);
    CHECK(!r.done && strcmp(r.error, error) == 0, "the file is refused with this message");
    mesh_free(&r.m);
}

static void obj_check_error(const char *text, const char *error) {
    obj_check_error_of(text, strlen(text), error);
}

static void obj_check_corners(const mesh *m, int i, int a, int b, int c) {
    CHECK_INT(m->corners[i][0], a);
    CHECK_INT(m->corners[i][1], b);
    CHECK_INT(m->corners[i][2], c);
}

// Text that a test puts together.
typedef struct {
    char *chars;
    size_t length, room;
} obj_draft;

static void obj_put(obj_draft *d, const char *format, ...) {
    enum { MOST = 512 }; // bytes that one call may add
    if (d->room - d->length < MOST) {
        d->room = 2 * d->room + MOST;
        d->chars = realloc(d->chars, d->room);
        CHECK(d->chars, "there is memory for the test itself");
    }
    va_list arguments;
    va_start(arguments, format);
    d->length += (size_t)vsnprintf(d->chars + d->length, MOST, format, arguments);
    va_end(arguments);
}

static obj_result obj_of_draft(const obj_draft *d) {
    return obj_of_bytes(d->chars, d->length);
}

// ---- what is understood ----------------------------------------------------------------------

#define THREE_POINTS "v 1.5 -2 3\nv 4 5.25 -6\nv 7 8 9.75\n"

static void obj_statements(void) {
    obj_result r = obj_of("# a house\nmtllib a.mtl\no house\n" THREE_POINTS
                          "v -1e2 .5 +3 1.0\nvn 0 3 4\nvt 0.5 0.5\n\nusemtl brick\ns 1\n"
                          "f 1/1/1 2/1/1 3/1/1\nf 2//-1 4//-1 3//-1\n");
    CHECK_BOOL(r.done, true);
    CHECK_INT(r.m.count, 2);
    obj_check_corners(&r.m, 0, 0, 1, 2);
    obj_check_corners(&r.m, 1, 1, 3, 2);
    CHECK_VEC3(r.m.points[0], ((vec3){(real)1.5, -2, 3}), exactly());
    CHECK_VEC3(r.m.points[1], ((vec3){4, (real)5.25, -6}), exactly());
    CHECK_VEC3(r.m.points[2], ((vec3){7, 8, (real)9.75}), exactly());
    CHECK_VEC3(r.m.points[3], ((vec3){-100, (real)0.5, 3}), exactly());
    CHECK(r.m.normals, "each corner has a normal, so the mesh has");
    for (int i = 0; i < 4; i++)
        CHECK_VEC3(r.m.normals[i], ((vec3){0, (real)0.6, (real)0.8}), exactly());
    CHECK_INT(r.about.skipped, 5);
    CHECK_INT(r.about.polygons + r.about.degenerate + r.about.bare, 0);
    mesh_free(&r.m);
}

// Other ways to write one and the same triangle.
static void obj_lines(void) {
    static const char *const texts[] = {
        THREE_POINTS "f 1 2 3",
        "v 1.5 -2 3\r\nv 4 5.25 -6\r\nv 7 8 9.75\r\nf 1 2 3\r\n",
        "v 1.5 -2 3\rv 4 5.25 -6\rv 7 8 9.75\rf 1 2 3",
        "v 1.5 -2 3\r\nv 4 5.25 -6\nv 7 8 9.75\rf 1 2 3\n\r",
        "\xef\xbb\xbf" THREE_POINTS "f 1 2 3\n",
        "\tv\t1.5\t-2\t3\t\n  v   4 5.25 -6  \nv 7 8 9.75\n\n \t \n\n f 1\t2\t3\n\n",
        "v 1.5 \\\n-2 3\nv 4 5.25 -6\\\n\nv 7 8 9.75\nf 1 2\\\n3\n",
        "v 1.5 \\\r\n-2 3\r\n\\\r\n\\\r\nv 4 5.25 -6\r\nv 7 8 9.75\r\nf \\\r\n1 2 3\\",
        "v \\\r1.5 -2 3\rv 4 5.25 -6\rv 7 8 9.75\rf 1 2 3",
        "# C:\\folder\\\nv 1.5 -2 3 # first\n#v\n#\nv 4 5.25 -6 #\nv 7 8 9.75\nf 1 2 3 # \\\n",
        THREE_POINTS "f 1/1 2/99 3/-7\n",
        THREE_POINTS "f -3 -2 -1\n",
        THREE_POINTS "f -3/1 2 -1/1\n",
        THREE_POINTS "f 00001 0000000000000000000000000000000000000000002 3\n",
        THREE_POINTS "v 0 0 0\nv 0 0 0\nvn 1 1 1\nf 1 2 3\n",
        "v 9 9 9\n" THREE_POINTS "f -3 -2 -1",
        "v 1.5 -2 3 1 1 1 0.5 # white\nv 4 5.25 -6 1\nv 7 8 9.75 0\nvn 1 2 3 4\nf 1 2 3\n",
        "v +15.00e-1 -0002. 3e+0\nv .4E1 5250000e-6 -6\nv 7 8 9.750\nf 1 2 3",
    };
    obj_result first = obj_of(texts[0]);
    CHECK_INT(first.m.count, 1);
    for (int i = 0; i < COUNT(texts); i++) {
        obj_result r = obj_of(texts[i]);
        CHECK_BOOL(r.done, true);
        CHECK(obj_same_mesh(&r.m, &first.m), "the same triangle, written another way");
        CHECK_INT(r.about.skipped, 0);
        mesh_free(&r.m);
    }
    mesh_free(&first.m);
}

static void obj_skipped(void) {
    obj_result r = obj_of("g a b\\\nc\ns off\nvt 1 2\nvp 1 2\nfo 1 2 3\nl 1 2\nfoo\nvnn\nV 1\n"
                          "mtllib C:\\f\n# no\n \n" THREE_POINTS "f 1 2 3\nend");
    CHECK_BOOL(r.done, true);
    CHECK_INT(r.about.skipped, 11);
    CHECK_INT(r.m.count, 1);
    mesh_free(&r.m);
}

// ---- numbers -------------------------------------------------------------------------------

static void obj_check_number(const char *word) {
    const char *fault = obj_number_fault(word);
    real got = NAN;
    obj_number((obj_word){word, word + strlen(word)}, &got);
    given("the word \"%.300s\"\nread as %.17g\n%s", word, (double)got, fault ? fault : "");
    CHECK(!fault, "the nearest number to what is written, as the C library has it");
}

static void obj_numbers(void) {
    // clang-format off
    static const char *const words[] = {
        "0", "-0", "+0", "0.", ".0", "-.0e-7", "0e999999999999999999999", "1", "+1", "-1",
        ".5", "5.", "-5.e0", "1e5", "1E5", "1e+5", "1e-5", "1e05", "1e-999", "-1e-999",
        "1e-99999999999999999999999", "3.4028234e38", "3.4028235e38", "3.40282356e38",
        "1.1754943e-38", "1.4e-45", "7.1e-46", "7e-46", "4.9e-324", "2.4703282292062328e-324",
        "2.4703282292062327e-324", "1.7976931348623157e308", "16777217", "16777217.0000001",
        "16777219", "9007199254740993", "9007199254740992.99999999999999999999999", "0.1",
        "0.30000001192092896", "123456789012345678901234567890", "1.00000005960464477539",
        "1.000000059604644775390625", "1.0000000596046447753906250000000000000000000000001",
        "1000000000000000000000000000000000000e-36", "0.000000000000000000000000000000001e33",
        "8.5899340e9", "1.00000017881393432617187499",
        "1.00000017881393421514957253748434595763683319091796875001",
        // refused
        "", "+", "-", ".", "e", "e5", "1e", "1e+", "1e-", "--1", "+-1", "1-", "1.2.3", "1..2",
        "1e5.", "1e5e5", ".e1", "-.", "+.e", "1+1",
    };
    // clang-format on
    for (int i = 0; i < COUNT(words); i++) obj_check_number(words[i]);
}

// What the library takes for numbers and OBJ does not, or nobody.
static void obj_no_numbers(void) {
    // clang-format off
    static const char *const words[] = {
        "nan",   "NaN",      "-nan",      "nan(1)", "inf",  "-inf",    "Infinity", "0x10",
        "0x1p3", "0X.8p1",   "1,5",       "1;",     "1.5f", "1d5",     "1e5,",     "1_000",
        "1'000", "\xd9\xa3", "1\xc2\xa0", "one",    "1#",   "-1.#IND", "1/2",      "\\",
        "1\\2",  "1\v",      "\f1",       "\"1\"",  "(1",   "+ 1",
    };
    // clang-format on
    for (int i = 0; i < COUNT(words); i++) {
        real x = 1;
        given("the word \"%s\"", obj_show(words[i], strlen(words[i])).chars);
        CHECK_BOOL(obj_number((obj_word){words[i], words[i] + strlen(words[i])}, &x), false);
    }
}

static void obj_random_digits(char *text, size_t room, rng *g) {
    size_t used = 0;
    const int count = 1 + (int)(rng_bits(g) % 30), point = (int)(rng_bits(g) % 40);
    if (rng_bits(g) % 4 == 0) text[used++] = rng_bits(g) % 2 ? '-' : '+';
    for (int i = 0; i < count; i++) {
        if (i == point) text[used++] = '.';
        const bool dull = rng_bits(g) % 4 == 0; // rows of 0 and 9 come near to ties
        text[used++] = (char)('0' + (dull ? 9 * (rng_bits(g) % 2) : rng_bits(g) % 10));
    }
    text[used] = '\0';
    const int most = rng_bits(g) % 4 == 0 ? 360 : 25;
    const int exponent = (int)(rng_bits(g) % (2 * (unsigned)most)) - most;
    if (rng_bits(g) % 2) snprintf(text + used, room - used, "e%d", exponent);
}

// A float or double of any size, or the middle between two floats or nearly, with few digits
// or with enough.
static void obj_random_value(char *text, size_t room, rng *g) {
    const uint64_t high = rng_bits(g), bits = high << 32 | rng_bits(g);
    double x;
    memcpy(&x, &bits, sizeof x);
    if (rng_bits(g) % 2) x = ldexp(rng_double(g) - 0.5, (int)(rng_bits(g) % 250) - 125);
    const float f = (float)x;
    const unsigned kind = rng_bits(g) % 4;
    if (kind == 0) x = (double)f;
    if (kind == 1) x = ((double)f + (double)nextafterf(f, INFINITY)) / 2;
    if (kind == 2) x = nextafter(((double)f + (double)nextafterf(f, INFINITY)) / 2, (double)f);
    if (!isfinite(x)) x = 0;
    const bool style = rng_bits(g) % 2;
    snprintf(text, room, style ? "%.*g" : "%.*e", (int)(rng_bits(g) % 60), x);
}

static void obj_random_numbers(void) {
    rng g = check_rng(1201);
    char text[512];
    for (int i = 0; i < 100000; i++) {
        obj_random_digits(text, sizeof text, &g);
        obj_check_number(text);
        obj_random_value(text, sizeof text, &g);
        obj_check_number(text);
    }
}

// The middle between two neighbours is exact in up to 768 digits: one digit far behind decides.
static void obj_ties(void) {
    rng g = check_rng(1202);
    static char text[2000];
    for (int i = 0; i < 3000; i++) {
        const bool wide = i % 2;                  // between doubles, or between floats
        if (wide && LDBL_MANT_DIG < 64) continue; // no type holds their middle
        const int any = (int)(rng_bits(&g) % (wide ? 2097 : 276)) - (wide ? 1074 : 149);
        const int e = i >= 200 ? any : wide ? -1022 : -126; // there the digits are most
        const double x = ldexp(1 + rng_double(&g), e);
        const int half = wide ? (e > -1022 ? e : -1022) - 53 : (e > -126 ? e : -126) - 24;
        const long double first = wide ? x : (double)(float)x;
        snprintf(text, sizeof text - 900, "%.800Le", first + ldexpl(1, half));
        obj_check_number(text);
        char *exponent = strchr(text, 'e'), rest[16];
        strcpy(rest, exponent);
        const int zeros = (int)(rng_bits(&g) % 800);
        memset(exponent, '0', (size_t)zeros);
        snprintf(exponent + zeros, 32, "1%s", rest);
        obj_check_number(text);
    }
}

// Digits beyond all limits, and exponents that bring them back.
static void obj_long_numbers(void) {
    enum { ZEROS = 1000000 };
    static char text[2 * ZEROS];
    for (int kind = 0; kind < 4; kind++) {
        const char *begin = kind % 2 ? "-0." : "1", *end = kind % 2 ? "25e" : "e-";
        const size_t first = strlen(begin);
        strcpy(text, begin);
        memset(text + first, '0', ZEROS);
        snprintf(text + first + ZEROS, 64, "%s%d", end, kind < 2 ? ZEROS : 10 * ZEROS);
        real x = 7;
        given("\"%s\", %d zeros, \"%s\"", begin, ZEROS, text + first + ZEROS);
        CHECK_BOOL(obj_number((obj_word){text, text + strlen(text)}, &x), true);
        const double expected[] = {1, -0.25, 0, -INFINITY};
        CHECK_REAL(x, expected[kind], exactly());
    }
}

static void obj_locale(void) {
    static const char *const comma[] = {"de_DE.UTF-8", "de_DE.utf8",  "sv_SE.UTF-8",
                                        "sv_SE.utf8",  "fr_FR.UTF-8", "de_DE"};
    for (int i = 0; i < COUNT(comma); i++)
        if (setlocale(LC_ALL, comma[i])) break;
    real x = 0; // more digits than one operation rounds
    const char *word = "0.12345678901234567890123456789";
    given("\"%s\" in the locale %s", word, setlocale(LC_ALL, NULL));
    CHECK_BOOL(obj_number((obj_word){word, word + strlen(word)}, &x), true);
    CHECK_REAL(x, (real)0.12345678901234567890123456789, exactly());
    x = 0;
    CHECK_BOOL(obj_number((obj_word){"1,5", (const char *)"1,5" + 3}, &x), false);
    setlocale(LC_ALL, "C");
}

// ---- what is refused -------------------------------------------------------------------------

static void obj_broken_points(void) {
    static const char *const rows[][2] = {
        {"v 1 2", "t.obj:1: v: expected three numbers, got 2"},
        {"v", "t.obj:1: v: expected three numbers, got 0"},
        {"\n# c\nv 1 # 2 3\n", "t.obj:3: v: expected three numbers, got 1"},
        {THREE_POINTS "v 1 x 3\n", "t.obj:4: v: expected a number, got \"x\""},
        {"v nan 1 2", "t.obj:1: v: expected a number, got \"nan\""},
        {"v 0 inf 2", "t.obj:1: v: expected a number, got \"inf\""},
        {"v 0 1 -Infinity", "t.obj:1: v: expected a number, got \"-Infinity\""},
        {"v 0x10 1 2", "t.obj:1: v: expected a number, got \"0x10\""},
        {"v 1,5 2 3", "t.obj:1: v: expected a number, got \"1,5\""},
        {"v 1,2,3", "t.obj:1: v: expected a number, got \"1,2,3\""},
        {"v 1 2 3 red", "t.obj:1: v: expected a number, got \"red\""},
        {"v 1 2 \\ 3", "t.obj:1: v: expected a number, got \"\\\""},
        {"v 1e999 2 3", "t.obj:1: v: 1e999 is too large for " REAL_NAME},
        {"v 1 2 -1e999", "t.obj:1: v: -1e999 is too large for " REAL_NAME},
        {"v 1 2 3 1e999", "t.obj:1: v: 1e999 is too large for " REAL_NAME},
        {"v 1 2 3\r\nv 1 2\r\n", "t.obj:2: v: expected three numbers, got 2"},
        {"v 1 2 3\rv 1 2\r", "t.obj:2: v: expected three numbers, got 2"},
        {"v 1 2 3\nv 1 \\\n\\\n2\nv 1", "t.obj:2: v: expected three numbers, got 2"},
        {"g \\\n a \\\n b\nv 1 \\\n z 1\n", "t.obj:4: v: expected a number, got \"z\""},
        {"v 1 2\x1b[31m 3", "t.obj:1: v: expected a number, got \"2?[31m\""},
        {"v \xd9\xa3 2 3", "t.obj:1: v: expected a number, got \"??\""},
        {"v 123456789012345678901234567890123456789012345678x 2 3",
         "t.obj:1: v: expected a number, got \"1234567890123456789012345678901234567890...\""},
        {"v 123456789012345678901234567890123456789x 2 3",
         "t.obj:1: v: expected a number, got \"123456789012345678901234567890123456789x\""},
        {"vn 1 0", "t.obj:1: vn: expected three numbers, got 2"},
        {"vn 1 0 z", "t.obj:1: vn: expected a number, got \"z\""},
        {"vn nan nan nan", "t.obj:1: vn: expected a number, got \"nan\""},
        {"vn 1 0 1e999", "t.obj:1: vn: 1e999 is too large for " REAL_NAME},
        {"vn 0 0 0", "t.obj:1: vn: a normal of length 0"},
        {"vn 1e-999 -0 0.0", "t.obj:1: vn: a normal of length 0"},
    };
    for (int i = 0; i < COUNT(rows); i++) obj_check_error(rows[i][0], rows[i][1]);
    if (sizeof(real) == sizeof(float))
        obj_check_error("v 1 2 3.4028236e38",
                        "t.obj:1: v: 3.4028236e38 is too large for float");
}

#define LIKE "t.obj:4: f: expected a corner like 1, 1/2, 1//3 or 1/2/3, got "
#define NO_POINT(i) "t.obj:4: f: there is no point " i " (points above: 3)"

static void obj_broken_faces(void) {
    static const char *const rows[][2] = {
        {"f", "t.obj:4: f: expected three corners or more, got 0"},
        {"f 1", "t.obj:4: f: expected three corners or more, got 1"},
        {"f 1 2", "t.obj:4: f: expected three corners or more, got 2"},
        {"f 1 2 # 3", "t.obj:4: f: expected three corners or more, got 2"},
        {"f 1 2\nf 3\n", "t.obj:4: f: expected three corners or more, got 2"},
        {"f 1 \\\n\\\n2", "t.obj:4: f: expected three corners or more, got 2"},
        {"f 0 1 2", "t.obj:4: f: there is no point 0, the first is 1"},
        {"f 1 2 -0", "t.obj:4: f: there is no point 0, the first is 1"},
        {"f 1 2 4", NO_POINT("4")},
        {"f 4 1 2\nv 1 2 3\n", NO_POINT("4")},
        {"f 1 2 3 99", NO_POINT("99")},
        {"f -4 1 2", NO_POINT("-4")},
        {"f 2147483647 1 2", NO_POINT("2147483647")},
        {"f 2147483648 1 2", NO_POINT("2147483648")},
        {"f 2147483649 1 2", NO_POINT("2147483649")},
        {"f -2147483648 1 2", NO_POINT("-2147483648")},
        {"f -2147483649 1 2", NO_POINT("-2147483649")},
        {"f 4294967297 1 2", NO_POINT("4294967297")},
        {"f 9223372036854775807 1 2", NO_POINT("9223372036854775807")},
        {"f -9223372036854775808 1 2", NO_POINT("-9223372036854775808")},
        {"f 18446744073709551617 2 3", NO_POINT("18446744073709551617")},
        {"f -18446744073709551615 2 3", NO_POINT("-18446744073709551615")},
        {"f 99999999999999999999999999999999999999999999999 1 2",
         NO_POINT("9999999999999999999999999999999999999999...")},
        {"f 1//1 2//1 3//1", "t.obj:4: f: there is no normal 1 (normals above: 0)"},
        {"f 1/1/1 2 3", "t.obj:4: f: there is no normal 1 (normals above: 0)"},
        {"f 1//-1 2 3", "t.obj:4: f: there is no normal -1 (normals above: 0)"},
        {"f 1//0 2 3", "t.obj:4: f: there is no normal 0, the first is 1"},
        {"f 1 2 3//18446744073709551616\nvn 1 1 1",
         "t.obj:4: f: there is no normal 18446744073709551616 (normals above: 0)"},
        {"f 1 2 x", LIKE "\"x\""},
        {"f 1 2 +3", LIKE "\"+3\""},
        {"f 1 2 3.0", LIKE "\"3.0\""},
        {"f 1,2,3", LIKE "\"1,2,3\""},
        {"f 1/ 2/ 3/", LIKE "\"1/\""},
        {"f 1// 2 3", LIKE "\"1//\""},
        {"f 1/1/ 2 3", LIKE "\"1/1/\""},
        {"f /1 2 3", LIKE "\"/1\""},
        {"f / 2 3", LIKE "\"/\""},
        {"f 1/1/1/1 2 3", LIKE "\"1/1/1/1\""},
        {"f 1//1/1 2 3", LIKE "\"1//1/1\""},
        {"f 1/x 2 3", LIKE "\"1/x\""},
        {"f 1//-", LIKE "\"1//-\""},
        {"f - 2 3", LIKE "\"-\""},
        {"f --1 2 3", LIKE "\"--1\""},
        {"f 1 2 3 \xff\x01\x7f", LIKE "\"???\""},
        {"f 1e0 2 3", LIKE "\"1e0\""},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        char text[200];
        snprintf(text, sizeof text, THREE_POINTS "%s", rows[i][0]);
        obj_check_error(text, rows[i][1]);
    }
    obj_check_error("f 1 2 3", "t.obj:1: f: there is no point 1 (points above: 0)");
    obj_check_error("f -1 -1 -1", "t.obj:1: f: there is no point -1 (points above: 0)");
}

static void obj_no_triangle(void) {
    obj_check_error("", "t.obj: no triangle (points: 0, triangles without area: 0)");
    obj_check_error("\n", "t.obj: no triangle (points: 0, triangles without area: 0)");
    obj_check_error("\\", "t.obj: no triangle (points: 0, triangles without area: 0)");
    obj_check_error("\xef\xbb\xbf",
                    "t.obj: no triangle (points: 0, triangles without area: 0)");
    obj_check_error("hello", "t.obj: no triangle (points: 0, triangles without area: 0)");
    obj_check_error(THREE_POINTS, "t.obj: no triangle (points: 3, triangles without area: 0)");
    obj_check_error(THREE_POINTS "f 1 1 2 2",
                    "t.obj: no triangle (points: 3, triangles without area: 2)");
    obj_draft d = {0};
    for (int i = 0; i < 1000000; i++) obj_put(&d, "v %d 1 2\n", i);
    obj_check_error_of(d.chars, d.length,
                       "t.obj: no triangle (points: 1000000, triangles without area: 0)");
    free(d.chars);
}

static void obj_binary(void) {
    obj_check_error_of("\0", 1, "t.obj:1: a byte 0: this is no text");
    obj_check_error_of("v 1 2 3\nv 1\0 2 3", 16, "t.obj:2: a byte 0: this is no text");
    obj_check_error_of("\r\n\\\n\n\rg\0\n", 9, "t.obj:5: a byte 0: this is no text");
    obj_check_error_of("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16,
                       "t.obj:3: a byte 0: this is no text");
    obj_check_error_of("\xff\xfev\0 \0"
                       "1\0",
                       8, "t.obj:1: a byte 0: this is no text"); // UTF-16
    obj_check_error("\x7f"
                    "ELF\x02\x01\x01", // junk without a 0
                    "t.obj: no triangle (points: 0, triangles without area: 0)");
    rng g = check_rng(1203);
    for (int i = 0; i < 2000; i++) {
        char text[300];
        const size_t length = rng_bits(&g) % sizeof text;
        const bool zeros = rng_bits(&g) % 2;
        for (size_t k = 0; k < length; k++) {
            const unsigned byte = rng_bits(&g) & 255;
            text[k] = (char)(byte || zeros ? byte : 1);
        }
        obj_result r = obj_of_bytes(text, length);
        mesh_free(&r.m);
    }
}

// Cut anywhere, a file is read or refused with a line that it has.
static void obj_truncated(void) {
    static const char text[] = "# cut\nv 1.5 -2 3e0\r\nv 4 5.25 -6\nvn 0 1 0\nv 7 8 9.75\\\n\n"
                               "f 1//1 2//1 \\\n 3//1\nf 3 2 1 2\n";
    for (size_t length = 0; length < sizeof text; length++) {
        obj_result r = obj_of_bytes(text, length);
        if (!r.done && strncmp(r.error, "t.obj: no tri", 13) != 0)
            CHECK(strtol(r.error + 6, NULL, 10) >= 2 && strtol(r.error + 6, NULL, 10) <= 9,
                  "the broken line is one of the file's");
        mesh_free(&r.m);
    }
}

// A name is shown as it is; of a long one the end, and nothing that moves the cursor.
static void obj_names(void) {
    char name[5000], error[OBJ_ERROR];
    mesh m;
    obj_report about;
    given("a name with control characters");
    CHECK_BOOL(obj_parse("v 1", 3, "a\nb\x1b[2J%s\xc3\xa5.obj", &m, &about, error), false);
    CHECK(!strcmp(error, "a?b?[2J%s\xc3\xa5.obj:1: v: expected three numbers, got 1"), "as ?");
    memset(name, 'a', sizeof name - 1);
    strcpy(name + sizeof name - 6, "z.obj");
    given("a name of 4999 characters");
    CHECK_BOOL(obj_parse("v 1", 3, name, &m, &about, error), false);
    CHECK(!strncmp(error, "...aaa", 6), "its end, behind ...");
    CHECK_INT(strlen(error), 103 + strlen(":1: v: expected three numbers, got 1"));
    CHECK(strstr(error, "az.obj:1: v: expected three numbers, got 1"), "the message is whole");
    CHECK_BOOL(obj_read(name, &m, &about, error), false);
    CHECK(strstr(error, "az.obj: "), "the same for a file");
}

// ---- shape -------------------------------------------------------------------------------

static void obj_fans(void) {
    obj_result r = obj_of("v 0 0 0\nv 3 0 0\nv 4 2 0\nv 2 4 0\nv -1 2 0\n"
                          "f 1 2 3 4 5\nf 2 3 4 5\nf 3 4 5\n");
    CHECK_INT(r.m.count, 6);
    CHECK_INT(r.about.polygons, 2);
    obj_check_corners(&r.m, 0, 0, 1, 2);
    obj_check_corners(&r.m, 1, 0, 2, 3);
    obj_check_corners(&r.m, 2, 0, 3, 4);
    obj_check_corners(&r.m, 3, 1, 2, 3);
    obj_check_corners(&r.m, 4, 1, 3, 4);
    obj_check_corners(&r.m, 5, 2, 3, 4);
    mesh_free(&r.m);
}

// -1 is the last point above the face, not of the file.
static void obj_from_the_end(void) {
    obj_result r = obj_of("v 0 0 0\nv 3 0 1\nv 0 2 0\nf -3 -2 -1\nv 1 1 4\nf -3 -2 -1\n"
                          "v 5 0 5\nv 0 5 5\nf -1 1 -2\n");
    CHECK_INT(r.m.count, 3);
    obj_check_corners(&r.m, 0, 0, 1, 2);
    obj_check_corners(&r.m, 1, 1, 2, 3);
    obj_check_corners(&r.m, 2, 5, 0, 4);
    mesh_free(&r.m);
}

static void obj_degenerate(void) {
    obj_result r = obj_of("v 0 0 0\nv 1 1 1\nv 2 2 2\nv 3 0 0\nv 0 0 0\nv 3 0 0\n"
                          "f 1 1 1\nf 1 2 2\nf 1 2 1\nf 1 2 3\nf 1 5 4\nf 4 6 2\n" // 6 without
                          "f 1 2 4\n"                                              // 1 with
                          "f 1 2 3 4\n"   // 1 without, 1 with
                          "f 1 1 2 4 4\n" // 1 without, 1 with, 1 without
                          "f 2 2 2 2\n"); // 2 without
    CHECK_BOOL(r.done, true);
    CHECK_INT(r.m.count, 3);
    CHECK_INT(r.about.degenerate, 11);
    CHECK_INT(r.about.polygons, 3);
    obj_check_corners(&r.m, 0, 0, 1, 3); // of the points 1 to 4
    obj_check_corners(&r.m, 1, 0, 2, 3);
    obj_check_corners(&r.m, 2, 0, 1, 3);
    CHECK_INT(obj_points(&r.m), 4);
    mesh_free(&r.m);
}

// Points that coincide stay two; tiny and huge triangles have area, and a sphere around them,
// unless it is too large for real.
static void obj_sizes(void) {
    obj_result r = obj_of("v 0 0 0\nv 1e-38 0 0\nv 0 1e-38 0\nv 0 0 0\n"
                          "v 3e38 3e38 0\nv -3e38 3e38 0\nv -3e38 -3e38 3e38\n"
                          "f 1 2 3\nf 4 3 2\nf 5 6 7\n");
    CHECK_INT(r.m.count, 3);
    obj_check_corners(&r.m, 1, 3, 2, 1);
    mesh_free(&r.m);
}

static void obj_around(void) {
    rng g = check_rng(1204);
    for (int i = 0; i < 200; i++) {
        obj_draft d = {0};
        const double size = pow(10, between(&g, -6, 9)), off = pow(10, between(&g, -6, 9));
        for (int k = 0; k < 12; k++) {
            const vec3 p = in_cube(&g);
            obj_put(&d, "v %.17g %.17g %.17g\n", off + size * p.x, size * p.y, p.z * off);
        }
        obj_put(&d, "v 1e30 0 0\nf 1 2 3 4 5 6 7 8 9 10 11 12\n"); // 1e30 is not used
        obj_result r = obj_of_draft(&d); // obj_fault looks whether the sphere holds all
        if (r.done) {
            vec3 low = r.m.points[0], high = low;
            for (int k = 1; k < obj_points(&r.m); k++) {
                const vec3 p = r.m.points[k];
                low = (vec3){fmin(low.x, p.x), fmin(low.y, p.y), fmin(low.z, p.z)};
                high = (vec3){fmax(high.x, p.x), fmax(high.y, p.y), fmax(high.z, p.z)};
            }
            CHECK(r.m.around.r > 0, "known");
            CHECK_AT_MOST(r.m.around.r, 0.5001 * wide_length(sub(high, low)),
                          "no wider than the box of the points");
        }
        mesh_free(&r.m);
        free(d.chars);
    }
}

// ---- normals -----------------------------------------------------------------------------

static void obj_units(void) {
    rng g = check_rng(1205);
    for (int i = 0; i < 2000; i++) {
        const double most = sizeof(real) == sizeof(float) ? 36 : 300;
        const double size = i % 2 ? pow(10, between(&g, -most, most)) : 1;
        const vec3 u = generic_unit(&g);
        obj_draft d = {0};
        obj_put(&d, THREE_POINTS "vn %.17g %.17g %.17g\nf 1//1 2//1 3//1\n", size * u.x,
                size * u.y, size * u.z);
        obj_result r = obj_of_draft(&d);
        CHECK_BOOL(r.done, true);
        if (i % 2)
            CHECK_VEC3(r.m.normals[0], u, roundings(12, "read, scaled, divided by its length"));
        else
            CHECK_VEC3(r.m.normals[0], u, exactly()); // unit already: not touched
        mesh_free(&r.m);
        free(d.chars);
    }
}

static void obj_unit_extremes(void) {
    obj_result r = obj_of(THREE_POINTS "vn 1e-44 0 0\nvn 3e38 -3e38 3e38\nvn 0 0 -1.4e-45\n"
                                       "f 1//1 2//2 3//3\n");
    const real s = (real)0.57735026918962576451;
    CHECK_BOOL(r.done, true);
    CHECK_VEC3(r.m.normals[0], ((vec3){1, 0, 0}), exactly());
    CHECK_VEC3(r.m.normals[1], ((vec3){s, -s, s}), roundings(4, "one rounding each, and ours"));
    CHECK_VEC3(r.m.normals[2], ((vec3){0, 0, -1}), exactly());
    mesh_free(&r.m);
}

static void obj_splits(void) {
    obj_result r = obj_of("v 0 0 0\nv 9 9 9\nv 1 0 0\nv 1 1 0\nv 0 1 2\n"
                          "vn 0 0 1\nvn 0 1 0\nvn 1 0 0\nvn 0 0 1\n"
                          "f 1//1 3//1 4//2\n"    // 0 1 2: first uses
                          "f 1//2 4//2 5//1\n"    // 4 2 3: 1 with another
                          "f 4//1 5//1 1//1\n"    // 5 3 0: 4 with another
                          "f 4//1 1//2 3//3\n"    // 5 4 6: seen before; 3 with another
                          "f 3//4 4//-4 5//1\n"); // 7 5 3: equal, but another of the file
    CHECK_BOOL(r.done, true);
    CHECK_INT(r.m.count, 5);
    obj_check_corners(&r.m, 0, 0, 1, 2);
    obj_check_corners(&r.m, 1, 4, 2, 3);
    obj_check_corners(&r.m, 2, 5, 3, 0);
    obj_check_corners(&r.m, 3, 5, 4, 6);
    obj_check_corners(&r.m, 4, 7, 5, 3);
    static const int point[] = {0, 1, 2, 3, 0, 2, 1, 1}, normal[] = {2, 2, 1, 2, 1, 2, 0, 2};
    const vec3 points[] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 2}};
    const vec3 axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int i = 0; i < COUNT(point); i++) {
        given("point %d of the mesh", i);
        CHECK_VEC3(r.m.points[i], points[point[i]], exactly());
        CHECK_VEC3(r.m.normals[i], axes[normal[i]], exactly());
    }
    mesh_free(&r.m);
}

// Every corner of every triangle keeps the point and the normal that the file gives it, and no
// two points of the mesh are the same pair.
static void obj_splits_at_random(void) {
    enum { POINT_COUNT = 60, NORMAL_COUNT = 40, FACES = 3000 };
    static int p[FACES][3], n[FACES][3];
    rng g = check_rng(1206);
    obj_draft d = {0};
    vec3 points[POINT_COUNT], normals[NORMAL_COUNT];
    for (int i = 0; i < POINT_COUNT; i++) {
        points[i] = in_cube(&g);
        obj_put(&d, "v %.17g %.17g %.17g\n", ARG(points[i]));
    }
    for (int i = 0; i < NORMAL_COUNT; i++) {
        normals[i] = generic_unit(&g);
        obj_put(&d, "vn %.17g %.17g %.17g\n", ARG(normals[i]));
    }
    for (int i = 0; i < FACES; i++) {
        obj_put(&d, "f");
        for (int k = 0; k < 3; k++) {
            p[i][k] = (int)(rng_bits(&g) % (POINT_COUNT / 3)) + k * POINT_COUNT / 3;
            n[i][k] = (int)(rng_bits(&g) % NORMAL_COUNT);
            obj_put(&d, " %d//%d", p[i][k] + 1, n[i][k] + 1);
        }
        obj_put(&d, "\n");
    }
    obj_result r = obj_of_draft(&d);
    CHECK_INT(r.m.count, FACES);
    static int seen[POINT_COUNT][NORMAL_COUNT]; // index in the mesh + 1
    int pairs = 0;
    for (int i = 0; i < FACES; i++)
        for (int k = 0; k < 3; k++) {
            const int c = r.m.corners[i][k];
            int *known = &seen[p[i][k]][n[i][k]];
            if (!*known) *known = c + 1, pairs++;
            CHECK_INT(c, *known - 1);
            CHECK_VEC3(r.m.points[c], points[p[i][k]], exactly());
            CHECK_VEC3(r.m.normals[c], normals[n[i][k]], exactly());
        }
    CHECK_INT(obj_points(&r.m), pairs);
    mesh_free(&r.m);
    free(d.chars);
}

static void obj_bare(void) {
    obj_result r = obj_of("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 0 0 1\nvn 1 1 1\n"
                          "f 1//1 2//2 3//2\nf 1//2 2/1 3/5\nf 2//1 3//1 4//1 1\n");
    CHECK_BOOL(r.done, true);
    CHECK_INT(r.about.bare, 3);
    CHECK(!r.m.normals, "flat: three corners have no normal");
    CHECK_INT(r.m.count, 4);
    CHECK_INT(obj_points(&r.m), 4); // nothing is split
    mesh_free(&r.m);
    r = obj_of("vn 0 0 1\n" THREE_POINTS "f 1 2 3\n"); // normals, but no corner has one
    CHECK(r.done && !r.m.normals, "flat");
    CHECK_INT(r.about.bare, 0);
    mesh_free(&r.m);
}

// ---- what comes back -----------------------------------------------------------------------

static void obj_round_trip(void) {
    rng g = check_rng(1207);
    for (int i = 0; i < 20; i++) {
        const vec3 centre = scale((real)pow(10, between(&g, -3, 6)), in_cube(&g));
        const vec3 axis = scale((real)between(&g, 0.1, 10), generic_unit(&g));
        mesh torus = mesh_torus(centre, axis, 3, 1, 3 + 4 * i, 3 + i);
        const int digits = sizeof(real) == sizeof(float) ? 9 : 17;
        obj_draft d = {0};
        for (int k = 0; k < torus.count / 2; k++) {
            const vec3 p = torus.points[k], n = torus.normals[k];
            obj_put(&d, "v %.*g %.*g %.*g\n", digits, (double)p.x, digits, (double)p.y, digits,
                    (double)p.z);
            obj_put(&d, "vn %.*g %.*g %.*g\n", digits, (double)n.x, digits, (double)n.y, digits,
                    (double)n.z);
        }
        for (int k = 0; k < torus.count; k++) {
            const int *c = torus.corners[k];
            obj_put(&d, "f %d//%d %d//%d %d//%d\n", c[0] + 1, c[0] + 1, c[1] + 1, c[1] + 1,
                    c[2] + 1, c[2] + 1);
        }
        obj_result r = obj_of_draft(&d);
        given("a torus of %d triangles around " VEC, torus.count, ARG(centre));
        CHECK_BOOL(r.done, true);
        CHECK_INT(r.about.degenerate, 0);
        CHECK(obj_same_mesh(&r.m, &torus), "what was written comes back, bit for bit");
        mesh_free(&r.m);
        mesh_free(&torus);
        free(d.chars);
    }
}

// ---- large files -----------------------------------------------------------------------------

static void obj_long_lines(void) {
    enum { MANY = 1000000 };
    obj_draft d = {0};
    obj_put(&d, THREE_POINTS "# ");
    for (int i = 0; i < MANY / 10; i++) obj_put(&d, "0123456789");
    obj_put(&d, "\nunknown");
    for (int i = 0; i < MANY / 10; i++) obj_put(&d, " 345 \\ 89");
    obj_put(&d, "\nf 1 2");
    for (int i = 0; i < MANY; i++) obj_put(&d, " \\\n");
    obj_put(&d, "3");
    for (int i = 0; i < MANY; i++) obj_put(&d, " ");
    obj_put(&d, "\nv 1 2 3");
    for (int i = 0; i < MANY; i++) obj_put(&d, " 4");
    obj_put(&d, "\nf 1 2 0000000000000000");
    for (int i = 0; i < MANY; i++) obj_put(&d, "0");
    obj_put(&d, "3");
    obj_result r = obj_of_draft(&d);
    CHECK_BOOL(r.done, true);
    CHECK_INT(r.m.count, 2);
    CHECK_INT(r.about.skipped, 1);
    mesh_free(&r.m);
    obj_put(&d, "\nf ");
    for (int i = 0; i < MANY; i++) obj_put(&d, "x");
    char error[OBJ_ERROR];
    snprintf(error, sizeof error,
             "t.obj:%d: f: expected a corner like 1, 1/2, 1//3 or 1/2/3, got "
             "\"xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx...\"",
             MANY + 9);
    obj_check_error_of(d.chars, d.length, error);
    free(d.chars);
}

static void obj_large_face(void) {
    enum { MANY = 1000000 };
    obj_draft d = {0};
    for (int i = 0; i < MANY; i++) obj_put(&d, "v %d %d.5 1\n", i, i % 1009 * (i % 1009));
    obj_put(&d, "f");
    for (int i = 0; i < MANY; i++) obj_put(&d, " %d", i + 1);
    obj_result r = obj_of_draft(&d);
    CHECK_BOOL(r.done, true);
    CHECK_INT(r.m.count + r.about.degenerate, MANY - 2);
    CHECK_INT(r.about.polygons, 1);
    obj_check_corners(&r.m, r.m.count - 1, 0, MANY - 2, MANY - 1);
    mesh_free(&r.m);
    free(d.chars);
}

// One point with very many normals, as a fan has: each is found at once.
static void obj_many_normals(void) {
    enum { MANY = 200000 };
    obj_draft d = {0};
    obj_put(&d, "v 0 0 0\nv 1 0 0\nv 0 1 0\n");
    for (int i = 0; i < MANY; i++)
        obj_put(&d, "vn %d 1 1\nf 1//-1 2//%d 3//-1\n", i, 1 + i / 2);
    obj_result r = obj_of_draft(&d);
    CHECK_BOOL(r.done, true);
    CHECK_INT(r.m.count, MANY);
    CHECK_INT(obj_points(&r.m), MANY + MANY / 2 + MANY);
    mesh_free(&r.m);
    free(d.chars);
}

#if defined(__SANITIZE_ADDRESS__)
#define OBJ_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define OBJ_SANITIZED 1
#endif
#endif

// With less memory than it takes, however little: one line, and no mesh.
static void obj_no_memory(void) {
#ifndef OBJ_SANITIZED // whose own memory the limit would count
    obj_draft d = {0};
    obj_put(&d, "v 0 0 0\nv 1 0 0\nv 0 1 0\n");
    for (int i = 0; i < 60000; i++) // most is needed for the 180,000 points that these become
        obj_put(&d, "vn %d 1 1\nf 1//-1 2//-1 3//-1\n", i);
    for (rlim_t most = 1 << 20;; most += 1 << 18) {
        struct rlimit limit;
        getrlimit(RLIMIT_AS, &limit);
        limit.rlim_cur = most;
        if (setrlimit(RLIMIT_AS, &limit) != 0) break;
        obj_result r;
        r.done = obj_parse(d.chars, d.length, "t.obj", &r.m, &r.about, r.error);
        limit.rlim_cur = limit.rlim_max;
        setrlimit(RLIMIT_AS, &limit);
        given("%ld KiB of memory\n%s", (long)(most >> 10), r.error);
        if (r.done) {
            mesh_free(&r.m);
            break;
        }
        CHECK(!strncmp(r.error, "t.obj: no memory for ", 21), "the message says so");
        CHECK(!obj_error_fault(&r.m, "t.obj", r.error), "the mesh is empty");
        CHECK(most < (rlim_t)4 << 30, "it is enough at last");
    }
    free(d.chars);
#endif
}

// ---- files ---------------------------------------------------------------------------------

static obj_result obj_of_file(const char *path) {
    obj_result r;
    r.done = obj_read(path, &r.m, &r.about, r.error);
    given("the file %s\n%s", path, r.error);
    const char *fault = obj_fault(r.done, &r.m, &r.about, path, r.error);
    CHECK(!fault, fault ? fault : "a sound mesh, or one line that says why not");
    return r;
}

static void obj_check_refused(const char *path, const char *why) {
    obj_result r = obj_of_file(path);
    char expected[OBJ_ERROR];
    snprintf(expected, sizeof expected, "%s: %s", path, why);
    given("the file %s\nexpected  %s\ngot       %s", path, expected,
          r.done ? "a mesh" : r.error);
    CHECK(!r.done && !strcmp(r.error, expected), "the reason is the system's");
}

static void obj_bad_files(void) {
    obj_check_refused("no/such/file.obj", "No such file or directory");
    obj_check_refused("no-such-file.obj", "No such file or directory");
    obj_check_refused("", "No such file or directory");
    obj_check_refused("tests", "Is a directory");
    obj_check_refused("Makefile/a.obj", "Not a directory");
    if (access("/proc/self/mem", R_OK) == 0)
        obj_check_refused("/proc/self/mem", "Input/output error");
    obj_check_refused("/dev/null", "no triangle (points: 0, triangles without area: 0)");
}

// A pipe has no size beforehand, and gives a part at a time.
static void obj_pipe(void) {
    int ends[2];
    CHECK(pipe(ends) == 0, "there is a pipe");
    const pid_t writer = fork();
    if (writer == 0) {
        FILE *to = fdopen(ends[1], "w");
        for (int i = 0; i < 30000; i++) fprintf(to, "v %d %d 0.5\n", i, i * i % 1009);
        for (int i = 0; i < 29998; i++) fprintf(to, "f %d %d %d\n", i + 1, i + 2, i + 3);
        fflush(to);
        _exit(0);
    }
    close(ends[1]);
    char path[40];
    snprintf(path, sizeof path, "/dev/fd/%d", ends[0]);
    obj_result r = obj_of_file(path);
    CHECK_BOOL(r.done, true);
    CHECK_INT(r.m.count + r.about.degenerate, 29998);
    mesh_free(&r.m);
}

// What the fuzzer found and its table of what is expected; all others say it in their first line.
typedef struct {
    const char *file, *expected;
} obj_find;
static const obj_find obj_finds[] = {
    {"", ""},
};

static void obj_expected(const char *file, const char *path, char *words, size_t room) {
    for (int i = 0; i < COUNT(obj_finds); i++)
        if (!strcmp(obj_finds[i].file, file)) {
            snprintf(words, room, "%s", obj_finds[i].expected);
            return;
        }
    char line[400] = "";
    FILE *text = fopen(path, "rb");
    CHECK(text && fread(line, 1, sizeof line - 1, text) > 0, "the file can be read");
    fclose(text);
    const char *begin = strchr(line, '#');
    CHECK(begin, "its first line is a comment that says what is expected");
    snprintf(words, room, "%.*s", (int)strcspn(begin + 2, "\r\n"), begin + 2);
}

static void obj_all_files(void) {
    const char *folder = "tests/12-bvh/obj";
    DIR *all = opendir(folder);
    given("the folder %s", folder);
    CHECK(all, "it is there: run the tests in the course's top folder");
    int count = 0;
    for (struct dirent *entry; (entry = readdir(all));) {
        if (!strstr(entry->d_name, ".obj")) continue;
        char path[400], expected[300], got[300];
        snprintf(path, sizeof path, "%s/%s", folder, entry->d_name);
        obj_expected(entry->d_name, path, expected, sizeof expected);
        obj_result r = obj_of_file(path);
        if (r.done)
            snprintf(got, sizeof got, "read: %d triangles, %d points", r.m.count,
                     obj_points(&r.m));
        else
            snprintf(got, sizeof got, "refused: %s", r.error);
        given("%s\nexpected  %s\ngot       %s", path, expected, got);
        CHECK(!strcmp(expected, got), "read or refused as it says");
        mesh_free(&r.m);
        count++;
    }
    closedir(all);
    CHECK(count >= 8, "all files are there");
}

// ---- rows ----------------------------------------------------------------------------------

#define OBJ_HINT "obj.h says what is understood, and what is broken."
#define OBJ_TESTS                                                                            \
    {"obj: points, normals and faces", obj_statements, OBJ_HINT},                            \
        {"obj: one triangle, written in many ways", obj_lines, OBJ_HINT},                    \
        {"obj: what is skipped is counted", obj_skipped, OBJ_HINT},                          \
        {"obj: numbers", obj_numbers, OBJ_HINT},                                             \
        {"obj: what is no number", obj_no_numbers, OBJ_HINT},                                \
        {"obj: 200,000 random numbers are correctly rounded", obj_random_numbers, OBJ_HINT}, \
        {"obj: numbers at ties, a far digit decides", obj_ties, OBJ_HINT},                   \
        {"obj: numbers of a million digits", obj_long_numbers, OBJ_HINT},                    \
        {"obj: numbers do not depend on the locale", obj_locale, OBJ_HINT},                  \
        {"obj: broken points and normals, by line", obj_broken_points, OBJ_HINT},            \
        {"obj: broken faces, by line", obj_broken_faces, OBJ_HINT},                          \
        {"obj: no triangle", obj_no_triangle, OBJ_HINT},                                     \
        {"obj: no text", obj_binary, OBJ_HINT},                                              \
        {"obj: cut anywhere", obj_truncated, OBJ_HINT},                                      \
        {"obj: long and strange names", obj_names, OBJ_HINT},                                \
        {"obj: polygons are cut into fans", obj_fans, OBJ_HINT},                             \
        {"obj: -1 is the last point above", obj_from_the_end, OBJ_HINT},                     \
        {"obj: triangles without area are left out", obj_degenerate, OBJ_HINT},              \
        {"obj: tiny, huge and equal points", obj_sizes, OBJ_HINT},                           \
        {"obj: a sphere around all points in use", obj_around, OBJ_HINT},                    \
        {"obj: normals are made unit, once", obj_units, OBJ_HINT},                           \
        {"obj: the shortest and longest normals", obj_unit_extremes, OBJ_HINT},              \
        {"obj: a point for each of its normals", obj_splits, OBJ_HINT},                      \
        {"obj: a point for each of its normals, at random", obj_splits_at_random, OBJ_HINT}, \
        {"obj: a corner without normal makes all flat", obj_bare, OBJ_HINT},                 \
        {"obj: a torus, written and read", obj_round_trip, OBJ_HINT},                        \
        {"obj: lines of a megabyte, a million of continuations", obj_long_lines, OBJ_HINT},  \
        {"obj: a face of a million corners", obj_large_face, OBJ_HINT},                      \
        {"obj: 200,000 normals at one point", obj_many_normals, OBJ_HINT},                   \
        {"obj: too little memory", obj_no_memory, OBJ_HINT},                                 \
        {"obj: files that cannot be read", obj_bad_files, OBJ_HINT},                         \
        {"obj: a pipe", obj_pipe, OBJ_HINT}, {                                               \
        "obj: every file of tests/12-bvh/obj", obj_all_files, OBJ_HINT                       \
    }

#endif
