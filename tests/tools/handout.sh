#!/bin/sh
# handout.sh OUT: a clean copy of the course for students: no solutions, no answers among the
# tests, nothing of what only those who work on the course need. There, all programs are built
# from the student's own exercises.
out=$1
rm -rf "$out"
mkdir -p "$out" || exit 1
files() {
    git ls-files 2>/dev/null | grep . || find . -type f ! -path './build/*' ! -path './.git/*' | sed 's|^\./||'
}
files | while IFS= read -r file; do
    case $file in
    solutions/* | tests/*/wrong/* | tests/*/right/* | .ci/* | .github/* | CONTRIBUTING.md) continue ;;
    esac
    [ -f "$file" ] || continue
    mkdir -p "$out/$(dirname "$file")" && cp -p "$file" "$out/$file" || exit 1
done || exit 1
# What the front page says of the solutions is otherwise here.
awk '/^Read a chapter/ {
        print "Read a chapter'"'"'s `README.md`, write your answers into the files of `exercises/`, test, look at the"
        print "picture. There are no solutions here: every chapter builds on what you have written in those before."
        skip = 1
    }
    /^To work on the course itself/ { sub(/^To work on the course itself, read \[CONTRIBUTING.md\]\(CONTRIBUTING.md\)\. /, "") }
    /^$/ { skip = 0 }
    !skip { print }' README.md >"$out/README.md"
echo "The handout: $out, $(find "$out" -type f | wc -l | tr -d ' ') files"
