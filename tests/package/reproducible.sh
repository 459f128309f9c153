#!/bin/sh
# Two builds of the package in different folders, at different times, in different time zones and for different users' umasks
# have the same bytes: the commit is built twice, without a compiler cache, and checksums are compared.
#   tests/package/reproducible.sh              the package and the list of its parts
#   tests/package/reproducible.sh TARGET...    what these targets alone make: programs, modules, libraries; quicker
# The folders are below FOLDER, build/reproducible unless told, and stay where something differs.
# Status: 0 the same, 1 not.
set -eu
cd "$(dirname "$0")/../.."
source=$PWD
folder=$(realpath -m "${FOLDER:-build/reproducible}")
rm -rf "$folder"

SOURCE_DATE_EPOCH=$(git log -1 --format=%ct)
export SOURCE_DATE_EPOCH CCACHE_DISABLE=1
build() { # FOLDER TIME_ZONE UMASK TARGET...
  place=$1 zone=$2 mask=$3
  shift 3
  mkdir -p "$place"
  git -C "$source" archive HEAD | tar -x -C "$place"
  (cd "$place" && umask "$mask" && TZ=$zone tools/package.sh "$@" >build.log 2>&1) || { tail -20 "$place/build.log"; exit 1; }
  (cd "$place/build/package" && find . \( -name '*.deb' -o -name '*.spdx.json' -o -name '*.a' -o -name '*.so' -o -path './bin/*' \) \
    -type f -exec sha256sum {} + | LC_ALL=C sort -k 2) >"$place.sums"
}
build "$folder/a" UTC 022 "$@"
sleep 2 # times are kept in seconds
build "$folder/another-folder-of-a-longer-name" Pacific/Auckland 077 "$@"
cat "$folder/a.sums"
if ! diff "$folder/a.sums" "$folder/another-folder-of-a-longer-name.sums"; then
  echo "reproducible: two builds differ; they are in $folder"
  exit 1
fi
[ -s "$folder/a.sums" ] || { echo "reproducible: nothing was made"; exit 1; }
rm -rf "$folder"
echo "reproducible: two builds are the same"
