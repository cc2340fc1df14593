# openmp.sh CC: prints the compiler's flags for OpenMP, or nothing where a program
# with it cannot be built: the pixel loops then run on one core.
probe=$(mktemp -d) || exit 0
printf '#include <omp.h>\nint main(void) { return omp_get_max_threads() < 1; }\n' > "$probe/probe.c"
if "$@" -fopenmp "$probe/probe.c" -o "$probe/probe" >/dev/null 2>&1 && "$probe/probe"; then
    echo -fopenmp
    # clang warns of a simd loop that it runs step by step, as with sanitizers: right, and slower.
    "$@" -Werror -Wpass-failed -c "$probe/probe.c" -o "$probe/probe.o" >/dev/null 2>&1 &&
        echo -Wno-pass-failed
fi
rm -rf "$probe"
