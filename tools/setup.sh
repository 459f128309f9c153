#!/bin/sh
# Installs every Debian package that building, testing and comparing need. May be run again at
# any time: it does nothing, and needs neither root nor network, when all are there.
#   tools/setup.sh [--list | --all]     --list: names them alone
#                                       --all: also those that tools/test.sh --all needs
set -eu

packages="
  cmake ninja-build g++ ccache git python3
  libtbb-dev libboost-dev libboost-program-options-dev nlohmann-json3-dev
  libopenimageio-dev openimageio-tools libopenexr-dev libpng-dev zlib1g-dev libgif-dev libjpeg-dev liblcms2-dev libfreetype-dev
  libgtest-dev libbenchmark-dev libembree-dev gnuplot-nox libjxl-devtools valgrind dpkg-dev
  file poppler-utils
  povray povray-includes povray-examples"

if [ "${1:-}" = --all ]; then
  packages="$packages clang-format clang-tidy"
fi
if [ "${1:-}" = --list ]; then
  echo $packages
  exit 0
fi

is_installed() {
  dpkg-query -W -f '${db:Status-Abbrev}' "$1" 2>/dev/null | grep -q '^ii'
}

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
  echo "tools/setup.sh knows Debian and its relatives only. Elsewhere, install what these" >&2
  echo "Debian packages hold, then build with CMake (see README.md):" >&2
  echo $packages >&2
  exit 1
fi

missing=""
for package in $packages; do
  is_installed "$package" || missing="$missing $package"
done
if [ -z "$missing" ]; then
  echo "setup: all packages are installed"
  exit 0
fi

if [ "$(id -u)" -eq 0 ]; then
  as_root=""
elif command -v sudo >/dev/null; then
  as_root="sudo"
else
  echo "These packages are missing, and installing them needs root or sudo:" >&2
  echo "  apt-get install --no-install-recommends$missing" >&2
  exit 1
fi

echo "setup: installing$missing"
$as_root env DEBIAN_FRONTEND=noninteractive apt-get update -q
# shellcheck disable=SC2086 # a list of words on purpose
$as_root env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends $missing
echo "setup: done"
