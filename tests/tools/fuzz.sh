#!/bin/sh
# fuzz.sh SECONDS PROGRAM CC FLAG-OR-FILE...: builds tests/tools/fuzz_obj.c with libFuzzer and
# the sanitizers, and lets it look for a text that breaks the OBJ reader. What it has learnt
# stays in build/fuzz/corpus for the next run.
seconds=$1 program=$2 cc=$3
shift 3
fail() {
    echo "make fuzz: $*" >&2
    exit 1
}
case $seconds in
'' | *[!0-9]*) fail "SECONDS is a whole number, not \"$seconds\"" ;;
esac
mkdir -p build/fuzz/corpus "${program%/*}" || exit 1
command -v "$cc" >/dev/null ||
    fail "$cc is not installed, and libFuzzer is a part of clang (Debian: apt-get install clang)"
echo 'int LLVMFuzzerTestOneInput(const unsigned char *d, unsigned long n);
int LLVMFuzzerTestOneInput(const unsigned char *d, unsigned long n) { return d && n == 0; }' >build/fuzz/try.c
"$cc" -fsanitize=fuzzer,address,undefined -o build/fuzz/try build/fuzz/try.c 2>build/fuzz/try.log ||
    fail "$cc has no libFuzzer: Debian's is in libclang-rt-dev (for clang 14: libclang-rt-14-dev); FUZZ_CC=clang-14 names another clang. It said:
$(cat build/fuzz/try.log)"
"$cc" -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=all -g -O1 "$@" -lm -o "$program" || exit 1

log=build/fuzz/log
"$program" -max_total_time="$seconds" -max_len=4096 -timeout=120 -rss_limit_mb=1024 -verbosity=0 \
    -print_final_stats=1 -dict=tests/tools/fuzz_obj.dict -artifact_prefix=build/fuzz/find- \
    build/fuzz/corpus tests/12-bvh/obj >$log 2>&1 </dev/null
status=$?
if [ $status -ne 0 ]; then
    cat $log >&2
    find=$(sed -n 's/.*Test unit written to //p' $log)
    fail "a find${find:+: $find}. Mend it, and keep the text in tests/12-bvh/obj/"
fi
texts=$(sed -n 's/^stat::number_of_executed_units: *//p' $log)
echo "fuzz: ${texts:-0} texts in $seconds s, nothing found"
