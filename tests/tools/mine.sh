#!/bin/sh
# mine.sh TARGET PROGRAM …: runs a program with the student's exercises in it. TARGET tests them.
# One that does not end says nothing by itself: after a minute this does.
target=$1
shift
(
    sleep "${MINE_SECONDS:-60}" 2>/dev/null
    echo "Still at it after ${MINE_SECONDS:-60} s. An endless loop in an exercise, or one that is not written yet? Ctrl-C ends it; make $target tells which." >&2
) >/dev/null &
watch=$!
trap 'kill "$watch" 2>/dev/null; exit 130' INT TERM
"$@"
status=$?
kill "$watch" 2>/dev/null
wait "$watch" 2>/dev/null
[ "$status" -eq 0 ] || echo "The program failed: make $target tells which exercise, and why." >&2
exit "$status"
