#!/bin/sh
# What cmake --install puts somewhere works there and elsewhere, when the folder has moved.
#   tests/package/installed.sh BUILD_FOLDER PROGRAM...
set -eu

folder=$(mktemp -d "${TMPDIR:-/tmp}/lentray-installed-XXXXXX")
trap 'rm -rf "$folder"' EXIT
fail() { echo "FAILED: $*"; exit 1; }

cmake --install "$1" --prefix "$folder/first" >/dev/null
mv "$folder/first" "$folder/its place"
shift
cd "$folder"
for program; do
  for file in "bin/$program" "share/man/man1/$program.1.gz"; do
    [ -s "$folder/its place/$file" ] || fail "$file is not installed"
  done
done
for file in lib/lentray/lentray_openimageio.so share/bash-completion/completions/lentray \
            share/zsh/vendor-completions/_lentray share/doc/lentray/LICENSE share/doc/lentray/README.md \
            share/doc/lentray/docs/language.md share/doc/lentray/examples/demo.pov \
            share/doc/lentray/service/lentray@.service; do
  [ -s "$folder/its place/$file" ] || fail "$file is not installed"
done
PATH="$folder/its place/bin:$PATH"
lentray "its place/share/doc/lentray/examples/demo.pov" +W80 +H60 -V +Oa.png
lentray "its place/share/doc/lentray/examples/demo.pov" +W80 +H60 -V +Ob.tif # by OpenImageIO
lentray-diff a.png b.tif --grade exact --no-pictures >/dev/null || fail "PNG and TIFF differ"
# A link of another name, as callers of povray have it, finds the module too.
ln -s "its place/bin/lentray" povray
./povray "its place/share/doc/lentray/examples/demo.pov" +W80 +H60 -V +Oc.tif
lentray-diff b.tif c.tif --grade exact --no-pictures >/dev/null || fail "the link renders another picture"
./povray --version 2>&1 >/dev/null | head -1 | grep -q '^POV-Ray 3\.7' || fail "povray --version"
[ -z "$(./povray --version 2>/dev/null)" ] || fail "povray --version writes to standard output"
[ -n "$(lentray --version)" ] || fail "lentray --version"
echo "installed: all is well"
