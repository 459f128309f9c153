#!/bin/sh
# On a bare Debian 12: installs what rendering needs, builds, and renders a scene as an integral image and as a page
# to tilt it in a browser. Where POV-Ray is installed it also holds that picture, and one of POV-Ray's own example
# scenes, against stock, lens by lens. The pictures land in out/.
set -eu
cd "$(dirname "$0")/.."

tools/setup.sh
cmake --preset release
cmake --build --preset release --target lentray lentray-views lentray-diff
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
  "$bin/lentray-views" "out/$name.png" --preview "out/$name.html"
  if command -v povray >/dev/null; then
    "$bin/lentray-diff" "$scene" Lenticular=On "$@" --output "out/$name" --json "out/$name.json" \
      --grade match
  fi
  echo "integral image: out/$name.png; as through its lenses, in a browser: out/$name.html"
}

show demo scenes/demo.pov +W1200 +H900
examples=/usr/share/doc/povray/examples
if command -v povray >/dev/null && [ -d $examples ]; then
  show sombrero $examples/advanced/sombrero.pov +W960 +H720
fi

echo
echo "Done. Show the integral images at their printed size behind a sheet of 22.6 lenses an inch."
if command -v povray >/dev/null; then
  echo "out/*-side.png: lentray | stock POV-Ray | difference x 8."
else
  echo "To hold them against stock POV-Ray, lens by lens: tools/setup.sh --tests && tools/demo.sh"
fi
