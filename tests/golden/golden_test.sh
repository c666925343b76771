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
fails=0
build() {  # NAME COMPILER FLAGS...
  local name=$1 compiler=$2
  shift 2
  if ! command -v "$compiler" >/dev/null; then
    echo "golden: $compiler is not installed: run scripts/setup.sh" >&2
    exit 1
  fi
  "$compiler" -std=c++17 "$@" -ffp-contract=off -I"$source_dir/engine/include" -I"$source_dir/engine/src" "${sources[@]}" -o "$work/hash-$name"
  "$work/hash-$name" --model "$source_dir/samples/data/sinew_default.sinew" "${characters[@]}" >"$work/$name.txt"
  if [ "$update" = --update ]; then
    cp "$work/$name.txt" "$expected"
    update=
  fi
  if cmp -s "$expected" "$work/$name.txt"; then
    echo "golden: $name ok"
  else
    echo "golden: $name differs, first at: $(diff "$expected" "$work/$name.txt" | sed -n 's/^[<>] //p' | head -n 1)"
    return 1
  fi
}
build gcc-O3 g++ -O3 &
pids=($!)
if [ "$update" = --update ]; then wait; update=; fi
build gcc-O0 g++ -O0 & pids+=($!)
wait "${pids[@]:0:1}" || fails=1
wait "${pids[1]}" || fails=1
build clang-O3 clang++ -O3 & pids=($!)
build clang-O0 clang++ -O0 -DSINEW_NO_INT128 & pids+=($!)
for pid in "${pids[@]}"; do wait "$pid" || fails=1; done
exit "$fails"
