#!/bin/sh
# pictures.sh check|renew B TEXT...: every picture in a text, ![what](file.png),
# is what the command in backticks on the line below it makes. check draws it
# again and compares, pixel by pixel; renew draws it in place. At most 200 KB.
mode=$1 build=$2
shift 2
scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT

commands() { # text: lines "picture command"
    awk '
    /^!\[/ { match($0, /\]\([^)]*\)/); picture = substr($0, RSTART + 2, RLENGTH - 3); next }
    picture != "" && /^`build\// { gsub(/`/, ""); print picture, $0; picture = ""; next }
    picture != "" && !/^$/ { print picture, "none"; picture = "" }
    END { if (picture != "") print picture, "none" }' "$1"
}

one() { # text picture command: draws it, prints what is wrong
    file=${1%/*}/$2
    [ "$1" = README.md ] && file=$2
    case $3 in
    build/*" --size "*" --out $file") ;;
    *) echo "$1: $2 wants the command below it, with --size and --out $file, got: $3" && return ;;
    esac
    drawn=$scratch/drawn.png
    [ "$mode" = renew ] && drawn=$file
    # shellcheck disable=SC2086 # the command is words
    set -- "$1" "$2" $build/${3#build/}
    text=$1
    shift 2
    arguments=
    for word in "$@"; do [ "$word" = "$file" ] || arguments="$arguments $word"; done
    # shellcheck disable=SC2086
    $arguments "$drawn" >"$scratch/log" 2>&1 || { echo "$text: $* fails:" && cat "$scratch/log" && return; }
    [ "$mode" = renew ] || "$build/same_picture" "$file" "$drawn"
    [ "$(wc -c <"$file")" -le 204800 ] || echo "$file is larger than 200 KB"
}

for text in "$@"; do
    commands "$text" >"$scratch/list"
    [ -s "$scratch/list" ] || echo "$text has no picture" >>"$scratch/complaints"
    while read -r picture command; do
        one "$text" "$picture" "$command" </dev/null
        echo x >>"$scratch/count"
    done <"$scratch/list" >>"$scratch/complaints" 2>&1
    for file in "${text%/*}"/*.png; do
        [ "$text" = README.md ] && continue
        [ -f "$file" ] && ! grep -q "^${file##*/} " "$scratch/list" &&
            echo "$file is in no text" >>"$scratch/complaints"
    done
done
if [ -s "$scratch/complaints" ]; then
    cat "$scratch/complaints"
    exit 1
fi
echo "pictures: $(wc -l <"$scratch/count" | tr -d ' ') pictures are what their commands draw"
