#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds the page: the module with and without SIMD by emscripten, the scripts by esbuild, the sample characters and the bundled model beside them.
#   build.sh [OUTPUT_DIR]      samples/web/dist; serve it with any web server. Object files go to OUTPUT_DIR.build
#   build.sh --packages        Debian packages that building and testing need and that are not there
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd) root=$(cd "$(dirname "$0")/../.." && pwd)
if [ "${1:-}" = --packages ]; then
  command -v emcc >/dev/null || echo emscripten
  [ -f /usr/include/stb/stb_image.h ] || echo libstb-dev # PNG and JPEG in WebAssembly
  command -v zopfli >/dev/null || echo zopfli
  [ -f /usr/include/utf8.h ] || echo libutfcpp-dev # Assimp's, whose sources samples/npm/wasm/scenes/assimp.sh fetches
  command -v chromium google-chrome google-chrome-stable chromium-browser >/dev/null || echo chromium
  command -v firefox-esr firefox >/dev/null || echo firefox-esr
  command -v Xvfb >/dev/null || echo xvfb # Firefox has no WebGL without a display
  exit 0
fi
. "$root/samples/npm/wasm/modules.sh"
. "$here/wasm/split.sh"
start_build web "${1:-$here/dist}"
for kind in scalar simd; do
  step "the engine to WebAssembly, $kind"
  build_engine "$kind" || exit 1
done
step "formats, character and page to WebAssembly"
build_host || exit 1
build_module modules "$here/wasm" -DSINEW_ENGINE_ARCHIVES="$SINEW_WASM_ENGINE" "${host_arguments[@]}" --no-warn-unused-cli
build_scenes
step "splitting what the first bind needs from the rest"
rm -f "$out"/*.{wasm,sinew,zlib}
for kind in simd scalar; do split_module "$kind" "$out"; done
pack_code "$scenes/scenes.wasm" "$out/sinew-scenes.wasm"

step "scripts and pages"
node_modules_has() { local name; for name in "$@"; do [ -d "$here/node_modules/$name" ] || return 1; done; }
node_modules_has three esbuild three-mesh-bvh typescript eslint || npm ci --silent --no-audit --no-fund --prefix "$here"
cd "$here"
rm -f "$out"/*.js
cp node_modules/three/examples/jsm/libs/draco/gltf/draco_wasm_wrapper.js "$build/draco.cjs" # three's package says that it is a module, and it is none
# What reads FBX and what shows materials are files of their own, loaded when they are asked for.
node_modules/.bin/esbuild src/landing.js src/worker.js --bundle --splitting --minify --format=esm --target=es2022 --outdir="$out" --log-level=warning \
  --alias:@sinew/skin/loader="$root/samples/npm/src/loader.js" --alias:@sinew/skin/scenes="$root/samples/npm/src/scenes.js" \
  --alias:@sinew/skin/character="$root/samples/npm/src/character.js" --external:../wasm/\* --external:fs --external:path --alias:sinew-scenes="$scenes/scenes.mjs" --alias:sinew-draco="$build/draco.cjs" \
  --alias:sinew-simd="$build/modules/simd/sinew_web.mjs" --alias:sinew-scalar="$build/modules/scalar/sinew_web.mjs"
node_modules/.bin/esbuild src/style.css --minify --outdir="$out" --log-level=warning
cp src/index.html src/icon.svg src/manifest.webmanifest src/sw.js "$out"
pack_code node_modules/three/examples/jsm/libs/draco/gltf/draco_decoder.wasm "$out/sinew-draco.wasm"
for model in default rig hands front; do pack_model "$root/samples/data/sinew_$model.sinew" "$out/sinew_$model.sinew"; done
mkdir -p "$out/samples" "$out/thumbs" "$build/moving"
cp src/thumbs/*.webp "$out/thumbs"
node samples/clothed.mjs "$out/samples/biped__clothed.glb"
cp "$root"/samples/data/*.{obj,rig.txt,gltf} "$root"/samples/data/drawing__child.png "$out/samples"
step "moving pictures of the samples"
node samples/clothed.mjs "$build/moving/biped__clothed.glb" 0.5 # the first one is fetched before anything else
node samples/moving.mjs "$build"/modules/simd/sinew_web.{mjs,wasm} "$build/moving" "$build/moving" "$out/samples" "$root/samples/data" >&2
for picture in "$build"/moving/*.moving; do pack_code "$picture" "$out/samples/${picture##*/}"; done
# What sw.js keeps for a page without a network: all of it but the module without SIMD, which is kept when it is used.
(cd "$out" && ls -- *.html *.css *.svg *.js *.webmanifest thumbs/*.webp samples/* sinew-{simd,scenes,draco}*.wasm.zlib *.sinew.zlib) | grep -v '^sw\.js$' |
  sed 's/.*/"&"/' | paste -sd, | sed 's/.*/[&]/' >"$out/files.json"
echo "web: built $out"
