# stb.sh: prints the compiler's flags for <stb_image_write.h>: from pkg-config,
# else from the usual folders. Nothing when there is none: setup.sh then says so.
# -isystem, so that the library's warnings are not ours.
if flags=$(pkg-config --cflags stb 2>/dev/null) && [ -n "$flags" ]; then
    echo "$flags" | sed 's/-I */-isystem /g'
    exit 0
fi
for folder in /usr/include/stb /usr/local/include/stb /usr/include /usr/local/include \
    /opt/homebrew/include/stb /opt/homebrew/include /opt/local/include/stb \
    /opt/local/include /mingw64/include/stb /ucrt64/include/stb; do
    if [ -f "$folder/stb_image_write.h" ]; then
        echo "-isystem $folder"
        exit 0
    fi
done
