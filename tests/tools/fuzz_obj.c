// fuzz_obj.c: texts that nobody would write, for the OBJ reader; `make fuzz` runs it. libFuzzer
// makes them from those in tests/12-bvh/obj/ and follows new paths through the code.
#include "tests/check-obj.h"

static void stop_at(const char *fault) {
    if (!fault) return;
    fprintf(stderr, "fuzz_obj: %s\n", fault);
    abort();
}

static bool read(const char *text, size_t length, mesh *m) {
    char error[OBJ_ERROR];
    obj_report about;
    const bool done = obj_parse(text, length, "fuzz.obj", m, &about, error);
    stop_at(obj_fault(done, m, &about, "fuzz.obj", error));
    return done;
}

// The same lines with CR LF are the same mesh.
static void read_with_other_ends(const char *text, size_t length, bool done, const mesh *m) {
    if (memchr(text, '\r', length)) return;
    char *other = malloc(2 * length + 1);
    size_t used = 0;
    for (size_t i = 0; i < length; i++) {
        if (text[i] == '\n') other[used++] = '\r';
        other[used++] = text[i];
    }
    mesh again;
    if (read(other, used, &again) != done) stop_at("CR LF changes whether it is read");
    if (!obj_same_mesh(m, &again)) stop_at("CR LF changes the mesh");
    mesh_free(&again);
    free(other);
}

// Whatever looks like a number, wherever it stands.
static void check_numbers(const char *text, size_t length) {
    static const char *const of_numbers = "0123456789+-.eE";
    char word[2048];
    size_t used = 0;
    for (size_t i = 0; i <= length; i++) {
        const bool more = i < length && text[i] && strchr(of_numbers, text[i]);
        if (more && used < sizeof word - 1) {
            word[used++] = text[i];
            continue;
        }
        word[used] = '\0';
        if (used) stop_at(obj_number_fault(word));
        used = 0;
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    char *text = malloc(size); // of just this size, so that a byte too far is noticed
    if (size) memcpy(text, data, size);
    mesh m;
    const bool done = read(text, size, &m);
    if (size) read_with_other_ends(text, size, done, &m);
    check_numbers(text, size);
    mesh_free(&m);
    free(text);
    return 0;
}
