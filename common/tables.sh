#!/bin/sh
# tables.sh: the tables of a chapter's measurements, from the CSV that measure.c prints.
#
#   tables.sh CSV                                 the names of its tables, one a line
#   tables.sh CSV NAME errors|ratios [FORMAT]     one table; FORMAT markdown, text or html
#   tables.sh CSV NAME costs [FORMAT]             ratios with the cost itself behind
#   tables.sh CSV NAME rows                       tabs: variant real x error x_name error_name
#
# One row a variant, one column a value of x. A ratio is the cost divided by the
# cost of the table's first variant in the same real and at the same x. Nothing
# is printed when no cell has a value.
set -eu
LC_ALL=C # bytes, and a decimal point
export LC_ALL

usage() {
    sed -n 's/^# \{0,1\}//; 2,8p' "$0" >&2
    exit 2
}

[ $# -ge 1 ] && [ $# -le 4 ] || usage
csv=$1 name=${2-} mode=${3-names} format=${4-markdown}
[ $# -ne 2 ] || usage
case $mode in names | errors | ratios | costs | rows) ;; *) usage ;; esac
case $format in markdown | text | html) ;; *) usage ;; esac
[ -r "$csv" ] || { echo "error: cannot read $csv" >&2; exit 1; }

# The name through the environment: awk would read escapes in a -v.
TABLE=$name awk -v OFS='\t' -v mode="$mode" -v format="$format" -v csv="$csv" '
# The fields of a CSV line into field[1..]; a quoted field may hold commas and "".
function split_csv(line,    n, c, i, quoted) {
    n = 1
    field[1] = ""
    for (i = 1; i <= length(line); i++) {
        c = substr(line, i, 1)
        if (c == "\"" && quoted && substr(line, i + 1, 1) == "\"") {
            field[n] = field[n] c
            i++
        } else if (c == "\"") quoted = !quoted
        else if (c == "," && !quoted) field[++n] = ""
        else field[n] = field[n] c
    }
    return n
}

function width(text) { # characters of UTF-8: the bytes that begin one
    gsub(/[\200-\277]/, "", text)
    return length(text)
}

function pad(text, to, right,    i, blanks) {
    for (i = width(text); i < to; i++) blanks = blanks " "
    return right ? blanks text : text blanks
}

function short(x) { return x == "" || x ~ /inf/ ? x : sprintf("%.4g", x) }

function escape(text) { # what would end a cell or begin a tag
    if (format == "markdown") gsub(/\|/, "\\|", text)
    if (format != "html") return text
    gsub(/&/, "\\&amp;", text)
    gsub(/</, "\\&lt;", text)
    gsub(/>/, "\\&gt;", text)
    return text
}

function error_cell(e) {
    if (e == "" || e ~ /inf/) return e
    if (error_name ~ / per (ray|line|triangle)$/) return short(e) # a count
    return e + 0 == 0 ? "0" : sprintf("%.1e", e)
}

# A cost of 0 was not measured (ERRORS_ONLY).
function cost_cell(v, real, x,    c, first, ratio) {
    c = cost[v, real, x]
    first = cost[variants[1], real, x]
    if (c + 0 == 0) return ""
    if (first + 0 > 0) ratio = sprintf("%.2f", c / first)
    if (mode == "ratios") return ratio
    return (ratio == "" ? "" : ratio " ") "(" sprintf("%.3g", c) ")"
}

function sort_numbers(a, n,    i, j, t) { # insertion: the columns are few
    for (i = 2; i <= n; i++)
        for (j = i; j > 1 && a[j] + 0 < a[j - 1] + 0; j--) {
            t = a[j]
            a[j] = a[j - 1]
            a[j - 1] = t
        }
}

# cell[0, *] is the head, cell[*, 0] the variant; fills rows and columns.
function fill(    v, r, c, value) {
    if (mode == "errors") cell[0, 0] = error_name
    else cell[0, 0] = mode == "costs" ? "ratio (" cost_name ")" : cost_name ", ratio"
    for (c = 1; c <= xs; c++) cell[0, c] = short(x_of[c])
    if (x_name != "") cell[0, 1] = x_name " = " cell[0, 1]
    for (r = 1; r <= reals; r++)
        for (v = 1; v <= variant_count; v++) {
            if (!((variants[v], real_of[r]) in known)) continue
            cell[++rows, 0] = variants[v] (real_of[r] == "float" ? "" : ", " real_of[r])
            for (c = 1; c <= xs; c++) {
                if (mode == "errors") value = error_cell(error[variants[v], real_of[r], x_of[c]])
                else value = cost_cell(variants[v], real_of[r], x_of[c])
                cell[rows, c] = value
                if (value != "") any = 1
            }
        }
}

function print_cells(begin, between, end, r,    c, line) {
    line = begin
    for (c = 0; c <= xs; c++) {
        if (c) line = line between
        line = line pad(cell[r, c], format == "html" ? 0 : wide[c], c > 0)
    }
    sub(/ +$/, "", line)
    print line end
}

function print_table(    r, c, nothing) {
    nothing = format == "text" ? "-" : "\342\200\223" # en dash
    for (r = 0; r <= rows; r++)
        for (c = 0; c <= xs; c++) {
            if (r && c && cell[r, c] == "") cell[r, c] = nothing
            cell[r, c] = escape(cell[r, c])
            if (width(cell[r, c]) > wide[c]) wide[c] = width(cell[r, c])
        }
    if (format == "html") print "<table>"
    for (r = 0; r <= rows; r++) {
        if (format == "text") print_cells("  ", "  ", "", r)
        else if (format == "markdown") print_cells("| ", " | ", " |", r)
        else if (r == 0) print_cells("<tr><th>", "</th><th>", "</th></tr>", r)
        else print_cells("<tr><td>", "</td><td>", "</td></tr>", r)
        if (format == "markdown" && r == 0) print_rule()
    }
    if (format == "html") print "</table>"
}

function print_rule(    c, line) {
    line = "|---|"
    for (c = 1; c <= xs; c++) line = line "---:|"
    print line
}

{
    sub(/\r$/, "")
    if ($0 == "" || split_csv($0) < 9 || (field[1] == "table" && field[2] == "variant")) next
    if (mode == "names") { if (!(field[1] in seen)) print field[1]; seen[field[1]] = 1; next }
    if (field[1] != ENVIRON["TABLE"]) next
    found = 1
    if (mode == "rows") {
        print field[2], field[3], field[5], field[7], field[4], field[6]
        next
    }
    if (!(field[2] in is_variant)) variants[++variant_count] = field[2]
    if (!(field[3] in is_real)) real_of[++reals] = field[3]
    if (!(field[5] in is_x)) x_of[++xs] = field[5]
    is_variant[field[2]] = is_real[field[3]] = is_x[field[5]] = known[field[2], field[3]] = 1
    error[field[2], field[3], field[5]] = field[7]
    cost[field[2], field[3], field[5]] = field[9]
    if (x_name == "") x_name = field[4]
    if (error_name == "") error_name = field[6]
    if (cost_name == "") cost_name = field[8]
}

END {
    if (mode == "names" || (mode == "rows" && found)) exit
    if (!found) {
        print "error: no table \"" ENVIRON["TABLE"] "\" in " csv | "cat 1>&2"
        exit 1
    }
    sort_numbers(x_of, xs)
    fill()
    if (any) print_table()
}
' "$csv"
