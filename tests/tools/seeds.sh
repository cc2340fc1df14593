#!/bin/sh
# seeds.sh PROGRAM N: runs a chapter's tests with SEED=1 to N: what they claim must
# hold for any random numbers, but for the false alarms that they state.
program=$1
count=$2
tally=$(mktemp) || exit 1
trap 'rm -f "$tally"' EXIT
trap 'exit 130' INT TERM
unset T TAP JUNIT

seed=1
while [ "$seed" -le "$count" ]; do
    out=$(SEED=$seed TALLY=$tally QUIET=1 "$program" 2>&1) || {
        echo "SEED=$seed:"
        printf '%s\n' "$out" | grep -A 12 -e '^FAIL' -e '^todo'
    }
    seed=$((seed + 1))
done
awk -v n="$count" '{ passed += $1; bad += $2 + $3 }
    END { printf "%d seeds: %d tests passed, %d failed\n", n, passed, bad; exit bad > 0 || NR < n }' "$tally"
