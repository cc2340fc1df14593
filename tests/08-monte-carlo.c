// Tests of 08-monte-carlo: estimates and their standard errors as claims, point sets by
// their cells, and sums in float.
#include <stdlib.h>
#include <string.h>

#include "chapters/08-monte-carlo/monte_carlo.h"
#include "common/exact3.h"
#include "tests/check-directions.h"
#include "tests/check.h"

static const double u64 = 0x1p-53; // a rounding of double

static void check_chi2(const long *cell, int cells, long count) {
    CHECK_AT_MOST(chi2_of(cell, cells, count), chi2_limit(cells - 1, FALSE_ALARM),
                  "chi² that a right answer exceeds once in a million");
}

static int cell_in(double x, int cells) {
    return (int)fmin(cells - 1, fmax(0, floor(cells * x)));
}

// The share of `runs` that came true against its probability p.
static void check_share(long came_true, long runs, double p) {
    CHECK_REAL((double)came_true / (double)runs, p,
               standard_errors(5, sqrt(p * (1 - p) / (double)runs)));
}

// The sample variance of `runs` values that are nearly normal.
static void check_variance(const running *s, double want) {
    CHECK_REAL(running_variance(s), want,
               standard_errors(5, want * sqrt(2.0 / (double)(s->n - 1))));
}

// ---- estimate_pi -------------------------------------------------------------------

static const char *const stands =
    "g went on: draw from g itself, not from a copy (rng h = *g) and not from a generator "
    "seeded here";
static const char *const all_the_same =
    "all points are the same: draw from g itself, not from a copy, and seed nothing here";

static const char *const whole_share =
    "0 but for n = 1: is the share divided in whole numbers, in / n?";

// Does one point give 4, at times? Then not all points are outside.
static bool one_point_gives_4(rng *g) {
    for (int i = 0; i < 40; i++)
        if (estimate_pi(1, g).value == 4) return true;
    return false;
}

static void pi_not_a_quarter(void) {
    rng g = check_rng(1);
    const rng before = g;
    const estimate e = estimate_pi(1000000, &g);
    const double value = e.value;
    given("n = 1,000,000 random points; got the value %g", value);
    CHECK(!same_state(g, before), stands);
    suspect_value("the standard error: value and standard_error are swapped",
                  sqrt(PI * (4 - PI) / 1e6));
    suspect_value(value == 0 && one_point_gives_4(&g) ? whole_share : all_the_same, 0);
    suspect_value("π/4, the share itself, as on the slide", PI / 4);
    suspect_value("16 times the share: multiplied by 4 twice", 4 * PI);
    suspect_value("the circle has a quarter of this area of the square: is x in [-1, 1)?",
                  2 * PI);
    suspect_value(
        "every point is in the circle: are all points the same? Or x and y from one draw, or "
        "x² + y² <= 1 wrong?",
        4);
    suspect_value("|x| + |y| <= 1, a square on its corner", 2);
    suspect_value("x = y: are two numbers drawn for each point?", 4 * sqrt(0.5));
    CHECK_REAL(value, PI, standard_errors(5, sqrt(PI * (4 - PI) / 1e6)));
    const long n = e.n;
    CHECK_INT(n, 1000000);
}

static void pi_error_at_a_million(void) {
    rng g = check_rng(2);
    const double want = sqrt(PI * (4 - PI) / 1e6);
    given("n = 1,000,000 random points: the standard error is %.6f", want);
    suspect_factor("that of π/4: the factor 4 is missing", 0.25);
    suspect_factor("4 is squared: the standard deviation grows by 4, the variance by 16", 4);
    suspect_value("the variance: the square root is missing", want * want);
    suspect_factor("of one point: the division by n - 1 is missing", 1000);
    suspect_factor("divided by n - 1 outside the root", 1e-3);
    suspect_value("sqrt(p / n): the factor 1 - p is missing", 4 * sqrt(PI / 4 / 1e6));
    suspect_value("sqrt(π / n): the variance of a count that can be any number",
                  sqrt(PI / 1e6));
    suspect_value("the value: value and standard_error are swapped", PI);
    suspect_value("p is 0 or 1: is the share divided in whole numbers, in / n?", 0);
    const double standard_error = estimate_pi(1000000, &g).standard_error;
    CHECK_REAL(standard_error, want,
               relative_to(0.01, "p is known to 0.05 %; 5 standard errors of this are 0.1 %"));
}

// Any n, by the formula from the value: p = value / 4.
static void pi_error_formula(void) {
    const long sizes[] = {2, 3, 5, 10, 100, 12345};
    rng g = check_rng(3);
    for (int i = 0; i < 50 * COUNT(sizes); i++) {
        const long n = sizes[i % COUNT(sizes)];
        const estimate e = estimate_pi(n, &g);
        const double p = e.value / 4, want = 4 * sqrt(p * (1 - p) / (double)(n - 1));
        given("n = %ld, value %.9g: p = value / 4 = %.9g", n, e.value, p);
        suspect_value("n where n - 1 belongs", 4 * sqrt(p * (1 - p) / (double)n));
        suspect_value("from the true π, which an estimate does not know",
                      sqrt(PI * (4 - PI) / (double)(n - 1)));
        suspect_value("from the true π, which an estimate does not know",
                      sqrt(PI * (4 - PI) / (double)n));
        suspect_factor("that of π/4: the factor 4 is missing", 0.25);
        suspect_value("the variance: the square root is missing", want * want);
        suspect_value("of one point: the division by n - 1 is missing", 4 * sqrt(p * (1 - p)));
        const double standard_error = e.standard_error;
        CHECK_REAL(standard_error, want,
                   absolute_of(1e-11, "n - 1 in double, p(1 - p) up to its rounding"));
        const double inside = p * (double)n;
        const bool is_whole = fabs(inside - round(inside)) < 1e-6;
        given("n = %ld, value %.9g: value n/4 = %.9g", n, e.value, inside);
        CHECK(is_whole, "value n/4 is the number of points inside, a whole number");
        const long evaluations = e.n;
        CHECK_INT(evaluations, n);
    }
}

// Of n = 1, after given().
static void check_error_of_one(double standard_error) {
    CHECK(!isnan(standard_error), "not NaN: n - 1 is 0 here, and 0/0 is not a number; "
                                  "n = 1 needs a case of its own: INFINITY");
    suspect_value("no special case for n = 1: one value does not tell its spread: INFINITY", 0);
    CHECK_REAL(standard_error, INFINITY, exactly());
}

static void pi_one_point(void) {
    rng g = check_rng(4);
    for (int i = 0; i < 20; i++) {
        const estimate e = estimate_pi(1, &g);
        const double value = e.value;
        given("n = 1: the value is %g", value);
        CHECK(value == 0 || value == 4, "one point is in the circle or not: 0 or 4");
        check_error_of_one(e.standard_error);
    }
}

static void pi_mean_and_variance(void) {
    enum { RUNS = 4000, N = 500 };
    rng g = check_rng(5);
    running s = {0};
    for (int i = 0; i < RUNS; i++) running_add(&s, estimate_pi(N, &g).value);
    given("the mean of 4000 estimates with 500 points each");
    const double least = s.min, most = s.max, mean = s.mean;
    const bool all_are_0 = least == 0 && most == 0;
    CHECK(!all_are_0, "not all 0: is the share divided in whole numbers, in / n?");
    CHECK(least < most, "another estimate in each run: is g the caller's, and used?");
    suspect_value("π/4", PI / 4);
    CHECK_REAL(mean, PI, standard_errors(5, sqrt(PI * (4 - PI) / (double)(N * RUNS))));
    given("the variance of 4000 estimates with 500 points each: π(4 - π)/500");
    check_variance(&s, PI * (4 - PI) / N);
}

// The probability that k of n points in the circle give a value within z of their own
// standard errors of π: the binomial probabilities, summed.
static double pi_coverage(long n, double z) {
    const double p = PI / 4;
    double sum = 0;
    for (long k = 0; k <= n; k++) {
        const double q = (double)k / (double)n;
        const double error = 4 * sqrt(q * (1 - q) / (double)(n - 1));
        const double log_p = lgamma(n + 1.0) - lgamma(k + 1.0) - lgamma((double)(n - k) + 1) +
                             (double)k * log(p) + (double)(n - k) * log(1 - p);
        if (fabs(4 * q - PI) <= z * error) sum += exp(log_p);
    }
    return sum;
}

static void pi_claim(void) {
    enum { RUNS = 20000 };
    const long sizes[] = {30, 200, 1000};
    rng g = check_rng(6);
    for (int i = 0; i < COUNT(sizes); i++) {
        long within[3] = {0};
        for (int k = 0; k < RUNS; k++) {
            const estimate e = estimate_pi(sizes[i], &g);
            for (int z = 1; z <= 2; z++)
                within[z] += fabs(e.value - PI) <= z * e.standard_error;
        }
        for (int z = 1; z <= 2; z++) {
            given("n = %ld, 20,000 runs: the share within %d standard error%s of π; expected: "
                  "for this n, by the binomial distribution",
                  sizes[i], z, z > 1 ? "s" : "");
            suspect_value("no value lies so near to π: is the value π and not π/4, and the "
                          "error divided by n - 1 inside the root?",
                          0);
            check_share(within[z], RUNS, pi_coverage(sizes[i], z));
        }
    }
}

static void pi_many_points(void) {
    const long n = 30000000;
    rng g = check_rng(7);
    given("n = 30,000,000, more than a float can count");
    suspect_value("a float counter: it stops at 2^24", 4.0 * 16777216 / (double)n);
    suspect_value("two float counters: both stop at 2^24", 4);
    suspect_value("is the share divided in whole numbers, in / n?", 0);
    suspect_value("n stopped at 2^24 in float", 4.0 * PI / 4 * (double)n / 16777216);
    const double value = estimate_pi(n, &g).value;
    CHECK_REAL(value, PI, standard_errors(5, sqrt(PI * (4 - PI) / (double)n)));
}

// ---- monte_carlo -------------------------------------------------------------------

// An integrand that ignores where it is and tells off a list.
typedef struct {
    const double *values;
    long count, calls;
} told;

static double tell(const void *data, const double *x) {
    (void)x;
    told *t = *(told *const *)data;
    return t->values[t->calls++ % t->count];
}

// The estimate of n values of a list, whatever the points.
static estimate of_list(const double *values, long count, long n, rng *g) {
    told t = {values, count, 0}, *const at = &t;
    const estimate e = monte_carlo(tell, &at, 2, n, g);
    const long calls_of_f = t.calls;
    CHECK(calls_of_f == n, "f is called once for each of the n points");
    return e;
}

static void suspect_errors(double variance, long n) {
    suspect_value("n where n - 1 belongs: the deviations are from their own mean",
                  sqrt(variance * (double)(n - 1)) / (double)n);
    suspect_value("the standard deviation of one value: the division by n is missing",
                  sqrt(variance));
    suspect_value("the variance of one value", variance);
    suspect_value("the variance of the mean: the square root is missing", variance / (double)n);
    suspect_value("the standard deviation divided by n: the root of n is missing",
                  sqrt(variance) / (double)n);
    suspect_value("the division by n - 1 is missing",
                  sqrt(variance * (double)(n - 1) / (double)n));
}

static void mc_by_hand(void) {
    static const double values[] = {4, 7, 13, 16};
    rng g = check_rng(8);
    given("f gives 4, 7, 13, 16: mean 10, deviations -6, -3, 3, 6, sum of squares 90, so the "
          "variance is 90/3 = 30, and the standard error sqrt(30/4)");
    const estimate e = of_list(values, 4, 4, &g);
    const double value = e.value, standard_error = e.standard_error;
    suspect_value("the standard error: value and standard_error are swapped", sqrt(30.0 / 4));
    suspect_value("the mean goes away from the values: mean -= where mean += belongs", -25.25);
    suspect_value("the sum: the division by n is missing", 40);
    suspect_value("the last value", 16);
    suspect_value("the mean without the last value: do the points begin at i = 1?", 8);
    CHECK_REAL(value, 10, relative_to(8 * u64, "a few roundings in double"));
    suspect_errors(30, 4);
    suspect_value("the deviation from the mean before it, squared: one of the two factors is "
                  "from the mean after it",
                  sqrt(145.25 / 3 / 4));
    suspect_value("the value: value and standard_error are swapped", 10);
    CHECK_REAL(standard_error, sqrt(30.0 / 4), relative_to(32 * u64, "roundings in double"));
    const long n = e.n;
    CHECK_INT(n, 4);
}

static void mc_one_and_two(void) {
    static const double values[] = {-3.5, 2.25};
    rng g = check_rng(9);
    given("n = 1; f gives -3.5");
    const estimate one = of_list(values, 1, 1, &g);
    const double value = one.value;
    CHECK_REAL(value, -3.5, exactly());
    check_error_of_one(one.standard_error);
    given("n = 2; f gives -3.5 and 2.25: half their distance");
    suspect_errors(5.75 * 5.75 / 2, 2);
    const double standard_error = of_list(values, 2, 2, &g).standard_error;
    CHECK_REAL(standard_error, 5.75 / 2, relative_to(16 * u64, "roundings in double"));
    static const double constant[] = {3.7};
    given("1000 times 3.7: nothing varies");
    const estimate flat = of_list(constant, 1, 1000, &g);
    const double flat_value = flat.value, flat_error = flat.standard_error;
    CHECK_REAL(flat_value, 3.7, relative_to(1000 * u64, "1000 roundings"));
    CHECK_REAL(flat_error, 0,
               absolute_of(1e-13, "the deviations are roundings of the mean, not more"));
}

// mean + 1, mean - 1, mean + 1 ... The variance is n/(n - 1). What the sum of squares
// minus the square of the sum loses: all of it.
static void mc_large_mean(void) {
    enum { N = 1000 };
    static const double means[] = {1e3, -1e6, 1e9, -1e9, 1e11};
    rng g = check_rng(10);
    for (int i = 0; i < COUNT(means); i++) {
        const double values[] = {means[i] + 1, means[i] - 1};
        given("f gives %.9g ± 1, by turns, 1000 times: the standard error is 1/sqrt(999)",
              means[i]);
        const estimate e = of_list(values, 2, N, &g);
        const double value = e.value, standard_error = e.standard_error;
        suspect_value("0 or less under the root: the sum of squares cancelled", 0);
        suspect_errors(N / (N - 1.0), N);
        CHECK_REAL(standard_error, 1 / sqrt(N - 1.0),
                   relative_to(N * (1 + fabs(means[i])) * u64,
                               "n mean/deviation roundings; the sum of squares loses the "
                               "square of mean/deviation"));
        CHECK_REAL(value, means[i], relative_to(N * u64, "a rounding for each term"));
    }
}

// How many numbers of 32 bits lie between two states of a generator; -1 if more than `most`.
static long drawn_between(rng from, rng to, long most) {
    for (long k = 0; k <= most; k++) {
        if (same_state(from, to)) return k;
        rng_bits(&from);
    }
    return -1;
}

static double zero(const void *nothing, const double *x) {
    (void)nothing, (void)x;
    return 0;
}

// What a loop to k <= dimensions does to x[8] nobody sees, but g does.
static void mc_draws(void) {
    rng g = check_rng(33);
    for (int k = 2; k < 10; k++) // 3 first, where nothing looks like anything else
        for (long n = 100; n >= 1; n /= 10) {
            const int d = 1 + k % 8;
            const rng before = g;
            monte_carlo(zero, NULL, d, n, &g);
            const long most = 2 * (d + 10) * (n + 10);
            const long numbers_drawn = drawn_between(before, g, most);
            given("n = %ld, %d dimensions: how many numbers of 32 bits were drawn from g? "
                  "rng_double takes two (-1: more than %ld, or it is not g any more)",
                  n, d, most);
            CHECK(numbers_drawn != 0, stands);
            suspect_value("one coordinate too many: k <= dimensions? Then x[8] is written, "
                          "behind the end of x",
                          (double)(2 * (d + 1) * n));
            suspect_value("drawn by rng_real in float: 24 bits; rng_double has 53",
                          (double)(d * n));
            suspect_value("one draw for each point, not one for each coordinate",
                          (double)(2 * n));
            suspect_value("one point too many: i <= n from 0?", (double)(2 * d * (n + 1)));
            suspect_value("8 draws for each point, whatever `dimensions` is", (double)(16 * n));
            CHECK_INT(numbers_drawn, 2 * d * n);
        }
}

typedef struct {
    double low[8], high[8], sum[8], square[8], product[8];
    long calls;
} seen;

// Where does it look? Coordinate k with its neighbour k + 1, around.
static double look(const void *data, const double *x) {
    seen *s = *(seen *const *)data;
    for (int k = 0; k < 8; k++) {
        s->low[k] = s->calls ? fmin(s->low[k], x[k]) : x[k];
        s->high[k] = s->calls ? fmax(s->high[k], x[k]) : x[k];
        s->sum[k] += x[k] - 0.5;
        s->square[k] += (x[k] - 0.5) * (x[k] - 0.5);
        s->product[k] += (x[k] - 0.5) * (x[(k + 1) % 8] - 0.5);
    }
    s->calls++;
    return 0;
}

static void mc_points(void) {
    const long n = 40000;
    rng g = check_rng(11);
    seen s = {.calls = 0}, *const at = &s;
    monte_carlo(look, &at, 8, n, &g);
    given("f is asked to look at its points, 8 dimensions, n = 40,000");
    const long calls_of_f = s.calls;
    CHECK_INT(calls_of_f, n);
    for (int k = 0; k < 8; k++) {
        const double N = (double)n;
        const double lowest = s.low[k], highest = s.high[k];
        given("coordinate %d of 40,000 points: from %.9g to %.9g", k, lowest, highest);
        CHECK(lowest < highest, all_the_same);
        CHECK(lowest >= 0 && highest < 1, "in [0, 1)");
        const double mean_less_half = s.sum[k] / N, variance = s.square[k] / N;
        CHECK_REAL(mean_less_half, 0, standard_errors(5, sqrt(1 / 12.0 / N)));
        CHECK_REAL(variance, 1 / 12.0, standard_errors(5, sqrt(1 / 180.0 / N)));
        given("coordinates %d and %d of 40,000 points: the mean of (x - 1/2)(x' - 1/2)", k,
              (k + 1) % 8);
        const double covariance = s.product[k] / N;
        CHECK(covariance < 0.08, "they are not the same number: is each drawn?");
        CHECK_REAL(covariance, 0, standard_errors(5, 1 / 12.0 / sqrt(N)));
    }
}

// E f^k of product_of_exp in d dimensions.
static double moment(int k, int d) {
    return pow((exp(k) - 1) / k / pow(exp(1) - 1, k), d);
}

static void mc_dimensions(void) {
    const long n = 20000;
    rng g = check_rng(12);
    for (int d = 1; d <= 8; d++) {
        const estimate e = monte_carlo(product_of_exp, &d, d, n, &g);
        const double variance = moment(2, d) - 1;
        const double fourth = moment(4, d) - 4 * moment(3, d) + 6 * moment(2, d) - 3;
        given("the product of e^x/(e - 1) over %d dimensions, n = 20,000: 1", d);
        suspect_value("all coordinates are the same number",
                      (exp(d) - 1) / d / pow(exp(1) - 1, d));
        const double value = e.value, standard_error = e.standard_error;
        CHECK_REAL(value, 1, standard_errors(5, sqrt(variance / (double)n)));
        const double want = sqrt(variance / (double)n);
        given("the same: its standard error. f has the variance %.4g", variance);
        suspect_errors(variance, n);
        CHECK_REAL(standard_error, want,
                   standard_errors(
                       6, want * sqrt((fourth / variance / variance - 1) / (4.0 * (double)n))));
    }
}

// The same values whichever run it is, other values with other draws.
static void mc_again(void) {
    const int d = 3;
    rng g = check_rng(13), same = g;
    const estimate first = monte_carlo(product_of_exp, &d, d, 100, &g);
    const estimate again = monte_carlo(product_of_exp, &d, d, 100, &same);
    const estimate next = monte_carlo(product_of_exp, &d, d, 100, &g);
    given("twice from the same state of g: %.17g and %.17g; then from what g is then: %.17g",
          first.value, again.value, next.value);
    const bool the_same =
        first.value == again.value && first.standard_error == again.standard_error;
    CHECK(the_same,
          "the same draws give the same estimate: nothing is left from the run before");
    const bool another = next.value != first.value;
    CHECK(another, stands);
}

// Normal, mean 0 and variance 1, by Box and Muller (1958) from two uniform numbers. Then
// value / standard error follows Student's t exactly, with n - 1 degrees of freedom.
static double normal(const void *nothing, const double *x) {
    (void)nothing;
    return sqrt(-2 * log(1 - x[0])) * cos(2 * PI * x[1]);
}

// P(|t| <= z): with t = sqrt(dof) tan φ the density is cos^(dof - 1) φ. Midpoint rule.
static double student(double z, int dof) {
    enum { STEPS = 20000 };
    const double end = atan(z / sqrt(dof)), all = PI / 2;
    double inside = 0, total = 0;
    for (int i = 0; i < STEPS; i++) {
        inside += end / STEPS * pow(cos((i + 0.5) * end / STEPS), dof - 1);
        total += all / STEPS * pow(cos((i + 0.5) * all / STEPS), dof - 1);
    }
    return inside / total;
}

static void mc_claim(void) {
    enum { RUNS = 20000 };
    const int sizes[] = {2, 3, 10, 100};
    rng g = check_rng(14);
    for (int i = 0; i < COUNT(sizes); i++) {
        long within[3] = {0};
        for (int k = 0; k < RUNS; k++) {
            const estimate e = monte_carlo(normal, NULL, 2, sizes[i], &g);
            for (int z = 1; z <= 2; z++) within[z] += fabs(e.value) <= z * e.standard_error;
        }
        for (int z = 1; z <= 2; z++) {
            given("normal values, n = %d, 20,000 runs: the share within %d standard error%s of "
                  "the mean (Student's t)",
                  sizes[i], z, z > 1 ? "s" : "");
            check_share(within[z], RUNS, student(z, sizes[i] - 1));
        }
    }
}

// From 10 to 10,000 points: the error falls as n^-1/2, in any dimension.
static void mc_slope(void) {
    static const struct {
        long n;
        int runs;
    } rows[] = {{10, 2000}, {100, 1000}, {1000, 400}, {10000, 100}};
    rng g = check_rng(15);
    for (int d = 1; d <= 7; d += 3)
        for (int i = 0; i < COUNT(rows); i++) {
            const double variance = moment(2, d) - 1, n = (double)rows[i].n;
            const double fourth = moment(4, d) - 4 * moment(3, d) + 6 * moment(2, d) - 3;
            const double excess = (fourth / variance / variance - 3) / n; // of the mean
            running squares = {0};
            for (int k = 0; k < rows[i].runs; k++) {
                const double off = monte_carlo(product_of_exp, &d, d, rows[i].n, &g).value - 1;
                running_add(&squares, off * off);
            }
            given("%d dimensions, n = %ld: the mean square of the error in %d runs", d,
                  rows[i].n, rows[i].runs);
            const double mean_square = squares.mean;
            CHECK_REAL(mean_square, variance / n,
                       standard_errors(6, variance / n * sqrt((2 + excess) / rows[i].runs)));
        }
}

// ---- stratified_point ----------------------------------------------------------------

static void one_in_each_square(void) {
    static long count[300 * 300];
    rng g = check_rng(16);
    for (long m = 1; m <= 300; m = m < 20 ? m + 1 : m * 7 / 2) {
        memset(count, 0, sizeof count);
        double most_u = 0, most_v = 0;
        for (long i = 0; i < m * m; i++) {
            const point2 p = stratified_point(i, m, &g);
            given("m = %ld, i = %ld: (%.17g, %.17g)", m, i, p.u, p.v);
            const bool in_square = p.u >= 0 && p.u < 1 && p.v >= 0 && p.v < 1;
            CHECK(in_square, "in [0, 1)");
            most_u = fmax(most_u, p.u), most_v = fmax(most_v, p.v);
            count[(long)(p.v * (double)m) * m + (long)(p.u * (double)m)]++;
        }
        long empty = 0, first = 0;
        for (long i = m * m - 1; i >= 0; i--)
            if (count[i] == 0) empty++, first = i;
        given("m = %ld: %ld of the %ld squares hold no point; the first of these is in column "
              "%ld, row %ld",
              m, empty, m * m, first % m, first / m);
        const bool two_columns = most_u >= 1 / (double)m, two_rows = most_v >= 1 / (double)m;
        CHECK(m == 1 || two_columns, "points in more than the first column: is u's column "
                                     "divided in whole numbers, (i % m) / m = 0?");
        CHECK(m == 1 || two_rows, "points in more than the first row: is v's row divided in "
                                  "whole numbers, i / m / m = 0?");
        CHECK(empty == 0, "m² points, one in every square");
    }
}

static void stratified_uniform(void) {
    enum { SIDE = 6 };
    rng g = check_rng(17);
    long cell[SIDE * SIDE] = {0}, n = 0, like_u = 0, mirrored = 0;
    for (int run = 0; run < 4000; run++)
        for (long i = 0; i < 25; i++, n++) {
            const point2 p = stratified_point(i, 5, &g);
            const double a = 5 * p.u - floor(5 * p.u), b = 5 * p.v - floor(5 * p.v);
            cell[cell_in(b, SIDE) * SIDE + cell_in(a, SIDE)]++;
            like_u += fabs(a - b) < 1e-9, mirrored += fabs(a + b - 1) < 1e-9;
        }
    given("4000 sets of 5 x 5 points: where in its square does a point lie? 6 x 6 cells");
    long most = 0;
    for (int i = 0; i < SIDE * SIDE; i++) most = cell[i] > most ? cell[i] : most;
    CHECK(most < n, "the points move: all lie at the same place in their squares. Is g used, "
                    "itself and not a copy of it?");
    const bool from_one_draw = like_u == n || mirrored == n;
    CHECK(!from_one_draw, "two draws: u and v come from one draw, all points lie on the "
                          "diagonals of their squares");
    check_chi2(cell, SIDE * SIDE, n);
}

// A generator whose next draw is the largest below 1. PCG's output is a permutation of
// the state's upper half; the increment leads from one such state to the next.
static rng largest_draw(void) {
    // Upper 5 bits 0: no rotation. old ^ old >> 18 must have 32 ones from bit 27 to 58.
    uint64_t s = 0; // bits above 58 are 0, and so are those 18 above bit 40 and higher
    for (int bit = 58; bit >= 27; bit--) s |= (~(s >> 18 >> bit) & 1) << bit;
    const uint64_t next = s | 1; // only bits below 27 may differ
    rng g = {s, 0};
    g.increment = next - s * 6364136223846793005u;
    return g;
}

// The generator that draws one number of rng_double, and then those of g: the step of two
// numbers of 32 bits, back.
static rng one_draw_before(rng g) {
    for (int i = 0; i < 2; i++) g.state = (g.state - g.increment) * inverse_of(multiplier);
    return g;
}

// Is x in the last of m columns, or of m rows?
static bool in_the_last(double x, long m) {
    return floor(x * (double)m) == (double)(m - 1);
}

static void check_last_square(long m, rng nearly_one, const char *which, rng *any) {
    const point2 elsewhere = stratified_point(m * m - 1, m, any);
    const point2 p = stratified_point(m * m - 1, m, &nearly_one);
    given("m = %ld, the last square, and g's %s draw is 1 - 2^-53: (%.17g, %.17g)", m, which,
          p.u, p.v);
    const bool negative = p.u < 0 || p.v < 0;
    CHECK(!negative, "not negative: do i and m stay long?");
    const bool below_one = p.u >= 0 && p.u < 1 && p.v >= 0 && p.v < 1;
    CHECK(below_one, "in [0, 1), never 1: m - 1 + draw is rounded, and to what?");
    const bool column_left = in_the_last(elsewhere.u, m) && !in_the_last(p.u, m),
               row_left = in_the_last(elsewhere.v, m) && !in_the_last(p.v, m);
    CHECK(!column_left && !row_left,
          "still in the last column and row, as with other draws: what would be 1 is moved, "
          "but out of its square");
}

static void stratified_from_g(void) {
    for (long i = 0; i < 200; i++) {
        rng one = rng_seed(1, (uint64_t)i), other = one;
        const point2 a = stratified_point(i % 4, 2, &one),
                     b = stratified_point(i % 4, 2, &other);
        given("m = 2, i = %ld, asked twice with g in the same state: (%.17g, %.17g) and then "
              "(%.17g, %.17g)",
              i % 4, a.u, a.v, b.u, b.v);
        suspect_slip("numbers that do not come from g: rand(), a generator of your own, or "
                     "something kept from the call before?");
        const bool the_same_point_twice = a.u == b.u && a.v == b.v;
        CHECK(the_same_point_twice, "the same point, bit for bit: g alone decides");
    }
}

static void stratified_below_one(void) {
    rng g = largest_draw(), copy = g, any = check_rng(35);
    const double draw = rng_double(&copy);
    given("a generator was made whose next rng_double is %.17g", draw);
    if (draw != 1 - u64) return; // another generator: nothing to try
    const long sizes[] = {1, 2, 3, 10, 1000, 1L << 20, 2147483648};
    for (int i = 0; i < COUNT(sizes); i++) {
        check_last_square(sizes[i], g, "first", &any);
        check_last_square(sizes[i], one_draw_before(g), "second", &any);
    }
}

// Far too many to count them all: i in its full range.
static void stratified_huge(void) {
    const long m = 2147483648;
    rng g = check_rng(18);
    double last = -1;
    for (int i = 0; i < 1000; i++) {
        const long some = (long)(rng_double(&g) * (double)m * (double)m) & ~1L;
        const long first = i == 0 ? m * m - 2 : some;
        const point2 a = stratified_point(first, m, &g), b = stratified_point(first + 1, m, &g);
        given("m = 2^31, i = %ld and the next: (%.12g, %.12g) and (%.12g, %.12g)", first, a.u,
              a.v, b.u, b.v);
        const bool in_square = a.u >= 0 && a.u < 1 && a.v >= 0 && a.v < 1;
        CHECK(in_square, "in [0, 1)");
        const bool same_column = floor(a.u * (double)m) == floor(b.u * (double)m),
                   same_row = floor(a.v * (double)m) == floor(b.v * (double)m);
        CHECK(!same_column || !same_row,
              "two squares: is i a long all the way, the sum with the draw in double? Is what "
              "is near 1 cut off too early?");
        const bool another_point = a.u + 2 * a.v != last;
        CHECK(another_point, "other points for other i: does i overflow?");
        last = a.u + 2 * a.v;
    }
}

// The area under the half circle over [0, x] from the middle, for -1 <= x <= 1.
static double under_circle(double x) {
    return (x * sqrt(fmax(0, 1 - x * x)) + asin(x)) / 2;
}

// The area of the disc within [x0, x1] x [0, y], for y >= 0, x0 >= 0.
static double disc_area(double x0, double x1, double y) {
    const double edge = y < 1 ? sqrt(1 - y * y) : 0; // to its left the circle is above y
    const double a = fmin(fmax(edge, x0), x1), end = fmin(x1, 1), from = fmin(fmax(a, x0), end);
    return (fmin(a, x1) - x0) * fmin(y, 1) + under_circle(end) - under_circle(from);
}

// The variance of π from m x m points: each square is in the disc, out, or cut with the
// share p, and then has 16 p (1 - p). m even: one quarter, four times.
static double stratified_variance(long m) {
    double sum = 0;
    const double side = 2.0 / (double)m;
    for (long i = 0; i < m / 2; i++)
        for (long k = 0; k < m / 2; k++) {
            const double x0 = (double)i * side, x1 = x0 + side, y = (double)k * side;
            const double area = disc_area(x0, x1, y + side) - disc_area(x0, x1, y);
            const double p = fmin(fmax(area / (side * side), 0), 1);
            sum += 4 * 16 * p * (1 - p);
        }
    return sum / ((double)m * (double)m * (double)m * (double)m);
}

static void stratified_pi(void) {
    const long sizes[] = {4, 16, 64};
    rng g = check_rng(19);
    for (int i = 0; i < COUNT(sizes); i++) {
        const long m = sizes[i];
        running s = {0};
        for (int run = 0; run < 1000; run++) {
            double inside = 0;
            for (long k = 0; k < m * m; k++) {
                const point2 p = stratified_point(k, m, &g);
                inside += four_in_circle(NULL, (const double[]){p.u, p.v});
            }
            running_add(&s, inside / (double)(m * m));
        }
        const double want = stratified_variance(m), N = (double)(m * m);
        given("π from %ld x %ld stratified points, 1000 runs: the mean", m, m);
        const double mean = s.mean;
        CHECK_REAL(mean, PI, standard_errors(5, sqrt(want / 1000)));
        given("π from %ld x %ld stratified points: the variance in 1000 runs", m, m);
        suspect_value("as large as that of random points", PI * (4 - PI) / N);
        check_variance(&s, want);
    }
    // Buffon's needle: 16 times the mean distance of two points in a unit square.
    const double distance = (2 + sqrt(2) + 5 * log(1 + sqrt(2))) / 15;
    given("the sum over the cells of 1024 x 1024 squares, times N^1.5, and its limit");
    CHECK_REAL(stratified_variance(1024) * pow(1024, 3), 16 * distance,
               relative_to(0.5 / sqrt(1024), "the lines beside the circle's four ends: of "
                                             "order 1/sqrt(m), 1.5 % here"));
    CHECK_REAL(16 * distance, 8.34, absolute_of(0.005, "8.34 has three digits"));
}

// ---- radical_inverse -----------------------------------------------------------------

static const char *const whole_place =
    "nothing is added: is 1 / base divided in whole numbers, 0? Or a digit by its power?";

static void inverse_by_hand(void) {
    static const struct {
        int base;
        uint64_t i;
        double want, plain; // plain: the digits put behind the point unmirrored
    } rows[] = {
        {10, 1234, 0.4321, 0.1234},
        {2, 6, 3 / 8.0, 6 / 8.0},
        {2, 1, 1 / 2.0, 1 / 2.0},
        {2, 4, 1 / 8.0, 4 / 8.0},
        {2, 11, 13 / 16.0, 11 / 16.0},
        {3, 1, 1 / 3.0, 1 / 3.0},
        {3, 5, 7 / 9.0, 5 / 9.0},
        {3, 14, 22 / 27.0, 14 / 27.0},
        {7, 0, 0, 0},
        {1000, 123456789, 0.789456123, 0.123456789},
    };
    for (int k = 0; k < COUNT(rows); k++) {
        const int base = rows[k].base;
        const uint64_t i = rows[k].i;
        const double want = rows[k].want;
        given("base %d, i = %llu", base, (unsigned long long)i);
        if (want > 0) suspect_value(whole_place, 0);
        suspect_value("the digits behind the point, but not mirrored", rows[k].plain);
        suspect_factor("a whole number: the first digit belongs behind the point", base);
        suspect_factor("one place too far behind the point", 1.0 / base);
        CHECK_REAL(radical_inverse(base, i), want, relative_to(64 * u64, "64 roundings"));
    }
}

// In 113 bits: the last digit of i first.
static exact inverse_exact(int base, uint64_t i) {
    return i == 0
               ? 0
               : ((exact)(i % (uint64_t)base) + inverse_exact(base, i / (uint64_t)base)) / base;
}

// Uniform in the number of digits, up to 2^62.
static uint64_t some_index(rng *g) {
    const uint64_t high = rng_bits(g), low = rng_bits(g);
    return (high << 32 | low) >> (2 + rng_bits(g) % 60);
}

// A student's likely way round the whole numbers.
static double inverse_by_fmod(int base, double i) {
    double sum = 0, place = 1;
    for (; i > 0; i = floor(i / base)) {
        place /= base;
        sum += place * fmod(i, base);
    }
    return sum;
}

// Mirrored as a whole number and divided at the end, both modulo 2^64 or in a long.
static double inverse_by_power(int base, uint64_t i, bool is_signed) {
    uint64_t number = 0, power = 1;
    for (; i > 0; i /= (uint64_t)base) {
        number = number * (uint64_t)base + i % (uint64_t)base;
        power *= (uint64_t)base;
    }
    return is_signed ? (double)(int64_t)number / (double)(int64_t)power
                     : (double)number / (double)power;
}

// The mirrored number modulo 2^64, but the power in double.
static double inverse_by_whole_number(int base, uint64_t i) {
    uint64_t number = 0;
    double power = 1;
    for (; i > 0; i /= (uint64_t)base) {
        number = number * (uint64_t)base + i % (uint64_t)base;
        power *= base;
    }
    return (double)number / power;
}

// Each digit over base^k in an int, modulo 2^32.
static double inverse_by_int_power(int base, uint64_t i) {
    double sum = 0;
    uint32_t power = 1;
    for (; i > 0; i /= (uint64_t)base) {
        power *= (uint32_t)base;
        sum += (double)(i % (uint64_t)base) / (double)(int32_t)power;
    }
    return sum;
}

// The mirrored number in double, but the power modulo 2^64.
static double inverse_by_whole_power(int base, uint64_t i) {
    double number = 0;
    uint64_t power = 1;
    for (; i > 0; i /= (uint64_t)base) {
        number = number * base + (double)(i % (uint64_t)base);
        power *= (uint64_t)base;
    }
    return number / (double)power;
}

// `seen` is what is judged, 1 - the inverse or the inverse: fmin may have made it 1 - u.
static double seen_of(double inverse, bool from_one) {
    const double x = inverse < 1 ? inverse : 1 - DBL_EPSILON / 2;
    return from_one ? 1 - x : x;
}

static void suspect_overflow(int base, uint64_t i, bool from_one) {
    static const char *const overflow =
        "base^k as a whole number overflows: it has no room in 64 bits";
    const double wrapped[] = {inverse_by_power(base, i, false), inverse_by_power(base, i, true),
                              inverse_by_whole_power(base, i)};
    suspect_value("the mirrored digits as a whole number overflow 64 bits",
                  seen_of(inverse_by_whole_number(base, i), from_one));
    for (int k = 0; k < COUNT(wrapped); k++)
        suspect_value(overflow, seen_of(wrapped[k], from_one));
    suspect_value("base^k overflows: it has no room in an int",
                  seen_of(inverse_by_int_power(base, i), from_one));
}

static void inverse_generic(void) {
    static const char *const rounded =
        "i went through a double: its last digits, the first of the answer, were rounded";
    rng g = check_rng(20);
    for (int k = 0; k < 40000; k++) {
        const int base = k % 3 ? 2 + (int)(rng_bits(&g) % (k % 3 == 1 ? 9 : 999)) : 2;
        const uint64_t i = some_index(&g);
        const exact want = inverse_exact(base, i);
        given("base %d, i = %llu", base, (unsigned long long)i);
        suspect_value("i went through an int or unsigned: 32 bits are left of it",
                      (double)inverse_exact(base, (uint32_t)i));
        suspect_value(i >> 31 ? "the upper bits of i were lost: is it an int?" : whole_place,
                      0);
        suspect_overflow(base, i, false);
        suspect_value(rounded, (double)inverse_exact(base, (uint64_t)(double)i));
        suspect_value(rounded, inverse_by_fmod(base, (double)i));
        suspect_factor("a whole number: the first digit belongs behind the point", base);
        suspect_value("float inside", (double)(float)want);
        CHECK_REAL(radical_inverse(base, i), (double)want,
                   relative_to(64 * u64, "64 roundings in double"));
        const double got = radical_inverse(base, i);
        given("base %d, i = %llu: got %.17g", base, (unsigned long long)i, got);
        const bool in_range = got >= 0 && got < 1;
        CHECK(in_range, "in [0, 1), never 1");
    }
}

// What a right answer cannot be, k times the digit base - 1: where is it cut off?
static void suspect_cut(double want) {
    const double most = radical_inverse(2, (1uLL << 62) - 1); // 1 - 2^-62, to rounding
    if (most > 0.5 && most < want)
        suspect_value("cut off too early: the largest double below 1 is 1 - DBL_EPSILON / 2",
                      1 - most);
}

// All digits base - 1: so near 1 that the nearest double is 1.
static void inverse_below_one(void) {
    for (int base = 2; base <= 1000; base = base < 12 ? base + 1 : base * 3 / 2) {
        uint64_t power = (uint64_t)base;
        for (int k = 1;; k++, power *= (uint64_t)base) {
            const uint64_t i = power - 1;
            const double got = radical_inverse(base, i), want = 1 - 1 / (double)power;
            given("base %d, i = %llu: %d digits, all %d: 1 - %d^-%d, rounded; got 1 - %.9g",
                  base, (unsigned long long)i, k, base - 1, base, k, 1 - got);
            suspect_value(
                i >> 31 ? "the upper bits of i were lost: is it an int?" : whole_place, 1);
            if (i >> 32)
                suspect_value("the upper bits of i were lost: is it an int or unsigned?",
                              1 - (double)inverse_exact(base, (uint32_t)i));
            suspect_overflow(base, i, true);
            suspect_cut(want);
            CHECK_REAL(1 - radical_inverse(base, i), 1 - want,
                       absolute_of(64 * u64, "64 roundings of what is nearly 1"));
            const bool below_one = got < 1;
            CHECK(below_one, "in [0, 1): a coordinate of 1 is outside the square");
            if (power > (1uLL << 62) / (uint64_t)base) break;
        }
    }
}

// The first base^k points: one in each of base^k intervals.
static void inverse_intervals(void) {
    static const int bases[] = {2, 3, 5, 7, 10};
    static long count[3000];
    for (int b = 0; b < COUNT(bases); b++)
        for (int n = 1; n <= 2500; n *= bases[b]) {
            memset(count, 0, sizeof count);
            for (int i = 0; i < n; i++)
                count[lround(radical_inverse(bases[b], (uint64_t)i) * n) % n]++;
            for (int i = 0; i < n; i++) {
                given("base %d: of the first %d, how many are %d/%d?", bases[b], n, i, n);
                CHECK_INT(count[i], 1);
            }
        }
}

// ---- compensated_sum -----------------------------------------------------------------

static float plain_sum(const float *x, long n) {
    float sum = 0;
    for (long i = 0; i < n; i++) sum += x[i];
    return sum;
}

// What is lost goes to the next term, by Kahan; right while the sum is the larger.
static float kahan_sum(const float *x, long n) {
    float sum = 0, lost = 0;
    for (long i = 0; i < n; i++) {
        const float term = x[i] + lost, next = sum + term;
        lost = term - (next - sum);
        sum = next;
    }
    return sum;
}

// The same for sums that may be the smaller one.
static float branching_kahan_sum(const float *x, long n) {
    float sum = 0, lost = 0;
    for (long i = 0; i < n; i++) {
        const float term = x[i] + lost, next = sum + term;
        lost = fabsf(sum) >= fabsf(term) ? (sum - next) + term : (term - next) + sum;
        sum = next;
    }
    return sum + lost;
}

// What is lost is summed apart, by Neumaier; right while that sum is short.
static float neumaier_sum(const float *x, long n) {
    float sum = 0, lost = 0;
    for (long i = 0; i < n; i++) {
        const float next = sum + x[i];
        lost += fabsf(sum) >= fabsf(x[i]) ? (sum - next) + x[i] : (x[i] - next) + sum;
        sum = next;
    }
    return sum + lost;
}

// Kahan's with y = x + c where y = x - c belongs.
static float added_kahan_sum(const float *x, long n) {
    float sum = 0, c = 0;
    for (long i = 0; i < n; i++) {
        const float y = x[i] + c, next = sum + y;
        c = (next - sum) - y;
        sum = next;
    }
    return sum;
}

// Neumaier's, but it compares sum and x, not their sizes.
static float signed_neumaier_sum(const float *x, long n) {
    float sum = 0, lost = 0;
    for (long i = 0; i < n; i++) {
        const float next = sum + x[i];
        lost += sum >= x[i] ? (sum - next) + x[i] : (x[i] - next) + sum;
        sum = next;
    }
    return sum + lost;
}

static float subtracted_sum(const float *x, long n) {
    const float plain = plain_sum(x, n);
    return plain - (neumaier_sum(x, n) - plain);
}

// Of many terms, all of one sign, a thousand at a time in double.
static exact sum_exact(const float *x, long n, bool absolute_values) {
    const long block = n > 100000 ? 1000 : 1;
    exact sum = 0;
    for (long i = 0; i < n; i += block) {
        double part = 0;
        for (long k = i; k < i + block && k < n; k++)
            part += absolute_values ? fabs((double)x[k]) : x[k];
        sum += part;
    }
    return sum;
}

static const struct {
    const char *what;
    float (*sum)(const float *x, long n);
} sum_slips[] = {
    {"what was lost went to the next term, and was lost with it (Kahan's)",
     branching_kahan_sum},
    {"what was lost went to the next term, and was lost with it (Kahan's). And this takes the "
     "sum for the larger one, where the term may be",
     kahan_sum},
    {"the correction's sign: Kahan's c is subtracted from the next term", added_kahan_sum},
    {"the sum is compared with x: compare their sizes, |sum| with |x|", signed_neumaier_sum},
    {"what is lost is itself summed in a plain float (Neumaier's), and of that sum much is "
     "lost in turn",
     neumaier_sum},
    {"what was lost is subtracted: its sign", subtracted_sum},
    {"the plain float sum: what it loses is not added, or is optimised away", plain_sum},
};

// One result proves nothing: does the answer sum as this one does, bit for bit, also lists of
// many sizes and both signs, half of which cancel?
static bool sums_like(float (*sum)(const float *x, long n)) {
    enum { N = 100, LISTS = 24 };
    rng g = check_rng(36);
    for (int k = 0; k < LISTS; k++) {
        float x[N];
        for (int i = 0; i < N; i++) {
            const double draw = 2 * rng_double(&g) - 1, size = rng_double(&g);
            x[i] = (float)(draw * pow(10, k % 12 * size));
        }
        for (int i = N / 2; i < N && k % 2; i++) x[i] = -x[N - 1 - i];
        if (compensated_sum(x, N) != sum(x, N)) return false;
    }
    return true;
}

static void check_sum(const char *what, const float *x, long n) {
    const exact sum = sum_exact(x, n, false), size = sum_exact(x, n, true);
    const double u = 0x1p-24,
                 fair = 2 * u * fabs((double)sum) + 4 * (double)n * u * u * (double)size;
    const double got = (double)compensated_sum(x, n);
    if (fabs(got - (double)sum) <= fair) return; // the suspects take time
    given("%s, n = %ld; the sum of |x| is %.9g", what, n, (double)size);
    if (n == 0) suspect_value("x[0] was read, though n = 0", (double)x[0]);
    for (int k = 0; k < COUNT(sum_slips); k++)
        if (sums_like(sum_slips[k].sum))
            suspect_value(sum_slips[k].what, (double)sum_slips[k].sum(x, n));
    if (fabs(got) <= 2 * (double)size)
        suspect_value("some of what float additions lose is not kept", got);
    CHECK_REAL((double)compensated_sum(x, n), (double)sum,
               absolute_of(fair, "2u |sum| + 4n u² (sum of |x|), u = 2^-24"));
}

static void sum_by_hand(void) {
    static const float none[1] = {7}, hidden[] = {1, 1e10f, -1e10f};
    static const float counted[] = {16777216, 1, 1, 1, 1, 1, 1};
    static const float twice[] = {3, 1e10f, -5, 1e20f, 7, -1e20f, -1e10f};
    check_sum("no terms", none, 0);
    check_sum("7", none, 1);
    check_sum("2^24 and six ones", counted, COUNT(counted));
    check_sum("1, 1e10, -1e10", hidden, COUNT(hidden));
    check_sum("3, 1e10, -5, -1e10", (const float[]){3, 1e10f, -5, -1e10f}, 4);
    check_sum("3, 1e10, -5, 1e20, 7, -1e20, -1e10", twice, COUNT(twice));
}

static void sum_generic(void) {
    enum { N = 2000 };
    static float x[N];
    rng g = check_rng(21);
    for (int k = 0; k < 300; k++) {
        const long n = 1 + (long)(rng_double(&g) * N);
        for (long i = 0; i < n; i++) {
            const double draw = 2 * rng_double(&g) - 1, size = rng_double(&g);
            x[i] = (float)(draw * pow(10, k % 13 * size - k % 7));
        }
        for (long i = n / 2; i < n && k % 3 == 0; i++) x[i] = -x[n - 1 - i]; // it cancels
        check_sum(k % 3 ? "terms of both signs and many sizes" : "the same, that cancel", x, n);
    }
}

static float *ten_million(void) {
    float *x = malloc(10000000 * sizeof *x);
    CHECK(x != NULL, "memory for ten million floats");
    return x;
}

static void sum_of_many(void) {
    const float terms[] = {0.1f, 0.7f, 1.0f / 3};
    const long n = 10000000;
    float *x = ten_million();
    for (int k = 0; k < COUNT(terms); k++) {
        for (long i = 0; i < n; i++) x[i] = terms[k];
        check_sum("ten million times the same", x, n);
    }
    free(x);
}

static float quarter_circle(void *data, long i) {
    (void)i;
    const float x = (float)(rng_bits(data) >> 8) * 0x1p-24f;
    return 4 * sqrtf(1 - x * x);
}

static void sum_of_heights(void) {
    const long n = 10000000;
    float *x = ten_million();
    rng g = check_rng(22);
    for (long i = 0; i < n; i++) x[i] = quarter_circle(&g, i);
    check_sum("ten million heights of the quarter circle", x, n);
    given("π from the same: the sum / n");
    suspect_value("the plain float sum is 2 % too large", PI * 1.022);
    CHECK_REAL(compensated_sum(x, n) / (float)n, PI,
               standard_errors(5, sqrt(32.0 / 3 - PI * PI) / sqrt((double)n)));
    free(x);
}

// ---- what was given: sums in float ---------------------------------------------------

static float one(void *data, long i) {
    (void)data, (void)i;
    return 1;
}

static float four_or_zero(void *data, long i) {
    (void)i;
    const double x = 2 * rng_double(data) - 1, y = 2 * rng_double(data) - 1;
    return x * x + y * y <= 1 ? 4 : 0;
}

static void slide_is_quarter(void) {
    rng g = check_rng(23), same = g;
    const double p = montecarlo_slide(1000000, &g);
    given("the lecture's montecarlo(), a million points: π/4, standard error 0.00041");
    CHECK_REAL(p, PI / 4, standard_errors(5, sqrt(PI / 4 * (1 - PI / 4) / 1e6)));
    CHECK_REAL(sqrt(PI / 4 * (1 - PI / 4) / 1e6), 0.00041, absolute_of(0.000005, "two digits"));
    CHECK_REAL(4 * sqrt(PI / 4 * (1 - PI / 4) / 1e6), 0.0016,
               absolute_of(0.00005, "two digits"));
    CHECK_REAL(4 * p, montecarlo_slide(1000000, &same) * 4, exactly());
}

static void float_sum(void) {
    rng g = check_rng(24);
    given("float_mean of ten million heights of the quarter circle: 2.2 %% too large");
    CHECK_REAL(float_mean(10000000, quarter_circle, &g) / PI, 1.022,
               absolute_of(0.001, "rounding that leans one way: hardly any chance in it"));
    given("float_mean of thirty million: the sum stops at 2^26, the counter at 2^24");
    CHECK_REAL(float_mean(30000000, quarter_circle, &g), 4, exactly());
    float count = 0;
    for (long i = 0; i < 17000000; i++) count += one(NULL, i);
    given("a float counter counts to seventeen million");
    CHECK_REAL(count, 16777216, exactly());
}

static void float_stalls(void) {
    rng g = check_rng(25);
    given("float_running_mean of thirty million heights of the quarter circle");
    CHECK_REAL(float_running_mean(30000000, quarter_circle, &g), 2.926,
               absolute_of(0.002, "rounding that leans one way: hardly any chance in it"));
    given("float_running_mean of thirty million times 4 in the circle, 0 outside");
    CHECK_REAL(float_running_mean(30000000, four_or_zero, &g), 2.421,
               absolute_of(0.003, "rounding that leans one way: hardly any chance in it"));
}

// ---- what was given: points ----------------------------------------------------------

static long size_of_set(point_kind kind) {
    return kind == STRATIFIED ? 100 : 128;
}

static void points_in_square(void) {
    for (int kind = 0; kind < POINT_KINDS; kind++)
        for (uint64_t seed = 0; seed < 200; seed++)
            for (long i = 0; i < size_of_set(kind); i++) {
                const point2 p = point_of(kind, i, size_of_set(kind), seed * 12345678901);
                given("%s point %ld: (%.17g, %.17g)", point_names[kind], i, p.u, p.v);
                CHECK(p.u >= 0 && p.u < 1 && p.v >= 0 && p.v < 1, "in [0, 1)");
            }
}

// Given i, over many seeds, the point is uniform in the square: 8 x 8 cells.
static void points_uniform(void) {
    enum { SEEDS = 6400 };
    rng g = check_rng(26);
    for (int kind = 0; kind < POINT_KINDS; kind++) {
        if (kind == STRATIFIED) continue; // its i-th lies in the i-th square
        const long which[] = {0, 1, 77, 1234567};
        for (int k = 0; k < COUNT(which); k++) {
            long cell[64] = {0};
            for (int s = 0; s < SEEDS; s++) {
                const uint64_t seed = rng_bits(&g);
                const point2 p = point_of(kind, which[k], 1 << 21, seed);
                cell[cell_in(p.v, 8) * 8 + cell_in(p.u, 8)]++;
            }
            given("%s point %ld for 6400 seeds in 8 x 8 cells", point_names[kind], which[k]);
            check_chi2(cell, 64, SEEDS);
        }
    }
}

static void points_unbiased(void) {
    const int d = 2, sets = 2000;
    rng g = check_rng(27);
    for (int kind = 0; kind < POINT_KINDS; kind++) {
        const uint64_t seed = rng_bits(&g);
        const long n = kind == STRATIFIED ? 25 : 27;
        const estimate circle = points_estimate(kind, four_in_circle, NULL, n, sets, seed);
        given("π from 2000 sets of %ld %s points", n, point_names[kind]);
        CHECK_REAL(circle.value, PI, standard_errors(5, circle.standard_error));
        const estimate smooth = points_estimate(kind, product_of_exp, &d, n, sets, seed);
        given("the product of e^x/(e - 1) from 2000 sets of %ld %s points", n,
              point_names[kind]);
        CHECK_REAL(smooth.value, 1, standard_errors(5, smooth.standard_error));
        CHECK_INT(smooth.n, n * sets);
    }
}

// Every interval of area 1/n whose sides are halves of halves holds one of n = 2^k points,
// and so for each run of n points that begins at a multiple of n.
static void check_intervals(const char *name, const point2 *p, int k) {
    static int count[1 << 10];
    const int n = 1 << k;
    for (int a = 0; a <= k; a++) {
        memset(count, 0, sizeof count);
        for (int i = 0; i < n; i++)
            count[((int)(p[i].u * (1 << a)) << (k - a)) + (int)(p[i].v * (1 << (k - a)))]++;
        for (int i = 0; i < n; i++) {
            given("%s, %d points: interval %d of %d x %d", name, n, i, 1 << a, 1 << (k - a));
            CHECK_INT(count[i], 1);
        }
    }
}

static void sobol_intervals(void) {
    static point2 p[1 << 10];
    rng g = check_rng(28);
    for (int k = 0; k <= 10; k++)
        for (int run = 0; run < 5; run++) {
            const uint64_t start = (uint64_t)(run < 2 ? run : (int)(rng_bits(&g) >> 8)) << k;
            const uint64_t seed = rng_bits(&g);
            for (int i = 0; i < 1 << k; i++) p[i] = sobol_point(start + (uint64_t)i);
            check_intervals("Sobol", p, k);
            for (int i = 0; i < 1 << k; i++)
                p[i] = point_of(SOBOL, (long)start + i, 1L << k, seed);
            check_intervals("Sobol, scrambled", p, k);
        }
}

// The binomial coefficients' parity, by Pascal's rule, and the first points as everywhere.
static void sobol_by_hand(void) {
    static const point2 first[] = {{0, 0},         {0.5, 0.5},     {0.25, 0.75},
                                   {0.75, 0.25},   {0.125, 0.625}, {0.625, 0.125},
                                   {0.375, 0.375}, {0.875, 0.875}};
    for (int i = 0; i < COUNT(first); i++) {
        given("Sobol's point %d", i);
        CHECK_REAL(sobol_point((uint64_t)i).u, first[i].u, exactly());
        CHECK_REAL(sobol_point((uint64_t)i).v, first[i].v, exactly());
    }
    static bool odd[53][53];
    for (int j = 0; j < 53; j++)
        for (int k = 0; k <= j; k++)
            odd[j][k] = k == 0 || k == j || odd[j - 1][k - 1] != odd[j - 1][k];
    rng g = check_rng(29);
    for (int run = 0; run < 1000; run++) {
        const uint64_t high = rng_bits(&g) >> 11, i = high << 32 | rng_bits(&g);
        double want = 0;
        for (int k = 0; k < 53; k++) {
            int ones = 0;
            for (int j = k; j < 53; j++) ones += (i >> j & 1) && odd[j][k];
            want += ones % 2 * pow(2, -1 - k);
        }
        given("Sobol's point %llu", (unsigned long long)i);
        CHECK_REAL(sobol_point(i).v, want, exactly());
        CHECK_REAL(sobol_point(i).u, radical_inverse(2, i), exactly());
    }
}

// Owen's scrambling: two points that agree in k digits and differ in the next agree and
// differ there still, and below are independent: the next three digits of both, 64 cells.
static void sobol_scrambled(void) {
    enum { SEEDS = 20000 };
    rng g = check_rng(30);
    for (int k = 0; k < 8; k++) {
        const uint64_t i = rng_bits(&g) >> 8;
        const uint64_t other = i ^ (uint64_t)1 << k ^ (uint64_t)(rng_bits(&g) >> 20) << (k + 1);
        long cell[64] = {0};
        for (int s = 0; s < SEEDS; s++) {
            const uint64_t seed = rng_bits(&g);
            const double a = point_of(SOBOL, (long)i, 1, seed).u * (2 << k);
            const double b = point_of(SOBOL, (long)other, 1, seed).u * (2 << k);
            given("scrambled points %llu and %llu: they differ first in digit %d",
                  (unsigned long long)i, (unsigned long long)other, k + 1);
            CHECK(floor(a / 2) == floor(b / 2) && floor(a) != floor(b), "so still scrambled");
            cell[(int)(8 * (a - floor(a))) * 8 + (int)(8 * (b - floor(b)))]++;
        }
        check_chi2(cell, 64, SEEDS);
    }
}

static double wrapped(double x) {
    return x - floor(x + 0.5);
}

// The shift is one for all points of a set.
static void shifted_sets(void) {
    rng g = check_rng(31);
    const exact plastic[] = {(exact)0.75487766624669276005L, (exact)0.56984029099805326591L};
    for (int run = 0; run < 2000; run++) {
        const uint64_t seed = rng_bits(&g);
        const long i = (long)(some_index(&g) >> 22); // below 2^40
        const point2 h0 = point_of(HALTON, 0, 1, seed), h = point_of(HALTON, i, 1, seed);
        given("Halton, seed %llu: point %ld minus point 0", (unsigned long long)seed, i);
        const allowance fair = absolute_of(1e-15, "a few roundings of numbers below 1");
        CHECK_REAL(wrapped(h.u - h0.u - radical_inverse(2, (uint64_t)i)), 0, fair);
        CHECK_REAL(wrapped(h.v - h0.v - radical_inverse(3, (uint64_t)i)), 0, fair);
        const point2 r0 = point_of(R2, 0, 1, seed), r = point_of(R2, i, 1, seed);
        const exact a = (exact)i * plastic[0], b = (exact)i * plastic[1];
        given("R2, seed %llu: point %ld minus point 0", (unsigned long long)seed, i);
        const allowance far = absolute_of(1e-15 + 1e-19 * (double)i, "constants of 64 bits");
        CHECK_REAL(wrapped(r.u - r0.u - (double)(a - (exact)(int64_t)a)), 0, far);
        CHECK_REAL(wrapped(r.v - r0.v - (double)(b - (exact)(int64_t)b)), 0, far);
    }
}

// How much less than random points: the root of the mean square error of one set.
static double rms(point_kind kind, integrand f, const void *data, long n, uint64_t seed) {
    const int sets = 200;
    return points_estimate(kind, f, data, n, sets, seed).standard_error * sqrt(sets);
}

// The slope between 64 and 4096 points.
static void point_slopes(void) {
    static const struct {
        point_kind kind;
        double circle, smooth;
    } rows[] = {{RANDOM, -0.5, -0.5}, {STRATIFIED, -0.75, -1}, {SOBOL, -0.75, -1.5}};
    const int d = 2;
    rng g = check_rng(32);
    for (int k = 0; k < COUNT(rows); k++) {
        const point_kind kind = rows[k].kind;
        const uint64_t seed = rng_bits(&g);
        const double circle = rms(kind, four_in_circle, NULL, 4096, seed) /
                              rms(kind, four_in_circle, NULL, 64, seed);
        given("%s points, the circle: the slope of the error from 64 to 4096 points",
              point_names[kind]);
        CHECK_REAL(log(circle) / log(64), rows[k].circle,
                   absolute_of(0.1,
                               "200 sets: each error is known to 5 %, so 5 standard errors "
                               "are 0.085"));
        const double smooth =
            rms(kind, product_of_exp, &d, 4096, seed) / rms(kind, product_of_exp, &d, 64, seed);
        given("%s points, e^x e^y: the slope of the error from 64 to 4096 points",
              point_names[kind]);
        CHECK_REAL(log(smooth) / log(64), rows[k].smooth,
                   absolute_of(0.15, "as above; and Sobol's is -3/2 up to a logarithm"));
    }
}

static double slope(point_kind kind, integrand f, const void *data, uint64_t seed) {
    return log(rms(kind, f, data, 4096, seed) / rms(kind, f, data, 64, seed)) / log(64);
}

// Halton's and R2's are not powers as clean: they are only held to be steeper than random's,
// by as much as 5 standard errors leave of the text's -0.7 and -0.9.
static void sequence_slopes(void) {
    const int d = 2;
    rng g = check_rng(34);
    for (int k = 0; k < 2; k++) {
        const point_kind kind = k ? R2 : HALTON;
        const uint64_t seed = rng_bits(&g);
        given("%s points: the slope of the error from 64 to 4096 points", point_names[kind]);
        const double of_circle = slope(kind, four_in_circle, NULL, seed);
        const double of_smooth = slope(kind, product_of_exp, &d, seed);
        CHECK_AT_MOST(of_circle, -0.6, "-0.7, and 5 standard errors are 0.085");
        CHECK_AT_MOST(of_smooth, -0.75, "-0.9, and 5 standard errors are 0.085");
    }
}

int main(void) {
    static const char *const share =
        "Four times the share in the circle; and what is the variance "
        "of a coin that shows heads with probability p?";
    static const char *const estimator = "The mean of f at n random points; the variance of "
                                         "the mean is that of f, divided by n.";
    static const char *const welford =
        "Keep the sum of squared deviations from the mean so far, not the sum of squares.";
    static const char *const squares =
        "i counts the squares; its column and row are a remainder and a quotient.";
    static const char *const mirror =
        "The last digit of i is i % base. It becomes the first behind the point.";
    static const char *const kept = "What does sum + x lose? Keep it in a second float.";
    static const char *const kept_small =
        "The second float is a float sum too: do not let it grow. And is the sum always the "
        "larger of the two?";
    static const char *const given_code = "Given code: did it change?";
    static const test tests[] = {
        {"estimate_pi: π, not π/4", pi_not_a_quarter, share},
        {"estimate_pi: the standard error of a million points", pi_error_at_a_million, share},
        {"estimate_pi: the standard error for any n", pi_error_formula,
         "p is the share that was found; the points' own mean takes one of the n: n - 1."},
        {"estimate_pi: one point", pi_one_point, "One value says nothing of its error."},
        {"estimate_pi: mean and variance of 4000 estimates", pi_mean_and_variance,
         "Independent points: is a number of one point used again for the next? Is g the "
         "caller's?"},
        {"estimate_pi: 68 in 100 within one standard error", pi_claim,
         "The standard error is a claim about how far the value is from π."},
        {"estimate_pi: thirty million points", pi_many_points, "How far can a float count?"},
        {"monte_carlo: four values by hand", mc_by_hand, estimator},
        {"monte_carlo: one, two, and equal values", mc_one_and_two,
         "One value says nothing of its error; equal values say that there is none: keep "
         "squared deviations from the mean, which are then 0."},
        {"monte_carlo: a large mean", mc_large_mean, welford},
        {"monte_carlo: the draws", mc_draws,
         "Two loops, n points of `dimensions` coordinates, x[0] to x[dimensions - 1], and one "
         "rng_double of g for each."},
        {"monte_carlo: the points", mc_points,
         "Every coordinate of every point is drawn from g."},
        {"monte_carlo: 1 to 8 dimensions", mc_dimensions, estimator},
        {"monte_carlo: twice the same", mc_again,
         "No static variables, no generator of its own."},
        {"monte_carlo: the standard error as a claim", mc_claim, estimator},
        {"monte_carlo: the slope in 1, 4 and 7 dimensions", mc_slope, estimator},
        {"stratified_point: one in each square", one_in_each_square, squares},
        {"stratified_point: uniform in its square", stratified_uniform,
         "Somewhere in the square: two draws from g."},
        {"stratified_point: the same g, the same point", stratified_from_g,
         "No static variables, no generator of its own."},
        {"stratified_point: never 1", stratified_below_one,
         "m - 1 plus nearly 1, rounded, divided by m."},
        {"stratified_point: m = 2^31", stratified_huge, squares},
        {"stratified_point: the variance of π", stratified_pi, squares},
        {"radical_inverse: by hand", inverse_by_hand, mirror},
        {"radical_inverse: against 113 bits", inverse_generic, mirror},
        {"radical_inverse: never 1", inverse_below_one, "What is 1 - 2^-60 in double?"},
        {"radical_inverse: one in each interval", inverse_intervals, mirror},
        {"compensated_sum: by hand", sum_by_hand, kept},
        {"compensated_sum: both signs, many sizes", sum_generic, kept_small},
        {"compensated_sum: ten million times the same", sum_of_many, kept_small},
        {"compensated_sum: ten million heights of the circle", sum_of_heights, kept_small},
        {"montecarlo_slide: π/4", slide_is_quarter, given_code},
        {"float_mean: 2 % off, then 4", float_sum, given_code},
        {"float_running_mean: it stalls", float_stalls, given_code},
        {"point_of: in the square", points_in_square, given_code},
        {"point_of: uniform over the seeds", points_uniform, given_code},
        {"points_estimate: unbiased", points_unbiased, given_code},
        {"sobol_point: first points and Pascal's triangle", sobol_by_hand, given_code},
        {"point_of: Sobol, one in each elementary interval", sobol_intervals, given_code},
        {"point_of: Sobol's scrambling is Owen's", sobol_scrambled, given_code},
        {"point_of: Halton and R2, one shift for all", shifted_sets, given_code},
        {"points_estimate: slopes", point_slopes, given_code},
        {"points_estimate: Halton and R2, steeper than random", sequence_slopes, given_code},
    };
    return run_tests("08-monte-carlo", tests, COUNT(tests));
}
