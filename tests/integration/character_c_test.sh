#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A C99 program with libsinew_character writes the command's bytes; the library exports sinew_* and nothing else.
#   character_c_test.sh PROGRAM LIBRARY SINEW SOURCE_DIR WORK_DIR
set -euo pipefail
program=$1 library=$2 sinew=$3 source_dir=$4 work=$5
rm -rf "$work"
mkdir -p "$work"
cd "$work"
cp "$source_dir"/samples/data/snake__long.* .
"$program" snake__long.obj ours.glb
"$sinew" bind snake__long.obj --skeleton snake__long.rig.txt -o command.glb >log
cmp ours.glb command.glb
others=$(nm -D --defined-only "$library" | awk '$3 !~ /^sinew_/ { print $3 }')
[ -z "$others" ] || { echo "exported beside sinew_*: $others"; exit 1; }
for name in sinew_character_bind sinew_bind sinew_version; do
  nm -D --defined-only "$library" | grep -w "$name" >/dev/null || { echo "not exported: $name"; exit 1; }
done
