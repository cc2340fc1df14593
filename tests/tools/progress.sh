#!/bin/sh
# progress.sh LIST: how far a student has come, found out by running the tests.
# LIST has lines "chapter exercise program". The program is the chapter's tests
# with the student's version of just this exercise and the solutions of the rest;
# "-" or a missing file: that version does not compile. Only the tests named after
# the exercise are run.
set -u

[ -r "${1:-}" ] || {
    echo "progress: cannot read the list ${1:-(none was given)}" >&2
    exit 2
}
tmp=$(mktemp -d "${TMPDIR:-/tmp}/progress.XXXXXX") || exit 1
trap 'rm -rf "$tmp"' EXIT
trap 'exit 130' INT TERM
unset T TAP JUNIT SOLUTIONS

# What the program's tests say of the exercise, in words.
state() { # CHAPTER EXERCISE PROGRAM
    if [ "$3" = - ] || [ ! -x "$3" ]; then
        echo "does not compile (make test-${1%%-*} T=$2)"
        return
    fi
    passed=0 failed=0 todo=0 again="make test-${1%%-*} T=$2"
    rm -f "$tmp/tally"
    T="$2:" QUIET=1 TALLY=$tmp/tally "$3" >/dev/null 2>&1 </dev/null
    [ -s "$tmp/tally" ] && read -r passed failed todo <"$tmp/tally"
    all=$((passed + failed + todo)) bad=$((failed + todo))
    if [ $all = 0 ]; then
        echo "wrong (the tests do not run; $again)"
    elif [ $bad = 0 ]; then
        echo right
    elif [ "$failed" = 0 ]; then
        echo 'not started'
    else
        echo "wrong ($bad of $all tests fail; $again)"
    fi
}

right=0 total=0 last=
while read -r chapter exercise program; do
    [ -n "$chapter" ] || continue
    words=$(state "$chapter" "$exercise" "${program:--}")
    total=$((total + 1))
    [ "$words" = right ] && right=$((right + 1))
    [ -n "$last" ] && [ "$chapter" != "$last" ] && echo
    printf '%-22s  %-22s  %s\n' "$chapter" "$exercise" "$words"
    last=$chapter
done <"$1"
[ $total -gt 0 ] && echo
# The homework takes minutes to judge, so only whether it is begun.
homework=${EXERCISES:-exercises}/homework
if [ -d "$homework" ]; then
    words='begun (make homework)'
    grep -v '^ *//' "$homework"/*.c 2>/dev/null | grep -q '[a-z]' || words='not started'
    printf '%-22s  %-22s  %s\n\n' homework '' "$words"
fi
echo "$right of $total right"
