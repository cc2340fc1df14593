#!/bin/sh
# homework_check.sh BUILD CHECK COURSE CC FLAGS...: does the homework's checker judge rightly?
# The solution and tests/homework/right/ must pass every stage; what is in wrong/ must fail with
# the words after its "// Expect:", in the stage after "// Stage:" (all, if it says none); an empty
# file is a todo, and one that does not compile is told so.
build=$1 check=$2 course=$3
export FULL=1 # every failure with all that is said of it
scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT

complain() {
    echo "$1:"
    sed 's/^/    /' "$scratch/$2.said"
    touch "$scratch/bad"
}

judge() { # SOURCE NUMBER: a variant
    source=$1
    stage=$(sed -n 's|^// Stage: *||p' "$source")
    seconds=$(sed -n 's|^// Seconds: *||p' "$source")
    folder=$(pwd)/$build/${source%.c}
    rm -f "$folder"/*.txt
    HOMEWORK=$folder TEST_SECONDS=${seconds:-120} T=${stage:+$stage:} "$check" >"$scratch/$2.said" 2>&1
    status=$?
    case $source in
    */right/*) [ $status -eq 0 ] || complain "$source: a right ray tracer fails" "$2" ;;
    *)
        [ $status -ne 0 ] || complain "$source: a wrong ray tracer is not caught" "$2"
        grep '^// Expect:' "$source" >/dev/null || complain "$source: has no line // Expect:" "$2"
        sed -n 's|^// Expect: *||p' "$source" | while IFS= read -r words; do
            grep -F -e "$words" "$scratch/$2.said" >/dev/null || complain "$source: it is not said \"$words\"" "$2"
        done
        ;;
    esac
}

judge_folder() { # FOLDER WORDS EXPECTED_STATUS COMMAND...
    folder=$1 words=$2 expected=$3
    shift 3
    QUIET=1 sh tests/tools/homework.sh "$folder" "$scratch/folder" "$@" >"$scratch/folder.said" 2>&1
    status=$?
    [ $status -eq "$expected" ] || complain "$folder: exit status $status, not $expected" folder
    grep -F -e "$words" "$scratch/folder.said" >/dev/null || complain "$folder: it is not said \"$words\"" folder
}

# Two at a time.
half() {
    turn=0
    for source in tests/homework/wrong/*.c tests/homework/right/*.c; do
        turn=$((turn + 1))
        [ $((turn % 2)) -eq "$1" ] && judge "$source" $turn
    done
}
half 0 &
half 1
shift
judge_folder solutions/homework '5 passed, 0 failed' 0 "$@"
judge_folder exercises/homework '5 todo' 1 "$@"
mkdir "$scratch/broken"
echo 'int main(void) { return x; }' >"$scratch/broken/main.c"
judge_folder "$scratch/broken" 'does not compile:' 1 "$@"
echo 'static int x;' >"$scratch/broken/main.c"
judge_folder "$scratch/broken" 'not defined anywhere: main' 1 "$@"
wait
[ -e "$scratch/bad" ] && exit 1
wrong=$(ls tests/homework/wrong/*.c | wc -l) right=$(ls tests/homework/right/*.c | wc -l)
echo "homework: the solution and $((right)) other right ray tracers pass, $((wrong)) wrong ones are told why"
