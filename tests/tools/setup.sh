#!/bin/sh
# setup.sh CC STB_CFLAGS: is everything there that the course needs? Silent when
# it is; otherwise one message with the line that installs it on this system.
set -u

cc=${1:-cc} stb_cflags=${2:-}

tmp=$(mktemp -d "${TMPDIR:-/tmp}/setup.XXXXXX") || exit 1
trap 'rm -rf "$tmp"' EXIT
trap 'exit 130' INT TERM

has() {
    command -v "$1" >/dev/null 2>&1
}

# The compiler and its flags are several words: no quotes.
compiles() { # FLAGS; the program on stdin
    cat >"$tmp/try.c"
    # shellcheck disable=SC2086
    $cc -std=c11 $1 "$tmp/try.c" -o "$tmp/try" -lm >"$tmp/errors" 2>&1
}

by_hand='put stb_image_write.h, a single file of the stb library, in a folder
    and call: make STB_CFLAGS=-Ifolder'

install_line() {
    if [ "$(uname -s)" = Darwin ]; then
        if has port; then
            echo 'xcode-select --install; sudo port install stb'
        else
            printf 'xcode-select --install\n    Homebrew has no stb: %s\n' "$by_hand"
        fi
    elif [ -n "${MSYSTEM:-}" ]; then
        echo 'pacman -S gcc make pkgconf mingw-w64-x86_64-stb'
    elif has apt-get; then
        echo 'sudo apt-get install gcc libc6-dev make libstb-dev pkg-config'
    elif has dnf; then
        echo 'sudo dnf install gcc make stb-devel pkgconf'
    elif has pacman; then
        echo 'sudo pacman -S gcc make stb pkgconf'
    elif has brew; then
        printf 'brew install gcc make pkgconf\n    Homebrew has no stb: %s\n' "$by_hand"
    else
        printf 'a C11 compiler, make, and stb:\n    %s\n' "$by_hand"
    fi
}

missing() {
    printf '%s\nInstall what is needed:\n    %s\n' "$1" "$(install_line)" >&2
    exit 1
}

echo 'int main(void) { return 0; }' | compiles '' ||
    missing "The C compiler \"$cc\" does not work: $(sed -n 1p "$tmp/errors")"

printf '#include <stb_image_write.h>\nint main(void) { return 0; }\n' | compiles "$stb_cflags" ||
    missing "The header <stb_image_write.h> is not found (STB_CFLAGS=\"$stb_cflags\")."
