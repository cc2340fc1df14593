#!/bin/sh
# plot.sh CSV OUTDIR: shows what a chapter's measure.c printed into CSV.
#
# Every table is printed: the errors, then the costs. With gnuplot each is drawn
# too, error against x, as OUTDIR/<csv>-<table>.svg and .png; and OUTDIR/index.html
# is written anew: one page with the plots and tables of all CSV files in OUTDIR.
set -eu
LC_ALL=C
export LC_ALL

[ $# -eq 2 ] || { echo "usage: plot.sh CSV OUTDIR" >&2; exit 2; }
csv=$1 out=$2
here=$(dirname "$0")
mkdir -p "$out"
work=$(mktemp -d "${TMPDIR:-/tmp}/plot.XXXXXX")
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM

tables() {
    sh "$here/tables.sh" "$@"
}

# The file name of a plot without extension: plot_name CSV TABLE
plot_name() {
    printf '%s-%s' "$(basename "$1" .csv)" "$2" | tr 'A-Z' 'a-z' | tr -cs 'a-z0-9-' '-' |
        sed 's/-*$//'
}

# One block a curve, as gnuplot wants it: its title in quotes, then "x error".
# What has no logarithm is put a decade beyond the rest: zero below, infinity
# above; an error with a sign by its size. The first three lines are comments: what to add to the plot's title,
# which axes are logarithmic, the range of y. Nothing with fewer than two x.
curves() {
    awk -F '\t' '
    $4 == "" || $3 == "" { next }
    {
        key = $1 ($2 == "float" ? "" : ", " $2)
        if (!(key in size)) order[++keys] = key
        if (sub(/^-/, "", $4)) signed = 1
        if (!($3 in is_x)) xs++
        is_x[$3] = 1
        x[key, ++size[key]] = $3
        y[key, size[key]] = $4
        if ($3 + 0 <= 0) linear = 1
        if ($4 ~ /inf/) infinite = 1
        else if ($4 + 0 == 0) zero = 1
        else {
            if (low == "" || $4 + 0 < low) low = $4 + 0
            if ($4 + 0 > high) high = $4 + 0
        }
    }
    function decade(value) { # the power of ten at or below value
        value = sprintf("%.0e", value)
        sub(/^[0-9]/, "1", value)
        return value
    }
    END {
        if (xs < 2 || low == "") exit # a table says it better
        floor_at = decade(low / 10)
        ceiling = decade(high * 100)
        note = (signed ? ", without sign" : "") (zero ? ", zero drawn at " floor_at : "")
        print "#" note (infinite ? ", infinite drawn at " ceiling : "")
        print "#" (linear ? "y" : "xy")
        print "#[" floor_at ":" ceiling "]"
        for (k = 1; k <= keys; k++) {
            title = order[k]
            gsub(/"/, "\047", title)
            printf "\"%s\"\n", title
            for (i = 1; i <= size[order[k]]; i++) {
                value = y[order[k], i]
                if (value ~ /inf/) value = ceiling
                else if (value + 0 == 0) value = floor_at
                print x[order[k], i], value
            }
            printf "\n\n"
        }
    }'
}

quote() { # for gnuplot: in single quotes, a quote doubled
    printf "'%s'" "$(printf '%s' "$1" | sed "s/'/''/g")"
}

# draw CSV TABLE: nothing when there are no curves.
draw() {
    tables "$1" "$2" rows > "$work/rows"
    curves < "$work/rows" > "$work/data"
    [ -s "$work/data" ] || return 0
    note=$(sed -n '1s/^#//p' "$work/data")
    logs=$(sed -n '2s/^#//p' "$work/data")
    range=$(sed -n '3s/^#//p' "$work/data")
    file=$(plot_name "$1" "$2")
    {
        echo "set encoding utf8"
        echo "set logscale $logs"
        echo "set format $logs '10^{%T}'"
        echo "set yrange $range"
        echo "set key outside right noenhanced"
        echo "set grid"
        echo "set title $(quote "$2$note") noenhanced"
        echo "set xlabel $(quote "$(head -n 1 "$work/rows" | cut -f 5)") noenhanced"
        echo "set ylabel $(quote "$(head -n 1 "$work/rows" | cut -f 6)") noenhanced"
        for kind in 'svg:svg size 900,500 background rgb "white"' 'png:pngcairo size 900,500'; do
            echo "set terminal ${kind#*:}"
            echo "set output $(quote "$out/$file.${kind%%:*}")"
            echo "plot for [i=0:$(grep -c '^"' "$work/data")-1] $(quote "$work/data") index i" \
                "using 1:2 with linespoints title columnheader(1)"
        done
    } > "$work/plot"
    LC_ALL=C.UTF-8 gnuplot "$work/plot" # in the plain C locale it warns of its degree sign
}

show() {
    tables "$csv" | while IFS= read -r table; do
        printf '\n%s\n' "$table"
        tables "$csv" "$table" errors text
        tables "$csv" "$table" costs text
        if command -v gnuplot > /dev/null; then draw "$csv" "$table"; fi
    done
}

escape() {
    printf '%s' "$1" | sed 's/&/\&amp;/g; s/</\&lt;/g; s/>/\&gt;/g'
}

page() {
    cat << 'END'
<!doctype html>
<meta charset="utf-8">
<title>The trade</title>
<style>
body { font: 16px/1.4 sans-serif; max-width: 70em; margin: 2em auto; padding: 0 1em }
table { border-collapse: collapse; margin: 1em 0; font-size: 14px }
td, th { padding: .2em .6em; text-align: right; border-bottom: 1px solid #ccc }
td:first-child, th:first-child { text-align: left }
img { max-width: 100% }
</style>
<h1>The trade: error and cost</h1>
END
    for each in "$out"/*.csv; do
        [ -f "$each" ] || continue
        echo "<h2>$(escape "$(basename "$each" .csv)")</h2>"
        tables "$each" | while IFS= read -r table; do
            echo "<h3>$(escape "$table")</h3>"
            picture=$(plot_name "$each" "$table").svg
            [ ! -f "$out/$picture" ] ||
                echo "<p><img src=\"$picture\" alt=\"error against x\"></p>"
            tables "$each" "$table" errors html
            tables "$each" "$table" costs html
        done
    done
}

show
page > "$work/index.html"
mv "$work/index.html" "$out/index.html"
