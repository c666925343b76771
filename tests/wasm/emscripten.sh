# SPDX-License-Identifier: MIT
# Sourced: what Debian's emscripten needs to run, node_wasm, which runs what it made, and build_engine.
if ! command -v emcc >/dev/null; then
  echo "wasm: emcc is not installed: run scripts/setup.sh" >&2
  exit 1
fi
# Debian's emscripten looks for its JavaScript tools in the system's modules.
if [ -d /usr/share/nodejs/acorn ]; then export NODE_PATH=/usr/share/nodejs${NODE_PATH:+:$NODE_PATH}; fi
# Programs of emscripten before 3.1.8 take node 18's fetch() for a browser's.
node_wasm() { node --no-experimental-fetch "$@"; }
# build_engine KIND: the engine alone, with SIMD (simd) or without (scalar), in $SINEW_WASM_ENGINE/KIND, where several that need it name one
# such folder. $engine_archive is an argument of cmake for samples/npm/wasm/engine.cmake then, and nothing without the folder.
build_engine() {
  engine_archive=-DSINEW_ENGINE_ARCHIVE=
  [ -n "${SINEW_WASM_ENGINE:-}" ] || return 0
  local sources work=$SINEW_WASM_ENGINE/$1 flags= unity=ON
  sources=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../engine" && pwd)
  # Several sources as one take two fifths of the time, but inline more: 1.8 kB too much for the page's first bind, which has SIMD.
  [ "$1" != simd ] || flags=-msimd128 unity=OFF
  mkdir -p "$work"
  emcmake cmake -S "$sources" -B "$work" -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS="$flags" -DCMAKE_UNITY_BUILD=$unity \
    -DCMAKE_UNITY_BUILD_BATCH_SIZE=12 >"$work.log" 2>&1 &&
    cmake --build "$work" -j "$(nproc)" >>"$work.log" 2>&1 || { cat "$work.log" >&2; return 1; }
  engine_archive+=$work/libsinew.a
}
