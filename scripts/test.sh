#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installs what is missing, builds with warnings as errors, and runs every test; then the engine on emulated processors and the tests of engine,
# formats and quant again under AddressSanitizer and UndefinedBehaviorSanitizer. `scripts/test.sh --quick` is for a developer before a commit: the
# build, and the tests that need no other compiler, browser or package.
set -euo pipefail
cd "$(dirname "$0")/.."
if [ "$#" -gt 1 ] || { [ "$#" = 1 ] && [ "$1" != --quick ]; }; then
  echo "test: expected --quick or nothing, found: $*" >&2
  exit 2
fi
# shellcheck disable=SC2046  # several packages
scripts/setup.sh ccache $(scripts/conformance.sh --packages ci) $(samples/web/build.sh --packages) $(samples/python/build.sh --packages) \
  $(tests/integration/csharp_test.sh --packages) $(scripts/declarations.py --packages) \
  $(apt-cache pkgnames libclang-rt-dev 2>/dev/null | grep -x libclang-rt-dev || true) $(apt-cache pkgnames godot3-server 2>/dev/null | grep -x godot3-server || true)
# The client of the Model Context Protocol, pinned by its package-lock.json.
[ -d tests/support/mcp/node_modules/@modelcontextprotocol ] || npm ci --silent --no-audit --no-fund --prefix tests/support/mcp
[ -d tests/support/three/node_modules/three ] || npm ci --silent --no-audit --no-fund --prefix tests/support/three
jobs=$(nproc)

# The engine is compiled some twenty times, for targets and for those who install it, and often with the same options. Warnings are no part of an object
# file: what the release build, the first one, took with warnings as errors is the same for the others. What is precompiled is not cached.
if [ -z "${CMAKE_CXX_COMPILER_LAUNCHER:-}" ]; then
  export CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache
  export CCACHE_DIR=$PWD/build/ccache CCACHE_DEPEND=1 CCACHE_IGNOREOPTIONS='-W*' CCACHE_MAXSIZE=3G
fi

# phase NAME COMMAND...: the end lists the seconds of each, also where one fails.
seconds=()
phase() {
  local name=$1 begin=$SECONDS
  shift
  echo "== $name"
  running=$name running_since=$begin
  "$@"
  running=
  seconds+=("$(printf '%5d s  %s' $((SECONDS - begin)) "$name")")
}
tell_seconds() {
  [ -z "${running:-}" ] || seconds+=("$(printf '%5d s  %s, FAILED' $((SECONDS - running_since)) "$running")")
  [ "${#seconds[@]}" -eq 0 ] || printf '%s\n' "${seconds[@]}" "$(printf '%5d s  in all, %d processors' "$SECONDS" "$jobs")"
}
trap tell_seconds EXIT

build() {  # PRESET ARGUMENT_OF_CMAKE...
  cmake --preset "$@" -DSINEW_PRECOMPILE=ON >/dev/null
  cmake --build --preset "$1" -j "$jobs"
}

# clang needs two thirds of GCC's time for code with sanitizers, where its runtime is installed.
with_clang() {
  if echo 'int main() {}' | clang++ -fsanitize=address,undefined -x c++ - -o "$(mktemp)" 2>/dev/null; then
    grep -q '^CMAKE_CXX_COMPILER:.*clang++' build/sanitize/CMakeCache.txt 2>/dev/null || rm -rf build/sanitize  # of another compiler
    echo -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++
  fi
}

phase format scripts/format.sh --check
phase "release build" build ci -DSINEW_UNITY=ON  # the engine each source by itself, as those who add it to a program compile it
if [ "${1:-}" = --quick ]; then
  phase "quick tests" ctest --test-dir build/release --output-on-failure -j "$jobs" -LE tools
else
  phase "release tests" ctest --test-dir build/release --output-on-failure -j "$jobs"
  # Native targets were tests above.
  phase conformance scripts/conformance.sh ci
  phase "conformance, linked only" scripts/conformance.sh --link ci-links
  phase "conformance of kernels" scripts/conformance.sh --kernels aarch64 cortex-m7
  # Several sources of the engine as one, here and in conformance. Engine, formats and quant: what reads files from strangers. The trainer under sanitizers is `cmake --preset dev` by hand.
  # shellcheck disable=SC2046  # two arguments
  phase "sanitizer build" build sanitize -DSINEW_UNITY=ALL $(with_clang)
  # Without the data folder, which is large, and comparisons with solvers of Eigen, which are slow unoptimized (label reference): those cases ran above.
  phase "sanitizer tests" env SINEW_SHARED_DIR=none ctest --test-dir build/sanitize --output-on-failure -j "$jobs" -LE 'slow|tools'
fi
echo "all tests passed"
