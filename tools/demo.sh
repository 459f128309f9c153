#!/bin/sh
# On a bare Debian 12: installs what is needed, builds, renders two scenes as integral images and
# holds both against stock POV-Ray, lens by lens. The pictures land in out/.
set -eu
cd "$(dirname "$0")/.."

tools/setup.sh
cmake --preset release
cmake --build --preset release --target lentray lentray-diff
bin=build/release/bin
mkdir -p out

# scene name, scene file, further options
show() {
  name=$1
  scene=$2
  shift 2
  echo
  echo "== $name =="
  "$bin/lentray" "$scene" "+Oout/$name.png" -V Lenticular=On "$@"
  "$bin/lentray" "$scene" "+Oout/$name-view7.png" -V Lenticular=On View=7 "$@" >/dev/null 2>&1
  "$bin/lentray-diff" "$scene" Lenticular=On "$@" --output "out/$name" --json "out/$name.json" \
    --grade match
  echo "integral image: out/$name.png; its middle view: out/$name-view7.png"
}

show demo scenes/demo.pov +W1200 +H900
show sombrero /usr/share/doc/povray/examples/advanced/sombrero.pov +W960 +H720

echo
echo "Done. Show the integral images at their printed size behind a sheet of 22.6 lenses an inch,"
echo "or look at out/*-side.png: lentray | stock POV-Ray | difference x 8."
