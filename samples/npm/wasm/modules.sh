# SPDX-License-Identifier: MIT
# Sourced with $root set: how this package and the page of samples/web build their modules.
. "$root/tests/wasm/emscripten.sh"

step() { echo "$who: $*" >&2; }
# start_build WHO OUTPUT_DIR: makes OUTPUT_DIR and OUTPUT_DIR.build; their full paths are $out and $build from then on. Engine and host are in the folder
# $SINEW_WASM_ENGINE, where several that need them name one, else below $build.
start_build() {
  who=$1
  mkdir -p "$2" "$2.build"
  out=$(cd "$2" && pwd) build=$(cd "$2.build" && pwd)
  export SINEW_WASM_ENGINE=$(realpath -m "${SINEW_WASM_ENGINE:-$build/engine}")
}
# build_host: what page and package have of formats and character, with SIMD in the engine or without. build_engine came first. $host_arguments are cmake's for
# host.cmake then.
build_host() {
  local work=$SINEW_WASM_ENGINE/host
  emcmake cmake -S "$root/samples/npm/wasm/host" -B "$work" -DCMAKE_BUILD_TYPE=Release -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=10 "$engine_archive" \
    >"$work.log" 2>&1 && cmake --build "$work" -j "$(nproc)" --target sinew_host >>"$work.log" 2>&1 || { cat "$work.log" >&2; return 1; }
  host_arguments=("-DSINEW_HOST_ARCHIVE=$work/libsinew_host.a")
}
# build_module NAME SOURCE_DIR ARGUMENT...: one CMake project into $build/NAME; shows its log where that fails.
build_module() {
  local work=$build/$1 source=$2
  shift 2
  emcmake cmake -S "$source" -B "$work" -DCMAKE_BUILD_TYPE=Release "$engine_archive" "$@" >"$work.log" 2>&1 &&
    cmake --build "$work" -j "$(nproc)" >>"$work.log" 2>&1 || { cat "$work.log" >&2; exit 1; }
}
# build_scenes: what reads FBX and COLLADA into $scenes, which page and package share as they share the engine; it has no use for SIMD.
build_scenes() {
  local sources
  step "the readers of FBX and COLLADA to WebAssembly"
  scenes=$SINEW_WASM_ENGINE/scenes
  sources=$("$root/samples/npm/wasm/scenes/assimp.sh") || exit 1
  engine_archive=-DSINEW_ENGINE_ARCHIVE= build="${scenes%/*}" build_module scenes "$root/samples/npm/wasm/scenes" -DSINEW_ASSIMP_SOURCE="$sources" --no-warn-unused-cli
}
