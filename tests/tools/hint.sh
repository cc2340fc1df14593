#!/bin/sh
# hint.sh CHAPTER N [T]: the hints 1 to N of each exercise of a chapter, or only
# of the one called T, or else of those whose name contains T. They stand in exercises/CHAPTER/hints.txt: a
# line with the exercise's name, then paragraphs that begin with "1 ", "2 ", "3 ";
# further lines of a paragraph are indented.
set -u

chapter=${1:-} n=${2:-1} filter=${3:-}
file=exercises/$chapter/hints.txt

fail() {
    echo "hint: $1" >&2
    exit 2
}

[ -n "$chapter" ] || fail 'which chapter? For example: make hint-04'
[ -r "$file" ] || fail "there is no $file"
case $n in
    [1-9]) ;;
    *) fail "N must be a number from 1 to 9, not \"$n\"" ;;
esac

exact=0
[ -n "$filter" ] && grep -qxF -e "$filter" "$file" && exact=1

# From the environment, since awk -v would read backslashes as escapes.
N=$n EXACT=$exact FILTER=$filter CHAPTER=$chapter awk '
    BEGIN {
        n = ENVIRON["N"]; exact = ENVIRON["EXACT"]; filter = ENVIRON["FILTER"]; chapter = ENVIRON["CHAPTER"]
    }
    /^[ \t]*$/ { next }
    /^[1-9] / { hint = $1 + 0; if (chosen && hint > last) last = hint }
    /^[^ \t1-9]/ {
        hint = 0
        names = names " " $1
        chosen = filter == "" || (exact + 0 ? $1 == filter : index($1, filter) > 0)
        if (chosen && found++) print ""
        if (chosen) print $1
        next
    }
    chosen && hint > 0 && hint <= n { print "  " $0 }
    END {
        if (!found) {
            printf "hint: no exercise of %s has a name that contains \"%s\"; there are:%s\n", \
                chapter, filter, names | "cat 1>&2"
            exit 2
        }
        number = substr(chapter, 1, index(chapter "-", "-") - 1)
        if (n < last)
            printf "\nThe next one: make hint-%s N=%d%s\n", number, n + 1, \
                filter == "" ? "" : " T=" filter
        else
            printf "\nThat was the last hint. The answer: solutions/%s\n", chapter
    }' "$file"
