#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes all files of a release from a clean clone, and tries each of them away from the sources.
#   scripts/release.sh [OUT]        build/files by default; what was in it is replaced
#   scripts/release.sh --packages   the Debian packages that it needs
#   SINEW_CLEAN_ROOT=1              also installs the Debian package into a fresh Debian (mmdebstrap, as root, with network)
set -euo pipefail
cd "$(dirname "$0")/.."
root=$PWD
if [ "${1:-}" = --packages ]; then
  echo dpkg-dev file g++-aarch64-linux-gnu qemu-user-static g++-mingw-w64-x86-64-posix wine wine64
  samples/web/build.sh --packages
  samples/python/build.sh --packages
  tests/integration/csharp_test.sh --packages
  exit 0
fi
out=${1:-build/files}
mkdir -p "$out"
out=$(cd "$out" && pwd)
work=$root/build/release-work
rm -rf "$work" "${out:?}"/*
mkdir -p "$work"
jobs=$(nproc)
windows=$root/engine/cmake/toolchains/windows.cmake arm64=$root/engine/cmake/toolchains/linux.cmake
fail() { echo "release: $*" >&2; exit 1; }
step() { echo "== $*"; }
quietly() { "$@" >"$work/log" 2>&1 || { tail -30 "$work/log" >&2; fail "failed: $*"; }; }
[ -z "$(git status --porcelain 2>/dev/null)" ] || fail "the folder has changes that are not committed; a release is made of a clean clone"

step "Debian packages and tar.gz"
quietly cmake --preset package
quietly cmake --build --preset package -j "$jobs"
version=$("$root/build/package/sinew" --version | cut -d ' ' -f 2)
for generator in DEB TGZ; do quietly cpack -G $generator --config build/package/CPackConfig.cmake -B "$work/packed"; done
mv "$work"/packed/*.deb "$out"
mv "$work"/packed/*.tar.gz "$out/sinew-$version-linux-$(uname -m).tar.gz"

# The command of a folder binds, far from the sources, to the bytes that the build here gives.
mkdir -p "$work/elsewhere"
cp samples/data/snake__long.* "$work/elsewhere"
cd "$work/elsewhere"
quietly "$root/build/package/sinew" bind snake__long.obj --skeleton snake__long.rig.txt -o expected.glb
binds() { # COMMAND NAME
  quietly env -i "$1" bind snake__long.obj --skeleton snake__long.rig.txt -o "$2.glb"
  cmp expected.glb "$2.glb" || fail "$2: other weights than the build's"
  echo "   $2: binds, the same bytes"
}
for deb in "$out"/*.deb; do dpkg-deb -x "$deb" "$work/deb"; done
binds "$work/deb/usr/bin/sinew" deb
mkdir -p "$work/tgz" && tar -C "$work/tgz" --strip-components 1 -xf "$out"/*.tar.gz
binds "$(find "$work/tgz" -path '*/bin/sinew')" tar.gz
if [ "${SINEW_CLEAN_ROOT:-0}" = 1 ]; then
  command -v mmdebstrap >/dev/null || fail "SINEW_CLEAN_ROOT=1 needs mmdebstrap"
  quietly mmdebstrap --variant=minbase "$(. /etc/os-release && echo "$VERSION_CODENAME")" "$work/clean"
  cp "$out"/sinew_*.deb snake__long.* "$work/clean/tmp"
  quietly chroot "$work/clean" sh -c 'cd /tmp && apt-get update && apt-get install -y ./sinew_*.deb && sinew bind snake__long.obj --skeleton snake__long.rig.txt -o clean.glb'
  cmp expected.glb "$work/clean/tmp/clean.glb" || fail "a clean root: other weights"
  rm -rf "$work/clean"
  echo "   clean root: installs and binds, the same bytes"
fi
cd "$root"

step "Windows: engine, headers, models"
quietly cmake -S engine -B "$work/windows" --toolchain "$windows" -DCMAKE_BUILD_TYPE=Release -DBUILD_SHARED_LIBS=ON
quietly cmake --build "$work/windows" -j "$jobs"
folder=$work/sinew-$version-windows-x64
quietly cmake --install "$work/windows" --prefix "$folder"
mkdir -p "$folder/models"
cp samples/data/sinew_{default,rig,hands}.{sinew,md} "$folder/models"
cp samples/csharp/{Character,Native,Sinew}.cs LICENSE "$folder"
(cd "$work" && cmake -E tar cf "$out/sinew-$version-windows-x64.zip" --format=zip "$(basename "$folder")")
# shellcheck source=tests/support/wine.sh
. tests/support/wine.sh "$work/wine"
quietly cmake -S tests/integration/consumer -B "$work/consumer" --toolchain "$windows" -DCMAKE_FIND_ROOT_PATH="$folder"
quietly cmake --build "$work/consumer"
WINEPATH=$folder/bin run_wine "$work/consumer/consumer.exe" | grep "^sinew $version" >/dev/null || fail "the DLL does not run under wine"
echo "   a program links the DLL and runs under wine"

step "Python wheels and Blender add-ons"
machine=$(uname -m)
quietly samples/python/build.sh "$work/python"
character=$(find "$work/python/character" -name libsinew_character.so)
SINEW_TOOLCHAIN="--toolchain $windows" SINEW_PLATFORM=win_amd64 quietly samples/python/build.sh "$work/python-windows"
quietly samples/blender/build.sh "$work/blender"
SINEW_TOOLCHAIN="--toolchain $windows" SINEW_PLATFORM=windows-x64 quietly samples/blender/build.sh "$work/blender-windows"
if [ "$machine" = x86_64 ]; then
  arm="--toolchain $arm64 -DSINEW_CROSS=aarch64-linux-gnu"
  SINEW_TOOLCHAIN=$arm SINEW_PLATFORM=linux_aarch64 quietly samples/python/build.sh "$work/python-arm64"
  SINEW_TOOLCHAIN=$arm SINEW_PLATFORM=linux-arm64 quietly samples/blender/build.sh "$work/blender-arm64"
fi
cp "$work"/python*/sinew-*.whl "$work"/blender*/sinew-blender-*.zip "$out"
python=python3
"$python" -c 'import numpy, ensurepip' 2>/dev/null || python=/usr/bin/python3
quietly "$python" -m venv --system-site-packages "$work/venv"
quietly "$work/venv/bin/python" -m pip install --no-index --no-deps "$work"/python/sinew-*.whl
(cd "$root/samples/python/tests" &&
  SINEW_COMMAND=$root/build/package/sinew SINEW_SOURCE_DIR=$root PYTHONDONTWRITEBYTECODE=1 quietly "$work/venv/bin/python" -m unittest test_bind test_binding test_opened)
echo "   the wheel installs into a fresh venv and binds to the command's bytes"
if command -v blender >/dev/null; then
  quietly tests/integration/blender_test.sh "$root" "$character" "$root/build/package/sinew" "$work/blender-test"
  echo "   the add-on installs into $(blender --version | head -1) and passes its tests"
else
  echo "   blender is not installed: the add-on was not tried"
fi

step "npm package"
quietly samples/npm/build.sh "$work/npm"
cp "$work"/npm/*.tgz "$out"
mkdir -p "$work/project" && echo '{"type": "module", "private": true}' >"$work/project/package.json"
(cd "$work/project" && quietly npm install --offline --no-audit --no-fund "$(echo "$out"/*.tgz)" &&
  quietly node -e 'import("@sinew/skin").then((s) => { if (!Object.keys(s).length) process.exit(1); })')
echo "   the tarball installs into a fresh project and loads in node $(node --version)"

step "C#"
quietly cmake -S engine -B "$work/engine" -DCMAKE_BUILD_TYPE=Release -DBUILD_SHARED_LIBS=ON
quietly cmake --build "$work/engine" --target sinew_engine_shared -j "$jobs"
quietly tests/integration/csharp_test.sh "$root" "$work/engine/libsinew.so" "$root/build/package/sinew" "$work/csharp" "$character"
SINEW_LIBRARY=$character SINEW_ENGINE_LIBRARY=$work/engine/libsinew.so quietly samples/csharp/build.sh "$work/csharp-package"
(cd "$work/csharp-package" && cmake -E tar cf "$out/sinew-csharp-$version-linux-$machine.zip" --format=zip sinew-csharp)
echo "   C#: structs, arrays and characters equal C's and the command's; sources and libraries are in one zip"

step "Godot plug-in"
(cd samples/godot && cmake -E tar cf "$out/sinew-godot3-$version.zip" --format=zip addons README.md)
if command -v godot3-server >/dev/null; then
  mkdir -p "$work/godot" && (cd "$work/godot" && cmake -E tar xf "$out/sinew-godot3-$version.zip")
  quietly tests/integration/godot_test.sh "$root" "$root/build/package/sinew" "$work/godot-test" "$work/godot/addons"
  echo "   the plug-in runs in Godot's headless editor and binds to the command's bytes"
else
  echo "   godot3-server is not installed: the plug-in was not tried"
fi

step "models, licenses, checksums"
cp samples/data/sinew_{default,rig,hands}.{sinew,md} "$out"
cp package/copyright "$out/LICENSES.txt"
(cd "$out" && sha256sum -- * >SHA256SUMS)
rm -rf "$work"
echo "release $version: $(find "$out" -type f | wc -l) files in $out"
