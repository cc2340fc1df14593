// checks_average: a checkered floor without noise. The task is in README.md.
#include "chapters/03-plane/plane.h"
#include "common/todo.h"

real checks_average(real x, real z, real w) {
    TODO("checks_average"); // your answer instead of these two lines
    return checks(x, z);
}
