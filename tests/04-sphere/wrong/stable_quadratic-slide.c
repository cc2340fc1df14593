// Wrong: the slide's formula, in which -b and the square root cancel.
// Expect: what the slide's formula gives: digits cancelled
// Expect: only one sign is safe
#include "chapters/04-sphere/sphere.h"

roots stable_quadratic(double a, double b, double c) {
    return solve_quadratic(a, b, c);
}
