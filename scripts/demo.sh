#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installs what is missing, builds the command, and makes build/demo/index.html with it: a bare mesh, its skeleton, weights and walk, a pose whose bends
# keep their volume, a drawing that moves, and a check, each with its picture and its command. The page opens where there is a desktop.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/setup.sh
cmake --preset release -DSINEW_UNITY=ON >/dev/null
cmake --build --preset release --target sinew_cli -j "$(nproc)"

out=build/demo
page=$out/index.html
export PATH=$PWD/build/release:$PATH
mkdir -p "$out"
cat >"$page" <<'HEAD'
<!doctype html>
<html lang="en"><meta charset="utf-8"><title>sinew: demo</title>
<style>body { font: 16px/1.5 sans-serif; max-width: 60rem; margin: 2rem auto; padding: 0 1rem }
pre { background: #f2f3f5; padding: .6rem; white-space: pre-wrap } img { max-width: 100%; max-height: 30rem; display: block }</style>
<h1>What sinew made of three samples</h1>
<p>Run each command from the root of the clone, with <code>build/release</code> on the PATH. The .glb files open in any glTF viewer.</p>
HEAD

# step TITLE PICTURE COMMAND...: runs the command, and shows it with its picture on the page.
step() {
  local title=$1 picture=$2
  shift 2
  echo "== $title"
  "$@"
  printf '<h2>%s</h2>\n<pre>%s</pre>\n<img src="%s" alt="%s">\n' "$title" "$*" "$picture" "$title" >>"$page"
}
step "Bare mesh, skeleton, walk" picture.png scripts/picture.py build/release/sinew samples/data/quadruped__tailed.obj "$out/picture.png"
cp samples/data/biped__robed.obj "$out/bare.obj"  # without a skeleton beside it
step "A bare mesh gets a skeleton and weights" rigged.png sinew rig "$out/bare.obj" -o "$out/rigged.glb" --png "$out/rigged.png"
step "It walks" walking.png sinew animate "$out/rigged.glb" --motion builtin:walk -o "$out/walking.glb" --sheet "$out/walking.png"
step "A mesh is bound to its own skeleton" bound.png \
  sinew bind samples/data/biped__robed.obj --skeleton samples/data/biped__robed.rig.txt -o "$out/bound.glb" --png "$out/bound.png"
step "In a random pose, bends keep their volume" posed.png sinew pose "$out/bound.glb" --random 7 --deform volume -o "$out/posed.png"
step "A drawing moves" drawing-loop.png \
  sinew animate samples/data/drawing__child.png -o "$out/drawing.glb" --loop "$out/drawing-loop.png"
sinew check "$out/walking.glb" --report "$out/check.html"
printf '<p><a href="check.html">What sinew check says about the walking character</a></p>\n</html>\n' >>"$page"

echo
echo "All results with their commands: $page"
[ -z "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ] || ! command -v xdg-open >/dev/null || xdg-open "$page"
