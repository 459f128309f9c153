#!/bin/sh
# Where the time goes on an SPD scene's integral image: perf's flat profile.
#   tests/bench/profile.sh [balls|gears] [WIDTHxHEIGHT] [further options of lentray]
set -eu
root=$(cd "$(dirname "$0")/../.." && pwd)
scene=${1:-balls}
size=${2:-1995x2000}
[ $# -eq 0 ] || shift
[ $# -eq 0 ] || shift
command -v perf >/dev/null || { echo "profile.sh needs perf (Debian: linux-perf)" >&2; exit 1; }
program=$root/build/dev/bin/lentray
[ -x "$program" ] || { echo "build first: cmake --preset dev && cmake --build --preset dev" >&2; exit 1; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
perf record -q -e cpu-clock -F 1000 -o "$folder/perf.data" "$program" \
  "$root/scenes/spd_$scene.pov" Declare=Lenticular_Camera=1 "+W${size%x*}" "+H${size#*x}" +WT1 -V \
  -GA "+O$folder/out.png" "$@"
perf report -i "$folder/perf.data" --no-children --percent-limit 0.5 2>/dev/null |
  grep -v '^#' | grep -v '^$'
