#!/bin/sh
# Fuzzes the scene reader under the address and undefined-behaviour sanitizers, on one core.
#   tests/fuzz/fuzz.sh [SECONDS] [further options of libFuzzer]     600 s unless told
# Builds preset fuzz (clang), makes the seeds, and goes on with the corpus of earlier runs. An
# input that crashes, leaks or takes too long stops the run and is left in build/fuzz/found; what
# it shows, cut short, belongs into tests/fuzz/inputs once it is mended.
set -eu
root=$(cd "$(dirname "$0")/../.." && pwd)
seconds=${1:-600}
[ $# -eq 0 ] || shift
cd "$root"
cmake --preset fuzz >/dev/null
nice cmake --build --preset fuzz --target fuzz_scene
work=$root/build/fuzz
mkdir -p "$work/corpus" "$work/found"
python3 tests/fuzz/seeds.py "$work/seeds"
export ASAN_OPTIONS=detect_stack_use_after_return=0:allocator_may_return_null=0
export UBSAN_OPTIONS=print_stacktrace=1
exec nice -n 10 "$work/bin/fuzz_scene" "$work/corpus" "$work/seeds" \
  -max_total_time="$seconds" -timeout=20 -rss_limit_mb=3000 -max_len=16000 -len_control=0 \
  -artifact_prefix="$work/found/" -print_final_stats=1 "$@"
