#!/bin/sh
# staircase.sh: a chapter includes common/ and earlier chapters, never later ones;
# common/ includes no chapter; nothing includes solutions/ or exercises/, but the homework's solution
# its own files, and the wrong ray tracers those too.
find common chapters exercises solutions tests slides/figures -name '*.[ch]' | sort | xargs awk '
function fail(why) {
    printf "%s:%d: %s: %s\n", FILENAME, FNR, why, $0
    bad = 1
}
FNR == 1 {
    files++
    own = match(FILENAME, /[0-9][0-9]-/) ? substr(FILENAME, RSTART, 2) + 0 : -1
}
/^[ \t]*#[ \t]*include[ \t]*"/ {
    split($0, part, "\"")
    path = part[2]
    if (path ~ /^solutions\/homework\// && FILENAME ~ /^(solutions|tests)\/homework\//) next
    if (path ~ /^slides\// && FILENAME ~ /^slides\//) next
    if (path !~ /^(common|chapters|tests)\//) fail("includes are named from the root: common/, chapters/ or tests/")
    if (path ~ /^tests\// && FILENAME !~ /^tests\//) fail("only tests include the test runner")
    if (path !~ /^chapters\//) next
    number = substr(path, 10, 2) + 0
    if (FILENAME ~ /^common\//) fail("common/ knows no chapter")
    else if (own >= 0 && number > own) fail("climbs the staircase")
}
END {
    if (bad) exit 1
    printf "staircase: %d files, no include climbs up\n", files
}'
