#!/bin/sh
# texts.sh check|renew CHAPTER...: the texts say what the code says.
#  - A C block names its file in its first line, // chapters/04-sphere/sphere.c,
#    and stands verbatim in it; a line // ... parts what stands apart there.
#  - Between <!-- measured: TABLE --> and <!-- end --> stands the table of errors
#    that the chapter's measure.c gives (build/errors/CHAPTER.csv), to the digit.
#  - After <!-- ratios: TABLE --> stand ratios of times, from the last
#    make measure; renewed by `renew`, not checked: no two machines agree.
mode=$1
shift
scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT

blocks() { # text: complains about C blocks that are not in the code
    awk -v text="$1" '
    function contents(file,    line, all) {
        all = "\n"
        while ((getline line < file) > 0) all = all line "\n"
        close(file)
        return all
    }
    function flush_part() {
        if (part != "" && !index(code, "\n" part)) {
            printf "%s:%d: this C block does not stand in %s:\n%s", text, start, file, part
            bad = 1
        }
        part = ""
    }
    /^```c$/ { inside = 1; start = NR; file = ""; part = ""; next }
    inside && /^```/ { flush_part(); inside = 0; blocks++; next }
    inside && file == "" {
        file = $2
        code = contents(file)
        if ($1 != "//" || code == "\n") {
            printf "%s:%d: a C block begins with // and the name of its file, not \"%s\"\n", text, NR, $0
            bad = 1
        }
        next
    }
    inside && /^ *\/\/ \.\.\.$/ { flush_part(); next }
    inside && part == "" && /^$/ { next } # an empty line behind the name
    inside { part = part $0 "\n" }
    END { exit bad }' "$1"
}

# The rows of a build with double, where a table has both, are folded away below it.
fold() { # table
    grep -v ', double *|' "$1" >"$scratch/single"
    { sed -n 1,2p "$1" && grep ', double *|' "$1"; } >"$scratch/double"
    if [ "$(wc -l <"$scratch/single")" -le 2 ] || [ "$(wc -l <"$scratch/double")" -le 2 ]; then
        cat "$1"
        return
    fi
    cat "$scratch/single"
    printf '\n<details><summary>The same with REAL=double</summary>\n\n'
    cat "$scratch/double"
    printf '\n</details>\n'
}

tables() { # text chapter: prints the text with its tables made anew
    while IFS= read -r line; do
        case $line in
        "<!-- end -->") skip= ;;
        esac
        [ -n "$skip" ] || printf '%s\n' "$line"
        name=${line#*: }
        name=${name% -->}
        case $line in
        "<!-- measured: "*) csv=build/errors/$2.csv kind=errors ;;
        "<!-- ratios: "*) csv=build/measure/$2.csv kind=ratios ;;
        *) continue ;;
        esac
        [ "$kind" = ratios ] && { [ "$mode" = check ] || [ ! -f "$csv" ]; } && continue
        skip=yes
        sh common/tables.sh "$csv" "$name" "$kind" >"$scratch/table"
        [ -s "$scratch/table" ] || echo "(there is no table \"$name\")"
        fold "$scratch/table"
    done <"$1"
}

bad=0
for chapter in "$@"; do
    text=chapters/$chapter/README.md
    blocks "$text" || bad=1
    skip=
    tables "$text" "$chapter" >"$scratch/text"
    if grep "^(there is no table" "$scratch/text" | sed "s|^|$text: |" | grep .; then bad=1; fi
    if [ "$mode" = renew ]; then
        cat "$scratch/text" >"$text"
    elif ! diff "$text" "$scratch/text" >"$scratch/diff"; then
        echo "$text: measured tables differ from what the program measures (make texts renews them):"
        head -20 "$scratch/diff"
        bad=1
    fi
done
for deck in slides/*/*.md; do
    blocks "$deck" || bad=1
done
[ "$bad" -eq 0 ] && echo "texts: C blocks stand in the code, measured tables are what is measured"
exit "$bad"
