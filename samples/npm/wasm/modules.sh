# SPDX-License-Identifier: MIT
# Sourced with $root set: how this package and the page of samples/web build their modules, with and without SIMD.
. "$root/tests/wasm/emscripten.sh"

step() { echo "$who: $*" >&2; }
# start_build WHO OUTPUT_DIR: makes OUTPUT_DIR and OUTPUT_DIR.build; their full paths are $out and $build from then on.
start_build() {
  who=$1
  mkdir -p "$2" "$2.build"
  out=$(cd "$2" && pwd) build=$(cd "$2.build" && pwd)
}
# build_modules SOURCE_DIR OPTION: the CMake project into $build/simd and $build/scalar, with OPTION ON and OFF; shows its log where that fails.
build_modules() {
  for kind in simd scalar; do
    step "engine to WebAssembly, $kind"
    build_engine "$kind" || exit 1
    emcmake cmake -S "$1" -B "$build/$kind" -DCMAKE_BUILD_TYPE=Release -D"$2"="$([ $kind = simd ] && echo ON || echo OFF)" "$engine_archive" >"$build/$kind.log" 2>&1 &&
      cmake --build "$build/$kind" -j "$(nproc)" >>"$build/$kind.log" 2>&1 || { cat "$build/$kind.log" >&2; exit 1; }
  done
}
