#!/bin/sh
# Builds Debian's package: build/package/lentray_VERSION_ARCHITECTURE.deb, whose name is the last line, and beside it the list
# of its parts with versions and licences, lentray_VERSION_ARCHITECTURE.spdx.json (tools/parts.py).
#   tools/package.sh && apt install ./build/package/lentray_*.deb
#   tools/package.sh TARGET...   builds these alone in the same way, and no package
# The same source and the same compilers and libraries are to give the same bytes in any folder at any time. Times are of
# SOURCE_DATE_EPOCH, else of the last commit (tests/package/reproducible.sh).
set -eu
cd "$(dirname "$0")/.."

SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct 2>/dev/null || stat -c %Y CHANGELOG.md)}
export SOURCE_DATE_EPOCH LC_ALL=C.UTF-8 TZ=UTC
umask 022
tools/setup.sh --package
cmake --preset release -DLENTRAY_TESTS=OFF -B build/package \
  -DCMAKE_C_FLAGS="'-ffile-prefix-map=$PWD=.'" -DCMAKE_CXX_FLAGS="'-ffile-prefix-map=$PWD=.'"
if [ $# -gt 0 ]; then
  exec cmake --build build/package --target "$@"
fi
cmake --build build/package
rm -f build/package/*.deb build/package/*.spdx.json
(cd build/package && cpack -G DEB)
for deb in build/package/*.deb; do
  tools/parts.py "$deb" "${deb%.deb}.spdx.json"
done
ls build/package/*.deb
