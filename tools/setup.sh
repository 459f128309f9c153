#!/bin/sh
# Installs Debian packages. May be run again at any time: it does nothing, and needs neither root nor
# network, when all are there. Why each is needed: docs/building.md.
#   tools/setup.sh              what building and rendering need
#   tools/setup.sh --tests      also what tests, comparisons and studies need: POV-Ray, Embree, valgrind ...
#   tools/setup.sh --package    also what tools/package.sh needs
#   tools/setup.sh --all        all of these, and what tools/test.sh --all needs
#   tools/setup.sh --list ...   names them alone
set -eu

packages="
  cmake ninja-build g++ python3
  libtbb-dev libxxhash-dev libboost-dev libboost-program-options-dev nlohmann-json3-dev
  libopenimageio-dev openimageio-tools libopenexr-dev libpng-dev zlib1g-dev libgif-dev libjpeg-dev
  liblcms2-dev libfreetype-dev"
package_packages="dpkg-dev file"
test_packages="
  ccache git libgtest-dev libbenchmark-dev libembree-dev valgrind gnuplot-nox libjxl-devtools poppler-utils
  povray povray-includes povray-examples"
all_packages="clang-format clang-tidy"

lists=no
for word; do
  case $word in
    --list) lists=yes ;;
    --tests) packages="$packages $test_packages $package_packages" ;;
    --package) packages="$packages $package_packages" ;;
    --all) packages="$packages $test_packages $package_packages $all_packages" ;;
    *)
      sed -n '2,8s/^# \{0,1\}//p' "$0" >&2
      exit 2
      ;;
  esac
done
if [ $lists = yes ]; then
  # shellcheck disable=SC2086 # a list of words on purpose
  echo $packages
  exit 0
fi

is_installed() {
  dpkg-query -W -f '${db:Status-Abbrev}' "$1" 2>/dev/null | grep -q '^ii'
}

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
  echo "tools/setup.sh knows Debian and its relatives only. Elsewhere, install what these" >&2
  echo "Debian packages hold, then build with CMake (see docs/building.md):" >&2
  # shellcheck disable=SC2086 # a list of words on purpose
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
