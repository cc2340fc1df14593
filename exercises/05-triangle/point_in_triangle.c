// point_in_triangle: the inside test of the first method. The task is in README.md.
#include "chapters/05-triangle/triangle.h"
#include "common/todo.h"

bool point_in_triangle(vec3 p, triangle T, vec3 n) {
    TODO("point_in_triangle"); // your answer instead of these two lines
    return false;
}
