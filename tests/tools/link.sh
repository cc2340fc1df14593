#!/bin/sh
# link.sh COMMAND...: links a program with a student's answers. A function that is
# nowhere defined is told in one line, not in a linker's many.
out=$("$@" 2>&1) && exit 0
names=$(printf '%s\n' "$out" | sed -n -e "s/.*undefined reference to [\`']\([A-Za-z_0-9]*\)'.*/\1/p" \
    -e 's/.*undefined symbol: \([A-Za-z_0-9]*\).*/\1/p' -e 's/^ *"_\([A-Za-z_0-9]*\)", referenced from.*/\1/p' | sort -u)
if [ -z "$names" ]; then
    printf '%s\n' "$out" >&2
    exit 1
fi
for name in $names; do
    file=$(find exercises -name "$name.c" | head -1)
    echo "error: $name is not defined${file:+: is its name in $file misspelt, is it static, or is the file empty?}" >&2
done
exit 1
