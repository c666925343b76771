#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds the package: the module with and without SIMD by emscripten, the bundled models, the scripts, a tarball of them.
#   build.sh [OUTPUT_DIR]      samples/npm/dist: package/ and sinew-skin-VERSION.tgz. Object files go to OUTPUT_DIR.build
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd) root=$(cd "$(dirname "$0")/../.." && pwd)
. "$root/samples/npm/wasm/modules.sh"
start_build npm "${1:-$here/dist}"
# A module of JavaScript with a file's bytes, so that every bundler finds them.
embed() { { echo "// Made by build.sh of $(basename "$1")."; printf 'export default "%s";\n' "$(base64 -w0 "$1")"; } >"$2"; }

rm -rf "$out/package"
mkdir -p "$out/package/wasm" "$out/package/models"
for kind in simd scalar; do
  step "to WebAssembly, $kind"
  build_engine "$kind" || exit 1
  build_module "$kind" "$here/wasm" -DSINEW_SKIN_SIMD="$([ $kind = simd ] && echo ON || echo OFF)"
  cp "$build/$kind/skin.wasm" "$out/package/wasm/$kind.wasm"
  cp "$build/$kind/bind.wasm" "$out/package/wasm/bind-$kind.wasm"
  for module in "$kind" "bind-$kind"; do embed "$out/package/wasm/$module.wasm" "$out/package/wasm/$module.js"; done
done

step "whole characters to WebAssembly"
build_engine simd && build_host || exit 1
build_module character "$here/wasm/character" "${host_arguments[@]}"
build_scenes
for module in "$build/character/character" "$scenes/scenes"; do
  cp "$module.wasm" "$out/package/wasm"
  cp "$module.mjs" "$out/package/wasm/$(basename "$module").js"
done

step "scripts and models"
for model in default:weights rig:skeletons hands:hands front:fronts; do
  cp "$root/samples/data/sinew_${model%:*}.sinew" "$out/package/models/${model#*:}.sinew"
  embed "$out/package/models/${model#*:}.sinew" "$out/package/models/${model#*:}.js"
done
cp -r "$here/src" "$here/README.md" "$root/LICENSE" "$out/package"
node -e '
  const { devDependencies, ...published } = JSON.parse(require("fs").readFileSync(process.argv[1]));
  require("fs").writeFileSync(process.argv[2], JSON.stringify(published, null, 2) + "\n");
' "$here/package.json" "$out/package/package.json"
(cd "$out/package" && npm pack --silent --pack-destination "$out" >/dev/null)
echo "npm: built $(ls "$out"/*.tgz)"
