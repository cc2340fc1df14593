// obj_index.c: see obj_inside.h.
#include "chapters/12-bvh/obj_inside.h"

// Takes a whole number off the word. Digits of a number that is far out of range are skipped.
static obj_index take_index(obj_word *w) {
    const int64_t far = INT64_MAX / 100;
    const bool minus = w->begin < w->end && *w->begin == '-';
    const char *digits = w->begin + minus, *p = digits;
    int64_t value = 0;
    for (; p < w->end && *p >= '0' && *p <= '9'; p++)
        if (value < far) value = 10 * value + (*p - '0');
    if (p == digits) return (obj_index){{p, p}, 0};
    const obj_index i = {{w->begin, p}, minus ? -value : value};
    w->begin = p;
    return i;
}

static bool take_slash(obj_word *w) {
    if (obj_is_empty(*w) || *w->begin != '/') return false;
    w->begin++;
    return true;
}

bool obj_split_corner(obj_word w, obj_index *point, obj_index *normal) {
    *point = take_index(&w);
    *normal = (obj_index){0};
    if (obj_is_empty(point->word)) return false;
    if (obj_is_empty(w)) return true;
    if (!take_slash(&w)) return false;
    const obj_index texture = take_index(&w);
    if (obj_is_empty(w)) return !obj_is_empty(texture.word);
    if (!take_slash(&w)) return false;
    *normal = take_index(&w);
    return obj_is_empty(w) && !obj_is_empty(normal->word);
}
