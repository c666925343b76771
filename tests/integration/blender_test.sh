#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The add-on of samples/blender: its zip, installed as a user does it, tested without a window and in one.
#   blender_test.sh SOURCE LIBRARY COMMAND WORK      exits 77 without Blender
set -euo pipefail
source=$1 library=$2 command=$3 work=$4
if ! command -v blender >/dev/null; then
  echo "blender_test: SKIPPED, no blender (Debian: apt-get install blender xvfb)"
  exit 77
fi
rm -rf "$work" && mkdir -p "$work/config" "$work/scripts/addons" "$work/screenshots"
zip=$(SINEW_LIBRARY=$library "$source/samples/blender/build.sh" "$work")
export BLENDER_USER_CONFIG=$work/config BLENDER_USER_SCRIPTS=$work/scripts
unset SINEW_LIBRARY SINEW_MODELS PYTHONPATH
for test in "$source"/samples/blender/tests/test_*.py; do
  echo "== $(basename "$test")"
  blender -b --factory-startup --python-exit-code 1 --python "$test" -- "$zip" "$source" "$command"
done
if ! command -v xvfb-run >/dev/null; then
  echo "blender_test: SKIPPED the window, no xvfb-run (Debian: apt-get install xvfb)"
  exit 0
fi
echo "== window.py"
timeout 500 xvfb-run -a -s "-screen 0 1280x800x24" blender --factory-startup --enable-event-simulate --window-geometry 0 0 1280 800 \
  --python "$source/samples/blender/tests/window.py" -- "$zip" "$source" "$command" "$work/screenshots" | tee "$work/window.log"
grep -q '^WINDOW OK' "$work/window.log"
