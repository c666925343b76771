#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The same bytes from every compiler, optimisation level and kernel (SINEW_KERNEL of the command): builds the engine with each, hashes every stage on the sample
# characters and compares with tests/golden/expected.txt; names the first stage that differs.
#   golden_test.sh SOURCE_DIR WORK_DIR [--update]     --update rewrites expected.txt from the first build
set -euo pipefail
source_dir=$1 work=$2 update=${3:-}
mkdir -p "$work"
expected=$source_dir/tests/golden/expected.txt
sources=("$source_dir"/engine/src/*.cpp "$source_dir"/engine/src/*/*.cpp "$source_dir/tests/golden/hash_stages.cpp")
characters=("$source_dir"/samples/data/*.obj)
# Kernels of one instruction set need its flags; the same as in engine/CMakeLists.txt.
flags_of() {
  case $1 in
    *_avx2.cpp) echo -mavx2 ;;
    *_avxvnni.cpp) echo -mavx2 -mavxvnni ;;
    *_vnni.cpp) echo -mavx512f -mavx512bw -mavx512dq -mavx512vl -mavx512vnni ;;
  esac
}
build() {  # NAME COMPILER FLAGS...: leaves the hashes in $work/NAME.txt
  local name=$1 compiler=$2
  shift 2
  if ! command -v "$compiler" >/dev/null; then
    echo "golden: $compiler is not installed: run scripts/setup.sh" >&2
    return 1
  fi
  local plain=() source flags
  local all=(-std=c++17 "$@" -ffp-contract=off -I"$source_dir/engine/include" -I"$source_dir/engine/src")
  for source in "${sources[@]}"; do
    flags=$(flags_of "$source")
    if [ -n "$flags" ] && [[ $("$compiler" -dumpmachine) == x86_64-* ]]; then
      # shellcheck disable=SC2086  # several flags
      "$compiler" "${all[@]}" $flags -c "$source" -o "$work/$name-$(basename "$source").o"
      plain+=("$work/$name-$(basename "$source").o")
    else
      plain+=("$source")
    fi
  done
  "$compiler" "${all[@]}" "${plain[@]}" -o "$work/hash-$name"
  local kernel
  for kernel in auto "${kernels[@]}"; do
    rm -f "$work/$name-$kernel.txt"
    "$work/hash-$name" --runs "$kernel" || continue
    "$work/hash-$name" --kernel "$kernel" --model "$source_dir/samples/data/sinew_default.sinew" "${characters[@]}" >"$work/$name-$kernel.txt"
  done
}
compare() {  # NAME-KERNEL
  if [ ! -e "$work/$1.txt" ]; then
    echo "golden: $1 NOT RUN: this processor cannot"
    return 0
  fi
  if cmp -s "$expected" "$work/$1.txt"; then
    echo "golden: $1 ok"
  else
    echo "golden: $1 differs, first at: $(diff "$expected" "$work/$1.txt" | sed -n 's/^[<>] //p' | head -n 1)"
    return 1
  fi
}

kernels=(ref avx2 avxvnni vnni)
names=(gcc-O3 gcc-O0 clang-O3 clang-O0)
pids=()
build gcc-O3 g++ -O3 & pids+=($!)
build gcc-O0 g++ -O0 & pids+=($!)
build clang-O3 clang++ -O3 & pids+=($!)
build clang-O0 clang++ -O0 -DSINEW_NO_INT128 & pids+=($!)  # and the portable 128-bit products
for pid in "${pids[@]}"; do wait "$pid"; done
if [ "$update" = --update ]; then cp "$work/gcc-O3-ref.txt" "$expected"; fi
fails=0
for name in "${names[@]}"; do
  for kernel in auto "${kernels[@]}"; do compare "$name-$kernel" || fails=1; done
done
exit "$fails"
