#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds the page with a thousand characters: textures by the command, scripts by esbuild with the packages of samples/web.
#   build.sh [OUTPUT_DIR [SINEW]]      samples/crowd/dist, build/release/sinew; serve it with any web server
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd) web=$(cd "$(dirname "$0")/../web" && pwd)
out=${1:-$here/dist} sinew=${2:-$here/../../build/release/sinew}
[ -x "$sinew" ] || { echo "crowd: expected the command at $sinew; build it, or name it as the second word" >&2; exit 1; }
[ -d "$web/node_modules/three" ] && [ -d "$web/node_modules/esbuild" ] || npm ci --silent --no-audit --no-fund --prefix "$web"
mkdir -p "$out"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# A character for a crowd: a quarter of the triangles.
node "$web/samples/clothed.mjs" "$work/bare.glb"
"$sinew" rig "$work/bare.glb" -o "$work/whole.glb"
"$sinew" lod "$work/whole.glb" --levels 2 -o "$work/character.glb"
mv "$work/character.lod2.glb" "$work/character.glb"
"$sinew" animate "$work/character.glb" --in-place --vat "$out" \
  $(printf -- '--motion builtin:%s ' walk run idle wave jump)
NODE_PATH=$web/node_modules "$web/node_modules/.bin/esbuild" "$here/crowd.js" --bundle --minify --format=esm --target=es2022 --outdir="$out" --log-level=warning
cp "$here/index.html" "$out"
echo "crowd: built $out"
