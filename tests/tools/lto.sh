# lto.sh CC: prints the compiler's flags for objects that can be linked with and without
# optimisation across files, or nothing where it has none.
probe=$(mktemp -d) || exit 0
echo 'int main(void) { return 0; }' > "$probe/probe.c"
if "$@" -O2 -flto -ffat-lto-objects -c "$probe/probe.c" -o "$probe/probe.o" 2>"$probe/said" &&
    [ ! -s "$probe/said" ] && "$@" -O2 -flto "$probe/probe.o" -o "$probe/probe" 2>"$probe/said" &&
    [ ! -s "$probe/said" ] && "$probe/probe"; then
    echo -flto -ffat-lto-objects
fi
rm -rf "$probe"
