// fresnel_conductor: how much does a metal reflect? The task is in README.md.
#include "chapters/11-fresnel/fresnel.h"
#include "common/todo.h"

color fresnel_conductor(real cosine, color eta, color k) {
    TODO("fresnel_conductor"); // your answer instead of these two lines
    return (color){0, 0, 0};
}
