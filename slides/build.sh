#!/bin/sh
# build.sh OUT: both decks as HTML and PDF in OUT. Needs npm's packages (npm ci) and chromium;
# LANGUAGES=en for one of them, CHROME_PATH for a browser elsewhere.
out=$1
here=$(dirname "$0")
export CHROME_PATH="${CHROME_PATH:-$(command -v chromium || command -v google-chrome)}"
fail() {
    echo "slides: $1" >&2
    exit 1
}
for language in ${LANGUAGES:-en sv}; do
    deck=$out/$language.md
    {
        printf -- '---\nmarp: true\ntheme: course\nmath: mathjax\npaginate: true\nsize: 16:9\nlang: %s\n---\n\n' "$language"
        first=1
        for chapter in "$here/$language"/*.md; do
            [ "$first" ] || printf '\n---\n\n'
            first=
            sed "s|(\.\./\.\./build/slides/figures/|(figures/|; s|(\.\./\.\./chapters/|(../../chapters/|" "$chapter"
        done
    } >"$deck" || fail "$deck cannot be written"
    for kind in html pdf; do
        "$here/node_modules/.bin/marp" --no-stdin --allow-local-files --theme-set "$here/theme.css" \
            -o "$out/$language.$kind" "$deck" >"$out/marp.log" 2>&1 || fail "marp failed: $(tail -3 "$out/marp.log")"
    done
done
