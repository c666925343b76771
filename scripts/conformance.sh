#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# One hash on every target: builds the engine for each, binds what tests/golden/set.txt lists and prints a line `TARGET/KERNEL HASH` for
# every kernel that runs there. Native targets and Windows bind the characters of samples/data as well. Exits with 1 when a stage's hash differs from
# tests/golden/conformance.txt (or samples.txt) and names the first, or when a target cannot be built or run.
#   scripts/conformance.sh [--work DIR] [--update] [--packages] [--kernels | --link] [TARGET ...]
# Without targets: all. `ci` stands for the emulated ones that scripts/test.sh runs, `ci-links` for those that it only links, `list` prints all names.
#   --work DIR   builds there [build/conformance]
#   --packages   only prints the Debian packages that the targets need: scripts/setup.sh $(scripts/conformance.sh --packages)
#   --kernels    instead, the tests of the kernels that compare each with the reference over many shapes (aarch64, armhf, Cortex-M4 and up, Windows)
#   --link       instead, only builds and links what would run
#   --update     rewrites both files from the first target; for changes of the output that are meant
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
golden=$root/tests/golden
work=$root/build/conformance
update=no only_packages=no job=check
wanted=()

native=(gcc-O0 gcc-O3 clang-O0 clang-O3 built)  # built: hash_stages of a build that is there already, linked into DIR/built
linux=(aarch64 armhf riscv64 s390x)
cortex=(cortex-m3 cortex-m4 cortex-m7 cortex-m33 cortex-m55)
web=(wasm wasm-simd)
windows=(windows)
# What needs no packages beyond those of the tests. Of the Cortex-M, the one with double precision and the one with the smallest memory at its start
# run; armhf and riscv64 have compilers of their own.
ci=(aarch64 s390x cortex-m7 cortex-m55 wasm wasm-simd windows)
ci_links=(cortex-m3 cortex-m4 cortex-m33)
all=("${native[@]:0:4}" "${linux[@]}" "${cortex[@]}" "${web[@]}" "${windows[@]}")

while [ $# -gt 0 ]; do
  case $1 in
    --work) work=$(realpath -m "$2"); shift ;;
    --update) update=yes ;;
    --kernels) job=check_kernels ;;
    --link) job=check_link ;;
    --packages) only_packages=yes ;;
    list) printf '%s\n' "${all[@]}"; exit 0 ;;
    ci) wanted+=("${ci[@]}") ;;
    ci-links) wanted+=("${ci_links[@]}") ;;
    -h | --help) sed -n '3,13s/^# \{0,1\}//p' "$0"; exit 0 ;;
    -*) echo "conformance: unknown option $1, see --help" >&2; exit 2 ;;
    *) wanted+=("$1") ;;
  esac
  shift
done
[ "${#wanted[@]}" -gt 0 ] || wanted=("${all[@]}")

packages_of() {
  case $1 in
    built) ;;
    gcc-*) echo g++ ;;
    clang-*) echo clang ;;
    aarch64) echo g++-aarch64-linux-gnu qemu-user-static ;;
    armhf) echo g++-arm-linux-gnueabihf qemu-user-static ;;
    riscv64) echo g++-riscv64-linux-gnu qemu-user-static ;;
    s390x) echo g++-s390x-linux-gnu qemu-user-static ;;
    cortex-*) echo gcc-arm-none-eabi libnewlib-arm-none-eabi libstdc++-arm-none-eabi-newlib qemu-system-arm ;;
    wasm*) echo emscripten nodejs ;;
    windows) echo g++-mingw-w64-x86-64-posix wine wine64 ;;
    *) echo "conformance: there is no target $1, \`scripts/conformance.sh list\` prints them" >&2; exit 2 ;;
  esac
}
packages=()
for target in "${wanted[@]}"; do
  list=$(packages_of "$target")  # a line of its own: its failure ends the script
  for package in $list; do
    # A node that did not come from Debian's packages is fine too.
    if [ "$package" = nodejs ] && command -v node >/dev/null; then continue; fi
    case " ${packages[*]-} " in *" $package "*) ;; *) packages+=("$package") ;; esac
  done
done
if [ "$only_packages" = yes ]; then
  echo "${packages[@]}"
  exit 0
fi

# How the target is configured: arguments of cmake.
configuration_of() {
  case $1 in
    gcc-O0) echo "-DCMAKE_CXX_COMPILER=g++ -DCMAKE_CXX_FLAGS_RELEASE=-O0" ;;
    gcc-O3) echo "-DCMAKE_CXX_COMPILER=g++" ;;
    # and the portable 128-bit products
    clang-O0) echo "-DCMAKE_CXX_COMPILER=clang++ -DCMAKE_CXX_FLAGS_RELEASE=-O0 -DCMAKE_CXX_FLAGS=-DSINEW_NO_INT128" ;;
    clang-O3) echo "-DCMAKE_CXX_COMPILER=clang++ -DCMAKE_CXX_FLAGS_RELEASE=-O3" ;;
    aarch64) echo "--toolchain $root/engine/cmake/toolchains/linux.cmake -DSINEW_CROSS=aarch64-linux-gnu" ;;
    armhf) echo "--toolchain $root/engine/cmake/toolchains/linux.cmake -DSINEW_CROSS=arm-linux-gnueabihf" ;;
    riscv64) echo "--toolchain $root/engine/cmake/toolchains/linux.cmake -DSINEW_CROSS=riscv64-linux-gnu" ;;
    s390x) echo "--toolchain $root/engine/cmake/toolchains/linux.cmake -DSINEW_CROSS=s390x-linux-gnu" ;;
    cortex-*) echo "--toolchain $root/engine/cmake/toolchains/cortex-m.cmake -DSINEW_CORTEX_M=${1#cortex-}" ;;
    wasm) echo "-DCMAKE_EXECUTABLE_SUFFIX=.js" ;;
    wasm-simd) echo "-DCMAKE_EXECUTABLE_SUFFIX=.js -DCMAKE_CXX_FLAGS=-msimd128" ;;
    windows) echo "--toolchain $root/engine/cmake/toolchains/windows.cmake" ;;
  esac
}

run() {  # TARGET PROGRAM ARGUMENT...: there, in the folder of the set
  local target=$1 name=$work/$1/$2 board
  shift 2
  cd "$golden"
  case $target in
    aarch64 | riscv64 | s390x) "$(command -v "qemu-$target-static" || command -v "qemu-$target")" "$name" "$@" ;;
    armhf) "$(command -v qemu-arm-static || command -v qemu-arm)" "$name" "$@" ;;
    cortex-*)
      case $target in
        *-m3) board=mps2-an385 ;;
        *-m4) board=mps2-an386 ;;
        *-m7) board=mps2-an500 ;;
        *-m33) board=mps2-an505 ;;
        *-m55) board=mps3-an547 ;;
      esac
      local arguments=arg=test argument
      for argument in "$@"; do arguments+=,arg=$argument; done
      qemu-system-arm -M "$board" -display none -monitor none -serial none \
        -semihosting-config "enable=on,target=native,$arguments" -kernel "$name"
      ;;
    wasm*) node_wasm "$name.js" "$@" ;;
    windows) run_wine "$name.exe" "$@" ;;
    *) "$name" "$@" ;;
  esac
}

build() {  # TARGET PROGRAM...
  [ "$1" != built ] || return 0
  local target=$1 log=$work/$1.log configure=(cmake) arguments
  shift
  read -ra arguments <<<"$(configuration_of "$target") -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=12"
  if [[ $target == wasm* ]]; then
    # shellcheck source=tests/wasm/emscripten.sh
    . "$root/tests/wasm/emscripten.sh"
    configure=(emcmake cmake)
  fi
  if [ "$target" = windows ]; then
    # shellcheck source=tests/support/wine.sh
    . "$root/tests/support/wine.sh" "$work/wine"
  fi
  if ! { "${configure[@]}" -S "$golden" -B "$work/$target" -DCMAKE_BUILD_TYPE=Release "${arguments[@]}" &&
         cmake --build "$work/$target" -j "${SINEW_JOBS:-$(nproc)}" --target "$@"; } >"$log" 2>&1; then
    tail -n 5 "$log" >&2
    echo "$target NOT BUILT, see $log; it needs $(packages_of "$target")" >&2
    return 1
  fi
}

check_kernels() {  # TARGET: the tests of its kernels; one that has none but the reference is left out
  local target=$1 program out ran vector
  build "$target" hash_stages || return 1
  vector=$(run "$target" hash_stages --kernels | grep -v '^ref$' || true)
  if [ -z "$vector" ]; then
    echo "$target has the reference alone"
    return 0
  fi
  local programs=(linear_variants_test aggregate_variants_test softmax_variants_test)
  [ "$vector" = dsp ] || programs+=(heat_variants_test)  # it looks itself whether fronts and boxes are there
  build "$target" "${programs[@]}" || return 1
  for program in "${programs[@]}"; do
    out=$work/$target-$program.txt
    run "$target" "$program" --gtest_color=no >"$out" 2>&1 || { grep -v -i skipped "$out" >&2; return 1; }
    ran=$(grep -c -E '^\[       OK \] (All/|FrontVariants|BoxVariants)' "$out" || true)
    if [ "$vector" = dsp ] && [ "$program" != linear_variants_test ]; then
      [ "$ran" = 0 ] || { echo "$target: $program ran $ran cases for dsp, which has a linear layer alone" >&2; return 1; }
      echo "$target/dsp $program: no cases, dsp has a linear layer of its own alone and takes the reference's rest"
      continue
    fi
    if [ "$ran" -lt 4 ]; then
      echo "$target: $program ran $ran cases, expected 4 or more" >&2
      return 1
    fi
    echo "$target/${vector//$'\n'/,} $program: $ran cases equal the reference"
  done
}

check_link() {  # TARGET
  build "$1" hash_stages || return 1
  echo "$1 links"
}

check() {  # TARGET: builds it, then a line for each kernel it runs
  local target=$1 log=$work/$1.log kernel label out fails=0
  build "$target" hash_stages || return 1
  for kernel in $(run "$target" hash_stages --kernels); do
    label=$target/$kernel
    out=$work/$target-$kernel.txt
    if ! run "$target" hash_stages --kernel "$kernel" --set set.txt >"$out" 2>>"$log"; then
      tail -n 2 "$log" >&2
      echo "$label FAILED behind $(tail -n 1 "$out")" >&2
      fails=1
      continue
    fi
    if [ "$update" = yes ]; then cp "$out" "$golden/conformance.txt"; fi
    echo "$label $(awk '$1 == "set" { print $3 }' "$out")"
    compare "$label" conformance.txt "$out" || fails=1
    if [[ " ${native[*]} ${windows[*]} " == *" $target "* ]]; then
      # Larger ones, on the grid that the command uses: more memory than a microcontroller has.
      run "$target" hash_stages --kernel "$kernel" --model "$root/samples/data/sinew_default.sinew" "$root"/samples/data/*.obj >"$out.samples" 2>>"$log" ||
        { tail -n 2 "$log" >&2; echo "$label FAILED behind $(tail -n 1 "$out.samples")" >&2; fails=1; continue; }
      if [ "$update" = yes ]; then cp "$out.samples" "$golden/samples.txt"; fi
      compare "$label" samples.txt "$out.samples" || fails=1
    fi
    update=no
  done
  return "$fails"
}

compare() {  # LABEL EXPECTED FILE
  cmp -s "$golden/$2" "$3" && return 0
  echo "$1 differs from tests/golden/$2, first at: $(diff "$golden/$2" "$3" | sed -n 's/^[<>] //p' | head -n 1)" >&2
  return 1
}

fails=0
mkdir -p "$work"
if [ "$update" = yes ]; then
  for target in "${wanted[@]}"; do "$job" "$target" || fails=1; done
else
  # Two at a time: while one runs on its emulator the other compiles. Each tells what it has to when its turn comes.
  declare -A started=()
  for target in "${wanted[@]}"; do
    [ -z "${started[$target]:-}" ] || continue
    while [ "$(jobs -rp | wc -l)" -ge 2 ]; do wait -n || true; done
    { "$job" "$target" || exit 1; } >"$work/$target.told" 2>"$work/$target.complaints" &
    started[$target]=$!
  done
  for target in "${wanted[@]}"; do
    [ -n "${started[$target]}" ] || continue
    wait "${started[$target]}" || fails=1
    cat "$work/$target.told"
    cat "$work/$target.complaints" >&2
    started[$target]=
  done
fi
[ "$fails" = 0 ] || echo "conformance: FAILED" >&2
exit "$fails"
