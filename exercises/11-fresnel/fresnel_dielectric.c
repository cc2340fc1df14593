// fresnel_dielectric: how much does glass reflect? The task is in README.md.
#include "chapters/11-fresnel/fresnel.h"
#include "common/todo.h"

real fresnel_dielectric(real cosine, real eta) {
    TODO("fresnel_dielectric"); // your answer instead of these two lines
    return 0;
}
