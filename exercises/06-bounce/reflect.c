// reflect: where does a mirror send a ray? The task is in README.md.
#include "chapters/06-bounce/bounce.h"
#include "common/todo.h"

vec3 reflect(vec3 d, vec3 n) {
    TODO("reflect"); // your answer instead of these two lines
    return d;
}
