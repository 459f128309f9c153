#!/bin/sh
# Setup, build, tests.
#   tools/test.sh [PRESET] [further arguments for ctest]    all tests but those labelled slow
#                                                           PRESET: release (default), dev, ...
#   tools/test.sh --all                                     everything, in hours: slow tests,
#                                                           sanitizers, aarch64 by qemu, format and
#                                           tidy; one table
set -eu
cd "$(dirname "$0")/.."

build() {
  cmake --preset "$1" && cmake --build --preset "$1"
}
# Four times as many at a time as there are processors: stock POV-Ray mostly waits.
run_tests() {
  preset=$1
  shift
  ctest --test-dir "build/$preset" --output-on-failure -j "$((4 * $(nproc)))" "$@"
}
build_and_test() {
  build "$1" && run_tests "$@"
}
# Slow tests time things or use all processors: one after the other.
run_slow_tests() {
  ctest --test-dir build/release --output-on-failure -j 1 -L slow
}
check_format() {
  git ls-files '*.h' '*.cpp' | xargs clang-format --dry-run -Werror
}

# step NAME COMMAND...: a row of the table; what the command says is in build/all/NAME.log.
step() {
  name=$1
  shift
  printf '%s ...\n' "$name"
  began=$(date +%s)
  if "$@" >"build/all/$name.log" 2>&1; then verdict=passed; else verdict=FAILED; fi
  seconds=$(($(date +%s) - began))
  summary=$(grep -E '^[0-9]+% tests passed|^\[  (PASSED|FAILED)  \] [0-9]+ test' "build/all/$name.log" | head -1 || true)
  printf '| %-12s | %-7s | %6d s | %s\n' "$name" "$verdict" "$seconds" "$summary" >>build/all/table
}
run_all() {
  mkdir -p build/all
  : >build/all/table
  step release build_and_test release -LE slow
  step slow run_slow_tests
  step asan-ubsan build_and_test asan-ubsan -L unit
  step tsan build_and_test tsan -L unit
  step aarch64 tools/aarch64.sh
  step format check_format
  step tidy build tidy
  cat build/all/table
  ! grep -q FAILED build/all/table
}

if [ "${1:-}" = --all ]; then
  tools/setup.sh --all
  run_all
  exit
fi
preset=release
if [ $# -gt 0 ]; then
  preset=$1
  shift
fi
tools/setup.sh --tests
build "$preset"
run_tests "$preset" -LE slow "$@"
