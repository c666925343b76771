#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds what a program in C# needs, from a clean clone: sources, both shared libraries with what they need, models, and Demo.exe where mcs is.
#   samples/csharp/build.sh [OUT]      OUT/sinew-csharp, OUT is build/csharp by default
#   SINEW_LIBRARY=FILE SINEW_ENGINE_LIBRARY=FILE   take these instead of compiling them
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
out=${1:-$root/build/csharp}
mkdir -p "$out"
out=$(cd "$out" && pwd)
folder=$out/sinew-csharp
rm -rf "$folder" "$out/stage" && mkdir -p "$folder"
"$root/samples/python/stage.sh" "$out" "$out/stage"
cp "$out"/stage/data/* "$folder"
engine=${SINEW_ENGINE_LIBRARY:-}
if [ -z "$engine" ]; then
  cmake -S "$root/engine" -B "$out/engine" -DCMAKE_BUILD_TYPE=Release -DBUILD_SHARED_LIBS=ON >"$out/engine.log" || { cat "$out/engine.log" >&2; exit 1; }
  cmake --build "$out/engine" --target sinew_engine_shared --parallel 2 >>"$out/engine.log" || { tail -20 "$out/engine.log" >&2; exit 1; }
  engine=$out/engine/libsinew.so
fi
cp -L "$engine" "$folder/libsinew.so"
cp "$root"/samples/csharp/{Character,CharacterDelivery,CharacterFrames,CharacterJobs,Native,RetargetStream,Sinew}.cs "$root/samples/csharp/demo/Demo.cs" "$root/samples/csharp/README.md" "$root/LICENSE" "$folder"
if command -v mcs >/dev/null; then
  mcs -langversion:7 -out:"$folder/Demo.exe" "$folder"/*.cs
else
  echo "csharp/build.sh: no mcs (Debian: mono-mcs), so no Demo.exe" >&2
fi
echo "$folder"
