#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds the add-on's zip from a clean clone: the Python package with its library and models inside. Offline.
#   samples/blender/build.sh [OUT]      OUT/sinew-blender-0.1.0-PLATFORM.zip, OUT is build/blender by default
#   samples/blender/build.sh --packages Debian packages that testing needs and that are not there
#   SINEW_LIBRARY=FILE                  takes this library instead of compiling one
#   SINEW_TOOLCHAIN="--toolchain FILE"  more for CMake; SINEW_PLATFORM=windows-x64 names the zip of it (linux-x64, linux-arm64)
set -euo pipefail
if [ "${1:-}" = --packages ]; then
  for package in blender xvfb python3-numpy; do
    dpkg-query -W -f='${Status}' $package 2>/dev/null | grep -q 'install ok installed' || echo $package
  done
  exit 0
fi
root=$(cd "$(dirname "$0")/../.." && pwd)
out=${1:-$root/build/blender}
mkdir -p "$out"
out=$(cd "$out" && pwd)

stage=$out/stage
rm -rf "$stage" && mkdir -p "$stage"
cp -R "$root/samples/blender/sinew_blender" "$stage"
"$root/samples/python/stage.sh" "$out" "$stage/sinew_blender/sinew"
cp "$root/LICENSE" "$stage/sinew_blender"
find "$stage" -name __pycache__ -type d -exec rm -rf {} +
case ${SINEW_PLATFORM:-$(uname -sm)} in
  "Linux x86_64") platform=linux-x64 ;;
  "Linux aarch64") platform=linux-arm64 ;;
  *) platform=${SINEW_PLATFORM:-$(uname -sm | tr ' A-Z' '-a-z')} ;;
esac
zip=$out/sinew-blender-0.1.0-$platform.zip
rm -f "$zip"
(cd "$stage" && cmake -E tar cf "$zip" --format=zip sinew_blender)
echo "$zip"
