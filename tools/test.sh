#!/bin/sh
# Setup, build, tests (all but those labelled slow).
#   tools/test.sh [PRESET] [further arguments for ctest]      PRESET: release (default), dev, ...
set -eu
cd "$(dirname "$0")/.."

preset=release
if [ $# -gt 0 ]; then
  preset=$1
  shift
fi

tools/setup.sh
cmake --preset "$preset"
cmake --build --preset "$preset"
# Twice as many at a time as there are processors: stock POV-Ray mostly waits.
ctest --test-dir "build/$preset" --output-on-failure -j "$((2 * $(nproc)))" -LE slow "$@"
