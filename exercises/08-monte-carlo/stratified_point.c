// stratified_point: one point in each square. The task is in README.md.
#include "chapters/08-monte-carlo/monte_carlo.h"
#include "common/todo.h"

point2 stratified_point(long i, long m, rng *g) {
    TODO("stratified_point"); // your answer instead of these two lines
    return (point2){0, 0};
}
