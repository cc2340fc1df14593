// refract: which way does light go on behind a surface? The task is in README.md.
#include "chapters/11-fresnel/fresnel.h"
#include "common/todo.h"

bool refract(vec3 d, vec3 n, real eta, vec3 *t) {
    TODO("refract"); // your answer instead of these two lines
    return false;
}
