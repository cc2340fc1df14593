#!/bin/sh
# homework_reference.sh BUILD OUT: the converged reference of the homework's path traced scene:
# 16384 samples a pixel of the solution, 1024 of its parts and of the mistakes that the checker
# knows by their picture. It takes about half an hour on two cores.
build=$1 out=$2
scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT
draw() { # PROGRAM FILE SEED SAMPLES [BOUNCES]
    program=$1 file=$2
    shift 2
    "$program" path "$scratch/$file" "$@" || exit 1
    echo "$file" >&2
}
all=
for seed in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16; do
    draw "$build/solution" "all-$seed.pfm" $seed 1024
    all=$all${all:+,}all-$seed.pfm
done
for bounces in 0 1 2 3 4; do
    draw "$build/solution" "upto-$bounces.pfm" 1 1024 $bounces
done
mistakes='no_shadows no_cosine no_lamp_cosine falloff uniform uniform_all no_cosine_all
    cosine_twice cosine_again last_color last_color_uniform both_sides'
for mistake in $mistakes; do
    draw "$build/tests/homework/wrong/path-$mistake/raytracer" $mistake.pfm 1 1024
done
reference=$(pwd)/$build/reference target=$(pwd)/$out
cd "$scratch" && "$reference" "$target" "$all" upto-0.pfm upto-1.pfm,-upto-0.pfm \
    upto-2.pfm,-upto-1.pfm upto-3.pfm,-upto-2.pfm upto-4.pfm,-upto-3.pfm \
    $(for mistake in $mistakes; do echo $mistake.pfm; done)
