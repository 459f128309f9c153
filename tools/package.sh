#!/bin/sh
# Builds Debian's package: build/package/lentray_VERSION_ARCHITECTURE.deb, whose name is the last line.
#   tools/package.sh && apt install ./build/package/lentray_*.deb
set -eu
cd "$(dirname "$0")/.."

tools/setup.sh --package
cmake --preset release -DLENTRAY_TESTS=OFF -B build/package
cmake --build build/package
rm -f build/package/*.deb
(cd build/package && cpack -G DEB)
ls build/package/*.deb
