#!/bin/sh
# variants.sh B PROGRAM...: every answer in tests/*/wrong/ must fail its exercise's
# tests and be told why (the texts after "// Expect:" in it); every answer in
# tests/*/right/ must pass, and with it the chapter's other exercises, which may build on
# it. PROGRAM is B/tests/CHAPTER/wrong/EXERCISE-what.
build=$1
shift

judge() { # program: prints what is wrong with it, nothing when all is well
    source=${1#"$build"/}.c
    name=${source##*/}
    exercise=${name%%-*}
    exercise=${exercise%.c}
    case $source in
    */right/*) out=$("$1" 2>&1) ;;
    *) out=$(FULL=1 T="$exercise:" "$1" 2>&1) ;;
    esac
    status=$?
    case $source in
    */right/*)
        [ "$status" -eq 0 ] || printf '%s: a right answer fails:\n%s\n' "$source" "$out"
        return
        ;;
    esac
    if [ "$status" -eq 0 ] || ! printf '%s\n' "$out" | grep '^FAIL' >/dev/null; then
        printf '%s: a wrong answer is not caught\n' "$source"
        return
    fi
    grep '^// Expect:' "$source" >/dev/null || echo "$source: has no line // Expect:"
    sed -n 's|^// Expect: *||p' "$source" | while IFS= read -r words; do
        printf '%s\n' "$out" | grep -F -e "$words" >/dev/null && continue
        printf '%s: the tests do not say "%s" but\n' "$source" "$words"
        printf '%s\n' "$out" | grep -v '^ok' | head -40 | sed 's/^/    /'
    done
}

scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT
# Two at a time: the odd ones beside the even ones.
half() {
    want=$1
    shift
    turn=0
    for program in "$@"; do
        turn=$((1 - turn))
        [ "$turn" -eq "$want" ] && judge "$program"
    done
}
half 0 "$@" >"$scratch/even" &
half 1 "$@" >"$scratch/odd"
wait
cat "$scratch/odd" "$scratch/even"
[ -s "$scratch/odd" ] || [ -s "$scratch/even" ] && exit 1
wrong=$(printf '%s\n' "$@" | grep -c /wrong/)
echo "variants: $wrong wrong answers are caught with their hint, $(($# - wrong)) other right ones pass"
