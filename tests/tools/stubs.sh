#!/bin/sh
# stubs.sh PROGRAM...: every stub must fail its tests, and say todo. PROGRAM is
# .../one/CHAPTER/EXERCISE: a chapter's tests linked with just this one stub.
scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT
bad=0
for program in "$@"; do
    exercise=${program##*/}
    chapter=${program%/*}
    chapter=${chapter##*/}
    rm -f "$scratch/tally"
    T="$exercise:" QUIET=1 TALLY="$scratch/tally" "$program" >"$scratch/out" 2>&1
    status=$?
    read -r passed failed todo <"$scratch/tally" || todo=0 failed=0 passed=0
    if [ "$status" -eq 0 ] || [ "$failed" -ne 0 ] || [ "$todo" -eq 0 ]; then
        echo "stub exercises/$chapter/$exercise.c: expected only todo, got $passed passed, $failed failed, $todo todo"
        sed 's/^/    /' "$scratch/out"
        bad=1
    fi
done
[ "$bad" -eq 0 ] && echo "stubs: $# stubs fail their tests and say todo"
exit "$bad"
