#!/bin/sh
# complete.sh CHAPTER...: every chapter has its texts and programs, and every
# exercise its stub, solution, task, three hints, tests and two wrong answers.
complain() {
    echo "$*"
    touch "$scratch/bad"
}
scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT
count=0
for chapter in "$@"; do
    for file in chapters/$chapter/README.md chapters/$chapter/main.c chapters/$chapter/measure.c \
        exercises/$chapter/README.md exercises/$chapter/hints.txt tests/$chapter.c; do
        [ -f "$file" ] || complain "$file is missing"
    done
    for heading in "The idea" "The code" "Check the slide" "The trade" "At the extremes" \
        "What this leaves out" "Exercises" "Sources"; do
        grep -q "^## $heading" "chapters/$chapter/README.md" ||
            complain "chapters/$chapter/README.md has no section \"$heading\""
    done
    for stub in exercises/"$chapter"/*.c; do
        [ -f "solutions/$chapter/${stub##*/}" ] || complain "$stub has no solution"
    done
    for solution in solutions/"$chapter"/*.c; do
        name=${solution##*/}
        name=${name%.c}
        count=$((count + 1))
        grep -q "TODO(\"$name\")" "exercises/$chapter/$name.c" 2>/dev/null ||
            complain "exercises/$chapter/$name.c: no stub with TODO(\"$name\")"
        grep -q "$name" "exercises/$chapter/README.md" ||
            complain "exercises/$chapter/README.md has no task for $name"
        grep -q "\"$name: " "tests/$chapter.c" || complain "tests/$chapter.c: no test named \"$name: ...\""
        hints=$(awk -v name="$name" '/^[a-z_0-9]+$/ { on = $0 == name } on && /^[123] / { n++ } END { print n + 0 }' \
            "exercises/$chapter/hints.txt")
        [ "$hints" -eq 3 ] || complain "exercises/$chapter/hints.txt: $name has $hints hints, not 3"
        wrong=$(find "tests/$chapter/wrong" -name "$name-*.c" 2>/dev/null | wc -l)
        [ "$wrong" -ge 2 ] || complain "tests/$chapter/wrong: $name has $wrong wrong answers, at least 2 are wanted"
    done
    for variant in tests/"$chapter"/wrong/*.c tests/"$chapter"/right/*.c; do
        [ -f "$variant" ] || continue
        name=${variant##*/}
        [ -f "solutions/$chapter/${name%%-*}.c" ] || complain "$variant: no exercise ${name%%-*}"
    done
done
[ -e "$scratch/bad" ] && exit 1
echo "complete: $count exercises have stub, solution, task, hints, tests and wrong answers"
