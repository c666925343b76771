#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The kernels' tests under node: WebAssembly's SIMD equals the reference, and it did run.
#   kernels_test.sh BUILD_DIR
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd) build=$1
. "$here/emscripten.sh"
"$here/build.sh" "$build" linear_variants_test aggregate_variants_test softmax_variants_test heat_variants_test
for program in linear_variants_test aggregate_variants_test softmax_variants_test heat_variants_test; do
  if ! node_wasm "$build/$program.js" --gtest_color=no >"$build/$program.txt" 2>&1; then
    grep -v SKIPPED "$build/$program.txt" >&2
    exit 1
  fi
  if [ "$program" = heat_variants_test ]; then  # it looks itself whether simd128 is there
    echo "wasm: $program: simd128 equals the reference"
    continue
  fi
  ran=$(grep -c '^\[       OK \].*/simd128' "$build/$program.txt" || true)
  if [ "$ran" -lt 4 ]; then
    echo "wasm: $program ran $ran cases of the kernels simd128, expected 4 or more" >&2
    exit 1
  fi
  echo "wasm: $program: $ran cases of simd128 equal the reference"
done
