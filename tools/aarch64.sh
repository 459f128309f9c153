#!/bin/sh
# Builds for aarch64, and runs the unit tests but for the slow ones there by qemu: the plain half of
# core/base/simd.h at work.
#   tools/aarch64.sh [--install] [further arguments for the tests, as --gtest_filter=...]
# Everything is made in build/aarch64: `root` holds Debian's libraries for aarch64, from where this machine
# has its own. Needs Debian 12 and three of its packages; --install installs them, as root always does.
set -eu
cd "$(dirname "$0")/.."

tools="mmdebstrap qemu-user-static g++-aarch64-linux-gnu"
build=build/aarch64
root=$PWD/$build/root

install=no
[ "$(id -u)" -ne 0 ] || install=yes
if [ "${1:-}" = --install ]; then
  install=yes
  shift
fi
if ! command -v mmdebstrap >/dev/null || ! command -v qemu-aarch64-static >/dev/null ||
   ! command -v aarch64-linux-gnu-g++ >/dev/null; then
  if [ $install = no ]; then
    echo "aarch64: missing tools; tools/aarch64.sh --install installs them, or, as root," >&2
    echo "  apt-get install --no-install-recommends $tools" >&2
    exit 1
  fi
  as_root=""
  [ "$(id -u)" -eq 0 ] || as_root=sudo
  # shellcheck disable=SC2086 # a list of words on purpose
  $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends $tools
fi

# The libraries of the build, not of the benchmarks.
packages=$(tools/setup.sh --list --tests | tr ' ' '\n' | grep -E '^(lib.*|zlib1g|nlohmann-json3)-dev$|^openimageio-tools$' |
  grep -vE '^lib(benchmark|embree)-dev$')
wanted=$(printf '%s\n' $packages | sort)
if [ "$(cat "$root/packages" 2>/dev/null)" != "$wanted" ]; then
  echo "aarch64: making $build/root"
  rm -rf "$root"
  mkdir -p "$build"
  # Where this machine's apt has Debian from, and how.
  apt-get indextargets --format '$(ORIGIN) deb $(REPO_URI) $(RELEASE) $(COMPONENT)' 'Created-By: Packages' |
    sed -n 's/^Debian //p' | sort -u >"$build/sources.list"
  apt-config dump | grep -iE '^Acquire::(.*proxy|Check-)' >"$build/apt.conf" || true
  # Unpacked only: none of it runs but by qemu.
  mmdebstrap --variant=extract --architectures=arm64 --aptopt="$build/apt.conf" \
    --hook-dir=/usr/share/mmdebstrap/hooks/merged-usr \
    --include="libc6-dev,$(printf '%s\n' $packages | paste -sd,)" bookworm "$root" - <"$build/sources.list"
  # What the packages' scripts would have made; and no link leads out of the root.
  for name in blas lapack; do
    ln -sf $name/lib$name.so.3 "$root/usr/lib/aarch64-linux-gnu/lib$name.so.3"
  done
  find "$root/usr" -type l -lname '/*' | while read -r link; do
    ln -sfnr "$root$(readlink "$link")" "$link"
  done
  echo "$wanted" >"$root/packages"
fi

cmake -S . -B $build -G Ninja -DCMAKE_BUILD_TYPE=Release -DLENTRAY_ONCE=ON \
  -DCMAKE_TOOLCHAIN_FILE="$PWD/tools/aarch64.cmake" -DLENTRAY_ROOT="$root"
cmake --build $build --target lentray test_unit -j "${JOBS:-$(nproc)}"
qemu-aarch64-static -L "$root" $build/bin/test_unit --gtest_filter='-Slow*' "$@"
