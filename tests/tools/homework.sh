#!/bin/sh
# homework.sh FOLDER OUT CHECK COURSE CC FLAGS...: builds the ray tracer of FOLDER/*.c as
# OUT/raytracer, with the library COURSE, and lets CHECK judge it: a verdict and a picture of
# each stage in OUT. Exit status 0 when every stage passes.
folder=$1 out=$2 check=$3 course=$4
shift 4
case ${T:-} in
'' | build | depth | normal | mirror | path) ;;
*) echo "T is a stage: build, depth, normal, mirror or path, not \"$T\"" >&2 && exit 2 ;;
esac
case ${TEST_SECONDS:-120} in
*[!0-9]* | 0*) echo "TEST_SECONDS is a whole number of seconds, not \"$TEST_SECONDS\"" >&2 && exit 2 ;;
esac
mkdir -p "$out" || exit 1
out=$(cd "$out" && pwd)
rm -f "$out"/raytracer "$out"/empty "$out"/*.txt "$out"/*.pfm "$out"/*.png

# Of what the compiler says, the first error in one line.
first_error() {
    missing=$(sed -n -e "s/.*undefined reference to [\`']\([A-Za-z_0-9]*\)'.*/\1/p" \
        -e 's/.*undefined symbol: \([A-Za-z_0-9]*\).*/\1/p' \
        -e 's/^ *"_\([A-Za-z_0-9]*\)", referenced from.*/\1/p' "$out/compiler.txt" | sort -u | head -3 | tr '\n' ' ')
    if [ -n "$missing" ]; then
        echo "not defined anywhere: $missing"
    else
        grep -E -m 1 'error|multiple definition|duplicate' "$out/compiler.txt" || head -1 "$out/compiler.txt"
    fi
}

build() (
    ulimit -t 120 # seconds: an #include of a device never ends
    "$@" -o "$out/raytracer" "$folder"/*.c "$course" -lm >"$out/compiler.txt" 2>&1
)

if ! ls "$folder"/*.c >/dev/null 2>&1; then
    echo "there is no .c file in $folder" >"$out/errors.txt"
elif [ -z "$("$@" -E -P "$folder"/*.c 2>&1 </dev/null | tr -d ' \t\n\r')" ]; then
    : >"$out/empty"
elif ! build "$@"; then
    rm -f "$out/raytracer"
    first_error >"$out/errors.txt"
fi
[ -s "$out/compiler.txt" ] && [ -z "$QUIET" ] && head -40 "$out/compiler.txt" >&2

# Through 3 it says what it draws, while it draws: what it prints is shown at the end of a stage.
[ -z "$QUIET" ] && exec 3>&2 && export HOMEWORK_PROGRESS=3
HOMEWORK=$out TEST_SECONDS=${TEST_SECONDS:-120} TALLY=${TALLY:-$out/tally.txt} "$check"
status=$?
[ -n "$QUIET" ] && exit $status
[ -f "$out/report.txt" ] && cat "$out/report.txt"
for picture in "$out"/*.png; do
    [ -f "$picture" ] && echo "yours, right, difference: $picture"
done
[ -f "$out/empty" ] && echo "The task: $folder/README.md. Begin with depth."
# Nothing has failed, but make will say Error 1.
if [ -f "$out/todo.txt" ] && [ "$(cut -d ' ' -f 2 "$out/tally.txt" 2>/dev/null)" = 0 ]; then
    echo "No picture so far is wrong. Next: $(head -1 "$out/todo.txt") (make ends with an error until all are drawn)"
fi
exit $status
