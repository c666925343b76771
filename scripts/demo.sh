#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installs what is missing, builds, makes a skeleton for a bare sample mesh, binds a sample OBJ and a sample GLB with the bundled
# model, and says where the results are.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/setup.sh
cmake --preset release -DSINEW_UNITY=ON >/dev/null
cmake --build --preset release --target sinew_cli -j "$(nproc)"

sinew=build/release/sinew
out=build/demo
mkdir -p "$out"
"$sinew" rig samples/data/biped__robed.obj -o "$out/rigged.glb" --png "$out/rigged.png"
"$sinew" pose "$out/rigged.glb" --random 7 -o "$out/rigged.posed.png"
"$sinew" bind samples/data/biped__robed.obj --skeleton samples/data/biped__robed.rig.txt -o "$out/robed.glb" --png "$out/robed.png"
"$sinew" bind samples/data/quadruped__tailed.obj --skeleton samples/data/quadruped__tailed.rig.txt --method heat -o "$out/quadruped.glb"
"$sinew" bind "$out/quadruped.glb" -o "$out/quadruped.bound.glb" --png "$out/quadruped.png"
"$sinew" pose "$out/robed.glb" --random 7 -o "$out/robed.posed.png"
echo
echo "A bare mesh with its new skeleton:   $out/rigged.glb  $out/rigged.png  $out/rigged.posed.png"
echo "Skinned characters, ready to import: $out/robed.glb  $out/quadruped.bound.glb"
echo "Weights as colours:                  $out/robed.png  $out/quadruped.png"
echo "In a random pose:                    $out/robed.posed.png"
