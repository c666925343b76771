#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The same bytes from every compiler and optimisation level: builds the engine with each, hashes every stage on the sample
# characters and compares with tests/golden/expected.txt; names the first stage that differs.
#   golden_test.sh SOURCE_DIR WORK_DIR [--update]     --update rewrites expected.txt from the first build
set -euo pipefail
source_dir=$1 work=$2 update=${3:-}
mkdir -p "$work"
expected=$source_dir/tests/golden/expected.txt
sources=("$source_dir"/engine/src/*.cpp "$source_dir"/engine/src/*/*.cpp "$source_dir/tests/golden/hash_stages.cpp")
characters=("$source_dir"/samples/data/*.obj)
build() {  # NAME COMPILER FLAGS...: leaves the hashes in $work/NAME.txt
  local name=$1 compiler=$2
  shift 2
  if ! command -v "$compiler" >/dev/null; then
    echo "golden: $compiler is not installed: run scripts/setup.sh" >&2
    return 1
  fi
  "$compiler" -std=c++17 "$@" -ffp-contract=off -I"$source_dir/engine/include" -I"$source_dir/engine/src" "${sources[@]}" -o "$work/hash-$name"
  "$work/hash-$name" --model "$source_dir/samples/data/sinew_default.sinew" "${characters[@]}" >"$work/$name.txt"
}
compare() {  # NAME
  if cmp -s "$expected" "$work/$1.txt"; then
    echo "golden: $1 ok"
  else
    echo "golden: $1 differs, first at: $(diff "$expected" "$work/$1.txt" | sed -n 's/^[<>] //p' | head -n 1)"
    return 1
  fi
}

names=(gcc-O3 gcc-O0 clang-O3 clang-O0)
pids=()
build gcc-O3 g++ -O3 & pids+=($!)
build gcc-O0 g++ -O0 & pids+=($!)
build clang-O3 clang++ -O3 & pids+=($!)
build clang-O0 clang++ -O0 -DSINEW_NO_INT128 & pids+=($!)  # and the portable 128-bit products
for pid in "${pids[@]}"; do wait "$pid"; done
if [ "$update" = --update ]; then cp "$work/gcc-O3.txt" "$expected"; fi
fails=0
for name in "${names[@]}"; do compare "$name" || fails=1; done
exit "$fails"
