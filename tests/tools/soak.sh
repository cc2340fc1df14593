#!/bin/sh
# soak.sh RAYS PROGRAM...: draws all pictures of the programs at odd seeds, sizes and depths
# until that many rays left the camera. No sample may be negative or not finite, but for
# those that show the slide's slips. A picture must not crash.
rays=$(printf %.0f "$1") # 1e8 is a number, too
shift
said=$(mktemp) || exit 1
trap 'rm -f "$said"' EXIT
trap 'exit 130' INT TERM

# The pictures that a program knows, from its --help.
pictures() {
    "$1" --help | sed -n '/^The pictures:/,$ s/^  \([a-z-]*\) .*/\1/p'
}

total=0 round=0
while [ "$total" -lt "$rays" ]; do
    round=$((round + 1))
    for program in "$@"; do
        for show in $(pictures "$program"); do
            size=$((31 + 36 * round))x$((17 + 22 * round))
            "$program" --show "$show" --size $size --samples $((3 + 4 * round)) \
                --depth $((round * round - 1)) --seed $((7919 * round)) --out /dev/null \
                >/dev/null 2>>"$said"
            # 1: a picture that asserts what it shows may be too small for it.
            [ $? -le 1 ] || echo "$program --show $show --size $size: crashed" >>"$said"
        done
    done
    total=$(sed -n 's/.*: \([0-9]*\) rays in .*/\1/p' "$said" | awk '{ n += $1 } END { print n + 0 }')
done
if grep -e 'not finite' -e crashed "$said" | grep -v 'by the slide'; then exit 1; fi
echo "soak: $total rays, no sample is negative or not finite"
