#!/bin/sh
# Fuzzes what reads files under the address and undefined-behaviour sanitizers, on one core.
#   tests/fuzz/fuzz.sh scene|picture|data [SECONDS] [further options of libFuzzer]     600 s unless told
# scene: the parser; picture: image files; data: fonts and density files. Memory is limited to 1 GiB as with
# Max_Memory; more than 2 GiB at a time, 3 GiB with what the sanitizers keep, or 10 s for an input, is a fault.
# Builds preset fuzz (clang), makes the seeds, and goes on with the corpus of earlier runs. An
# input that crashes, leaks or takes too long stops the run and is left in build/fuzz/found; what
# it shows, cut short, belongs into tests/fuzz/inputs once it is mended.
set -eu
root=$(cd "$(dirname "$0")/../.." && pwd)
what=${1:?scene, picture or data}
seconds=${2:-600}
shift; [ $# -eq 0 ] || shift
cd "$root"
cmake --preset fuzz >/dev/null
nice cmake --build --preset fuzz --target "fuzz_$what"
work=$root/build/fuzz
mkdir -p "$work/corpus-$what" "$work/found"
python3 tests/fuzz/seeds.py "$what" "$work/seeds-$what"
export ASAN_OPTIONS=detect_stack_use_after_return=0:allocator_may_return_null=0:quarantine_size_mb=64:allocator_release_to_os_interval_ms=500
export UBSAN_OPTIONS=print_stacktrace=1
exec nice -n 10 "$work/bin/fuzz_$what" "$work/corpus-$what" "$work/seeds-$what" \
  -max_total_time="$seconds" -timeout=10 -rss_limit_mb=3072 -malloc_limit_mb=2048 -max_len=40000 -len_control=0 \
  -artifact_prefix="$work/found/$what-" -print_final_stats=1 "$@"
