#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The package as a folder that runs: sources, the shared library, models. What the wheel and Blender's add-on hold.
#   stage.sh BUILD FOLDER       BUILD is where the library is compiled; SINEW_LIBRARY and SINEW_TOOLCHAIN as in build.sh
# The library is libsinew_character, with the libraries beside it that Debian's packages lent it and other systems lack (Assimp for FBX and
# DAE, Draco, meshoptimizer). Where its packages are missing, and for other machines (SINEW_TOOLCHAIN), it is the engine alone: files and
# the command's jobs are refused by one line then.
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
build=$1 folder=$2
library=${SINEW_LIBRARY:-}
if [ -z "$library" ] && [ -z "${SINEW_TOOLCHAIN:-}" ]; then
  if cmake -S "$root" -B "$build/character" -DCMAKE_BUILD_TYPE=Release -DSINEW_BUILD_TRAINER=OFF -DSINEW_BUILD_QUANT=OFF -DSINEW_BUILD_SAMPLES=OFF \
    -DSINEW_BUILD_TESTS=OFF -DSINEW_LATE_LIBRARIES=OFF >"$build/cmake.log" 2>&1; then
    cmake --build "$build/character" --target sinew_character_shared --parallel 2 >>"$build/cmake.log" || { tail -20 "$build/cmake.log" >&2; exit 1; }
    library=$(find "$build/character" -name 'libsinew_character.so' -o -name 'libsinew_character.dylib' | head -1)
  else
    echo "python/stage.sh: the engine alone, without files: $(grep -m1 -A3 'CMake Error' "$build/cmake.log" | tail -1) (scripts/setup.sh installs what is missing)" >&2
  fi
fi
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
cp "$root"/samples/data/sinew_{default,rig,hands,front}.{sinew,md} "$folder/data"
# What the library needs and not every Linux has, with its licenses; the library's RPATH is the folder that it is in.
if [ "$name" = libsinew_character.so ]; then
  ldd "$library" | awk '$2 == "=>" && $3 ~ /^\// { print $1, $3 }' | while read -r needed path; do
    case $needed in libc.so* | libm.so* | libstdc++.so* | libgcc_s.so* | libpthread.so* | libdl.so* | librt.so* | libz.so*) continue ;; esac
    cp -L "$path" "$folder/data/$needed"
    package=$(dpkg-query -S "$(readlink -f "$path")" 2>/dev/null | cut -d: -f1 | head -1)
    if [ -n "$package" ] && [ -f "/usr/share/doc/$package/copyright" ]; then
      cp "/usr/share/doc/$package/copyright" "$folder/data/$package.copyright"
    fi
  done
fi
