#!/bin/sh
# best.sh N PROGRAM: the CSV that a measure.c prints, of N runs the best cost of each row: the
# smallest, or where it is a gain (1/...) the largest. Other programs only ever make a run slower.
set -eu
n=$1 program=$2
case $n in [1-9]) ;; *) echo "measure: N is a number of runs from 1 to 9, not \"$n\"" >&2; exit 2 ;; esac
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
for run in 1 2 3 4 5 6 7 8 9; do
    [ "$run" -le "$n" ] || break
    "$program" >"$scratch/$run"
done
awk -F, '
FNR == 1 { files++ }
{
    cost = $NF
    row = substr($0, 1, length($0) - length(cost))
    if (files == 1) { rows[FNR] = row; best[FNR] = cost; count = FNR; next }
    if (row != rows[FNR]) { print "measure: two runs differ in " row > "/dev/stderr"; exit 1 }
    gain = $(NF - 1) ~ /^"?1\//
    if (cost != "" && (gain ? cost + 0 > best[FNR] + 0 : cost + 0 < best[FNR] + 0)) best[FNR] = cost
}
END { for (i = 1; i <= count; i++) print rows[i] best[i] }
' "$scratch"/* >"$scratch/best"
cat "$scratch/best"
