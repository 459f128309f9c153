#!/bin/sh
# Debian's package, proved: a fresh minbase system is made (mmdebstrap), the package is installed there
# with apt, its programs render scenes, and it is removed without remains. Needs root, mmdebstrap and a
# Debian mirror; about 2 GB of disk and some minutes, most of them for OpenImageIO's 260 libraries.
#   tests/package/package_in_chroot.sh lentray_VERSION_ARCH.deb [MIRROR]
# Status: 0 all is well, 1 something is not, 77 it cannot be tried here.
set -eu

deb=$(realpath "$1")
mirror=${2:-http://deb.debian.org/debian}
[ "$(id -u)" -eq 0 ] || { echo "package_in_chroot: needs root"; exit 77; }
command -v mmdebstrap >/dev/null || { echo "package_in_chroot: needs mmdebstrap (apt install mmdebstrap)"; exit 77; }

root=$(mktemp -d "${TMPDIR:-/tmp}/lentray-chroot-XXXXXX")
clean() {
  for place in proc dev; do
    if mountpoint -q "$root/$place"; then umount "$root/$place"; fi
  done
  rm -rf --one-file-system "$root"
}
trap clean EXIT
trap 'exit 1' INT TERM HUP
inside() { chroot "$root" env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"; }
step() { printf '== %s\n' "$*"; }
fail() { echo "FAILED: $*"; exit 1; }

step "a minbase system of Debian bookworm"
mmdebstrap --quiet --variant=minbase --mode=root bookworm "$root" "$mirror"
cp /etc/resolv.conf "$root/etc/resolv.conf"
# Programs find what is beside them through /proc.
mountpoint -q "$root/proc" || mount -t proc proc "$root/proc"
packages=$(inside dpkg-query -f . -W | wc -c)
echo "$packages packages"

step "the package, by apt"
cp "$deb" "$root/lentray.deb"
inside apt-get update -qq
inside apt-get install -q -y /lentray.deb >"$root/apt.log" 2>&1 || { tail -20 "$root/apt.log"; fail "apt-get install"; }
inside dpkg -s lentray | grep '^Status: install ok installed' || fail "the package is not installed"
inside dpkg -s povray-includes >/dev/null || fail "povray-includes did not come along"
echo "$(($(inside dpkg-query -f . -W | wc -c) - packages)) packages came"

step "no library is missing"
for file in /usr/bin/lentray /usr/bin/lentray-diff /usr/bin/lentray-model /usr/bin/lentray-grouping \
            /usr/lib/lentray/lentray_openimageio.so; do
  if inside ldd "$file" | grep 'not found'; then fail "$file"; fi
done

step "scenes"
mkdir "$root/scenes"
cat >"$root/scenes/scene.pov" <<'SCENE'
#version 3.7;
global_settings { assumed_gamma 1 }
#include "colors.inc"
#include "stones.inc"
camera { location <0, 2, -5> look_at 0 }
light_source { <4, 6, -5>, White }
plane { y, -1 pigment { checker White, Gray30 } }
sphere { 0, 1 texture { T_Stone24 } }
SCENE
render() { inside sh -c 'cd /scenes && exec "$@"' sh "$@" 2>"$root/scenes/log" || { cat "$root/scenes/log"; fail "$*"; }; }
written() { # FILE, what file types it may begin with
  [ -s "$root/scenes/$1" ] || fail "$1 was not written"
  [ "$(head -c4 "$root/scenes/$1" | od -An -tx1 | tr -d ' ')" = "$2" ] || fail "$1 is no such picture"
  echo "$1: $(stat -c %s "$root/scenes/$1") bytes"
}
render lentray scene.pov +W160 +H120 -V
written scene.png 89504e47
# The OpenImageIO module: another way out, and a way in.
render lentray scene.pov +W160 +H120 -V +Oscene.tif
written scene.tif 49492a00
cat >"$root/scenes/picture.pov" <<'SCENE'
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <.5, .5, -1> direction z right x up y }
plane { z, 0 pigment { image_map { tiff "scene.tif" interpolate 0 } } finish { emission 1 ambient 0 diffuse 0 } }
SCENE
render lentray picture.pov +W160 +H120 -V
written picture.png 89504e47
render lentray /usr/share/doc/lentray/examples/demo.pov +W240 +H180 Lenticular=On -V +Odemo.png
written demo.png 89504e47
inside lentray-diff /scenes/scene.png /scenes/scene.tif --grade exact --no-pictures | tail -1 || fail "lentray-diff"
# As povray, for a program that runs povray; the real one came along with its include files.
mkdir -p "$root/usr/local/bin"
ln -s ../../bin/lentray "$root/usr/local/bin/povray"
render /usr/local/bin/povray +Iscene.pov +Oas-povray.png +W160 +H120 -D
written as-povray.png 89504e47
cmp "$root/scenes/scene.png" "$root/scenes/as-povray.png" || fail "the link named povray renders another picture"
render /usr/local/bin/povray --version
grep -q '^POV-Ray 3\.7' "$root/scenes/log" || fail "povray --version does not begin with POV-Ray 3.7"
[ -s "$root/usr/share/man/man1/lentray.1.gz" ] || echo "(minbase systems leave manual pages out)"
rm "$root/usr/local/bin/povray"

step "removed without remains"
rm -r "$root/scenes" "$root/lentray.deb" "$root/apt.log"
inside apt-get purge -q -y lentray >/dev/null 2>&1 || fail "apt-get purge"
left=$(inside find / -xdev -path /proc -prune -o -name '*lentray*' -print)
[ -z "$left" ] || fail "left behind: $left"
echo "package_in_chroot: all is well"
