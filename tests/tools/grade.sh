#!/bin/sh
# grade.sh SUBMISSIONS OUT CHECK COURSE CC FLAGS...: judges the homework of every folder in
# SUBMISSIONS: its .c files, or those in its homework/ or exercises/homework/. A table on stdout;
# in OUT a folder for each with report.txt and the pictures, and junit.xml of all. Exit status 0
# when all were judged, whatever the verdicts.
submissions=$1 out=$2
shift 2
if [ -z "$submissions" ] || [ ! -d "$submissions" ]; then
    echo "make grade SUBMISSIONS=dir: a folder with one folder for each submission; \"$submissions\" is none" >&2
    exit 2
fi
rm -rf "$out"
mkdir -p "$out" || exit 1
unset T TALLY

folder_of() { # where the .c files of a submission are
    for folder in "$1" "$1/homework" "$1/exercises/homework"; do
        ls "$folder"/*.c >/dev/null 2>&1 && echo "$folder" && return
    done
    echo "$1"
}

printf '%-24s %-6s %-6s %-6s %-6s %-6s\n' submission build depth normal mirror path
count=0
for submission in "$submissions"/*/; do
    [ -d "$submission" ] || continue
    submission=${submission%/}
    name=$(basename "$submission" | tr -c 'A-Za-z0-9._\n-' _)
    [ -e "$out/$name" ] && name=$name-$count
    count=$((count + 1))
    mkdir -p "$out/$name"
    # Into another file first: homework.sh clears the .txt files of its folder.
    QUIET=1 TAP=1 JUNIT=$out/$name/result.xml sh tests/tools/homework.sh "$(folder_of "$submission")" \
        "$out/$name" "$@" >"$out/$name.tap" 2>&1
    cat "$out/$name/report.txt" >>"$out/$name.tap" 2>/dev/null
    mv "$out/$name.tap" "$out/$name/report.txt"
    awk -v name="$name" '
        /^path: ok, but weak/ { sub(/ok *$/, "weak", s) }
        /^ok [0-9]/ { s = s " " sprintf("%-6s", "ok") }
        /^not ok [0-9].* # TODO/ { s = s " " sprintf("%-6s", "todo"); next }
        /^not ok [0-9]/ { s = s " " sprintf("%-6s", "FAIL") }
        END { printf "%-24s%s\n", name, s == "" ? " not judged: see its report.txt" : s }' "$out/$name/report.txt"
done
{
    echo '<?xml version="1.0" encoding="UTF-8"?>'
    echo '<testsuites>'
    for result in "$out"/*/result.xml; do
        [ -f "$result" ] || continue
        name=$(basename "$(dirname "$result")")
        sed -e 1d -e "s/<testsuite name=\"homework\"/<testsuite name=\"$name\"/" \
            -e "s/classname=\"homework\"/classname=\"$name\"/" "$result"
    done
    echo '</testsuites>'
} >"$out/junit.xml" || exit 1
echo "$count submissions; reports and pictures: $out/*/, JUnit: $out/junit.xml"
