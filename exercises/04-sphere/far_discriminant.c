// far_discriminant: does the ray hit a sphere far away? The task is in README.md.
#include "chapters/04-sphere/sphere.h"
#include "common/todo.h"

real far_discriminant(sphere S, ray r) {
    TODO("far_discriminant"); // your answer instead of these two lines
    return -1;
}
