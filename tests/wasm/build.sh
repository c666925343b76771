#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds the programs of tests/wasm for node.
#   build.sh BUILD_DIR [TARGET...]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd) build=$1
shift
. "$here/emscripten.sh"
commit=$(git -C "$here" describe --always --dirty --abbrev=7 2>/dev/null || echo unknown)
build_engine simd
emcmake cmake -S "$here" -B "$build" -DCMAKE_BUILD_TYPE=Release "$engine_archive" -DSINEW_BENCH_COMMIT="$commit" \
  -DSINEW_GTEST_SOURCE="${SINEW_GTEST_SOURCE:-/usr/src/googletest/googletest}" >"$build.log" 2>&1 || { cat "$build.log" >&2; exit 1; }
cmake --build "$build" -j "$(nproc)" ${@/#/--target } >"$build.log" 2>&1 || { cat "$build.log" >&2; exit 1; }
