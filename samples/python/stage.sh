#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The package as a folder that runs: sources, the engine's shared library, models. What the wheel and Blender's add-on hold.
#   stage.sh BUILD FOLDER       BUILD is where the engine is compiled; SINEW_LIBRARY and SINEW_TOOLCHAIN as in build.sh
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
build=$1 folder=$2
library=${SINEW_LIBRARY:-}
if [ -z "$library" ]; then
  # shellcheck disable=SC2086
  cmake -S "$root/engine" -B "$build/engine" -DCMAKE_BUILD_TYPE=Release -DBUILD_SHARED_LIBS=ON ${SINEW_TOOLCHAIN:-} >"$build/cmake.log" ||
    { cat "$build/cmake.log" >&2; exit 1; }
  cmake --build "$build/engine" --target sinew_engine_shared --parallel 2 >>"$build/cmake.log" || { tail -20 "$build/cmake.log" >&2; exit 1; }
  for name in libsinew.so libsinew.dll sinew.dll libsinew.dylib; do
    if [ -f "$build/engine/$name" ]; then library=$build/engine/$name; fi
  done
fi
if [ ! -f "$library" ]; then
  echo "python/stage.sh: ${library:-$build/engine}: no shared library there" >&2
  exit 1
fi
mkdir -p "$folder/data"
cp "$root"/samples/python/src/sinew/{*.py,py.typed} "$folder"
name=$(basename "$library")
case $name in *.so*) name=${name%%.so*}.so ;; esac
cp -L "$library" "$folder/data/$name"
cp "$root"/samples/data/sinew_{default,rig,hands}.{sinew,md} "$folder/data"
