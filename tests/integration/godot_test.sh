#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The plug-in of samples/godot: characters imported by the headless editor, bound and rigged in scenes; weights beside the command's.
#   godot_test.sh SOURCE COMMAND WORK [ADDONS]      exits 77 without Godot 3; ADDONS is samples/godot/addons or an unpacked release
#   godot_test.sh --packages               what it needs on Debian
set -euo pipefail
packages="godot3-server"
if [ "${1:-}" = --packages ]; then
  echo "$packages"
  exit 0
fi
source=$1 command=$2 work=$3 addons=${4:-$1/samples/godot/addons}
if ! command -v godot3-server >/dev/null; then
  echo "godot_test: SKIPPED, no godot3-server (Debian: apt-get install $packages)"
  exit 77
fi
fail() { echo "godot_test: $*" >&2; exit 1; }
data=$source/samples/data
rm -rf "$work" && mkdir -p "$work/home" "$work/project/expected"
cd "$work/project"
cp -r "$addons" addons
cp "$source/samples/godot/tests/check.gd" .
cp -r "$source/samples/godot/tests/import" addons
cat > project.godot <<'END'
config_version=4

[application]
config/name="sinew test"

[editor_plugins]
enabled=PoolStringArray( "sinew", "import" )
END
# FILE SOURCE OPTION=VALUE...: a file to import as Sinew Character
character() {
  cp "$2" "$1"
  printf '[remap]\n\nimporter="sinew.character"\ntype="PackedScene"\n\n[params]\n\n' > "$1.import"
  printf '%s\n' "${@:3}" >> "$1.import"
}
character rigged.obj "$data/biped__robed.obj" weights=0
# Godot cuts polygons into triangles when it imports, so the command gets them as well.
awk '$1 == "f" { for (c = 3; c < NF; ++c) print "f", $2, $c, $(c + 1); next } { print }' "$data/bird__winged.obj" > "$work/triangles.obj"
character bound.obj "$work/triangles.obj" weights=1 'skeleton="res://bird.rig.txt"'
character moved.obj "$data/biped__robot.obj" weights=0 'motion/file="res://walk.glb"'
character forced.obj "$data/biped__robot.obj" weights=0 'motion/file="res://small.bvh"' motion/force=true
character unfit.obj "$data/biped__robot.obj" weights=0 'motion/file="res://small.bvh"'
cp "$data/bird__winged.rig.txt" bird.rig.txt
cp "$source/tests/fuzz/corpus/bvh/small.bvh" .
cp "$data/snake__long.obj" '../odd $HOME `id` \ name.obj'
printf 'v 0 0 0\nf 1 2 3\n' > "$work/broken.obj"
character broken.obj "$work/broken.obj" weights=0

# What the command says; "again" has the weights of the first bind to start from, "bare" none.
quietly() { "$command" "$@" > "$work/command.txt" || fail "sinew $*"; }
quietly animate "$data/biped__robed.obj" --motion builtin:walk -o walk.glb
quietly rig rigged.obj -o expected/rigged.rig.txt
quietly bind bound.obj --skeleton bird.rig.txt -o expected/bound.rig.txt
quietly bind bound.obj --skeleton expected/bound.rig.txt -o expected/bound_again.rig.txt
grep -v '^skin' bird.rig.txt > "$work/bare.rig.txt"
quietly bind bound.obj --skeleton "$work/bare.rig.txt" -o expected/bound_bare.rig.txt

export HOME=$work/home SINEW=$command LC_ALL=C.UTF-8
IMPORT_AND_QUIT=1 timeout 120 godot3-server --path . --editor > "$work/import.log" 2>&1 || fail "the editor stopped: $(tail -5 "$work/import.log")"
grep -q '^IMPORT DONE' "$work/import.log" || fail "the import did not end: $(tail -5 "$work/import.log")"
grep -q 'broken.obj: sinew: error: .*broken.obj' "$work/import.log" || fail "a broken file is not named: $(grep -v free_static "$work/import.log")"
grep -q 'unfit.obj: sinew: error: .*small.bvh: does not fit' "$work/import.log" || fail "a motion that does not fit is not named: $(grep -v free_static "$work/import.log")"
for name in rigged bound moved forced; do
  ls .import/$name.obj-*.scn >/dev/null || fail "$name.obj was not imported: $(cat "$work/import.log")"
done
timeout 120 godot3-server --path . --script res://check.gd > "$work/check.log" 2>&1 || fail "check.gd stopped: $(cat "$work/check.log")"
grep -v 'free_static\|memory.cpp' "$work/check.log" | grep 'FAILED\|SCRIPT ERROR\|vertex \|At: res' && fail "see $work/check.log"
grep '^GODOT OK' "$work/check.log" || fail "check.gd did not end: $(cat "$work/check.log")"
nothing_left() { left=$(find "$HOME" -name 'sinew-*'); [ -z "$left" ] || fail "files were left: $left"; }
nothing_left

# The dock in an editor: without a window, where it ends itself (window.gd), then in one.
rm -f ./broken.* ./unfit.*
cp -r "$source/samples/godot/tests/window" addons
sed -i 's/"import" )/"import", "window" )/' project.godot
pressed() { grep '^WINDOW OK' "$work/$1.log" || fail "see $work/$1.log"; nothing_left; }
WINDOW_PICTURE=none timeout 120 godot3-server --path . --editor > "$work/server.log" 2>&1 || [ $? = 137 ] || fail "the editor stopped: $(tail -20 "$work/server.log")"
pressed server
if ! command -v godot3 >/dev/null || ! command -v xvfb-run >/dev/null; then
  echo "godot_test: SKIPPED the window, no godot3 and xvfb-run (Debian: apt-get install godot3 xvfb)"
  exit 0
fi
WINDOW_PICTURE=$work/window timeout 120 xvfb-run -a -s "-screen 0 1280x800x24" godot3 --path . --editor --video-driver GLES2 --audio-driver Dummy \
  --resolution 1280x800 > "$work/window.log" 2>&1 || fail "the window stopped: $(tail -20 "$work/window.log")"
pressed window
