#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The engine configures alone (no package is looked for), installs, and a 5-line project finds and links it. Every installed header compiles
# alone, in C99 and in C++17.
#   consumer_test.sh SOURCE_DIR WORK_DIR
set -euo pipefail
source_dir=$1 work=$2
rm -rf "$work"
mkdir -p "$work"
cmake -S "$source_dir/engine" -B "$work/engine" -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX="$work/prefix" >"$work/log" 2>&1 ||
  { cat "$work/log"; exit 1; }
if grep -q '_DIR:PATH' "$work/engine/CMakeCache.txt"; then
  echo "the engine looked for a package:"; grep '_DIR:PATH' "$work/engine/CMakeCache.txt"; exit 1
fi
cmake --build "$work/engine" -j "$(nproc)" >>"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
cmake --install "$work/engine" >>"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
strict=(-pedantic-errors -Wall -Wextra -Werror -fsyntax-only "-I$work/prefix/include")
cc -std=c99 "${strict[@]}" "$source_dir/tests/integration/consumer/main.c"
for header in "$work"/prefix/include/sinew/*.h; do
  cc -std=c99 "${strict[@]}" -x c - <<<"#include <sinew/${header##*/}>"
done
for header in "$work"/prefix/include/sinew/*; do
  c++ -std=c++17 "${strict[@]}" -x c++ - <<<"#include <sinew/${header##*/}>"
done
cmake -S "$source_dir/tests/integration/consumer" -B "$work/consumer" -DCMAKE_PREFIX_PATH="$work/prefix" >>"$work/log" 2>&1 ||
  { cat "$work/log"; exit 1; }
cmake --build "$work/consumer" >>"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
"$work/consumer/consumer" | grep -q '^sinew [0-9]'
"$work/consumer/consumer_cpp" | grep -q "^sinew [0-9]"
