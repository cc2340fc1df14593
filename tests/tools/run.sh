#!/bin/sh
# run.sh PROGRAM...: runs the test programs of several chapters, one after
# another: a line per chapter, failures in full, and the sum as the last line.
# TAP=1 makes one TAP stream of all, JUNIT=file one XML file; T=text as in check.h.
# Exit status 1 when a test failed, was a todo, or a program did not run.
set -u

tmp=$(mktemp -d "${TMPDIR:-/tmp}/tests.XXXXXX") || exit 1
trap 'rm -rf "$tmp"' EXIT
trap 'exit 130' INT TERM

junit=${JUNIT:-} filter=${T:-} tap=${TAP:-} tally_file=${TALLY:-}
[ "$tap" = 0 ] && tap=
sum_passed=0 sum_failed=0 sum_todo=0 broken=0 unwritten=0

# Runs one program: its tally in passed, failed, todo; all 0 when it wrote none.
run_program() {
    name=$(basename "$1") passed=0 failed=0 todo=0 ran=yes
    rm -f "$tmp/tally"
    QUIET=1 TALLY=$tmp/tally JUNIT=${junit:+$tmp/$name.xml} "$1" >"$tmp/output" 2>&1
    if [ -s "$tmp/tally" ]; then
        read -r passed failed todo <"$tmp/tally"
    else
        ran=no broken=$((broken + 1))
    fi
    sum_passed=$((sum_passed + passed)) sum_failed=$((sum_failed + failed))
    sum_todo=$((sum_todo + todo))
}

tests_of_program() {
    echo $((passed + failed + todo))
}

print_text() {
    if [ $ran = no ]; then
        cat "$tmp/output"
        printf '%-22s  did not run\n' "$name"
        return
    fi
    [ "$(tests_of_program)" = 0 ] && [ -n "$filter" ] && return
    sed '$d' "$tmp/output" # all but its own closing line
    line="$passed passed"
    [ "$failed" -gt 0 ] && line="$line, $failed failed"
    [ "$todo" -gt 0 ] && line="$line, $todo todo"
    printf '%-22s  %s\n' "$name" "$line"
}

# One stream has one version line, one plan and numbers that go on.
print_tap() {
    if [ $ran = no ]; then
        sed 's/^/# /' "$tmp/output"
        number=$((number + 1))
        echo "not ok $number - $name did not run"
        return
    fi
    [ "$(tests_of_program)" = 0 ] && [ -n "$filter" ] && return
    echo "# $name"
    awk -v n="$number" '
        /^(TAP version|1\.\.)/ || /^# [0-9]+ passed, [0-9]+ failed/ { next }
        /^(not )?ok [0-9]+ - / { sub(/ok [0-9]+/, "ok " ++n) }
        { print }' "$tmp/output"
    number=$((number + $(tests_of_program)))
}

add_junit() {
    if [ -s "$tmp/$name.xml" ]; then
        sed 1d "$tmp/$name.xml"
    else
        printf '<testsuite name="%s" tests="1" failures="0" errors="1" skipped="0">\n' "$name"
        printf '  <testcase classname="%s" name="%s">' "$name" "$name"
        printf '<error message="did not run"/></testcase>\n</testsuite>\n'
    fi >>"$tmp/suites"
}

# Beside the file and renamed, so that it is whole or not there.
write_junit() {
    {
        echo '<?xml version="1.0" encoding="UTF-8"?>'
        echo '<testsuites>'
        cat "$tmp/suites"
        echo '</testsuites>'
    } 2>/dev/null >"$junit.$$" && mv "$junit.$$" "$junit" && return
    rm -f "$junit.$$"
    echo "error: cannot write $junit" >&2
    unwritten=1
}

number=0
: >"$tmp/suites"
[ -n "$tap" ] && echo 'TAP version 13'
for program in "$@"; do
    run_program "$program"
    if [ -n "$tap" ]; then print_tap; else print_text; fi
    [ -n "$junit" ] && add_junit
done
[ -n "$junit" ] && write_junit
[ -n "$tally_file" ] && echo "$sum_passed $sum_failed $sum_todo" >>"$tally_file"

sum=$((sum_passed + sum_failed + sum_todo))
[ $sum = 0 ] && [ -n "$filter" ] && echo "no test's name contains \"$filter\"" >&2
line="$sum_passed passed, $((sum_failed + broken)) failed"
[ $sum_todo -gt 0 ] && line="$line, $sum_todo todo"
if [ -n "$tap" ]; then printf '1..%d\n# %s\n' "$number" "$line"; else echo "$line"; fi
[ $sum -gt 0 ] && [ $((sum_failed + sum_todo + broken + unwritten)) = 0 ]
