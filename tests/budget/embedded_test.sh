#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# samples/embedded on an emulated Cortex-M7: the hash that this machine prints, inside its memory; and the engine's budgets there: size of its
# code, deepest stack, products per instruction of the linear layer, no symbol of an allocator, unwinder or libm.
#   embedded_test.sh SOURCE_DIR WORK_DIR
set -euo pipefail
source_dir=$1 work=$2
toolchain=$source_dir/engine/cmake/toolchains/cortex-m.cmake
mkdir -p "$work"
fails=0
fail() {
  echo "embedded: $*" >&2
  fails=1
}
quietly() { "$@" >"$work/build.log" 2>&1 || { tail -n 20 "$work/build.log" >&2; exit 1; }; }
on_board() {  # ELF [ARGUMENT...]
  local elf=$1 arguments=arg=test argument
  shift
  for argument in "$@"; do arguments+=,arg=$argument; done
  timeout 300 qemu-system-arm -M mps2-an500 -icount shift=6 -display none -monitor none -serial none \
    -semihosting-config "enable=on,target=native,$arguments" -kernel "$elf"
}
at_most() {  # WHAT VALUE LIMIT
  echo "$1: $2 of $3"
  [ "$2" -le "$3" ] || fail "$1 is $2, the budget is $3"
}

quietly cmake -S "$source_dir/samples/embedded" -B "$work/m7" --toolchain "$toolchain" -DSINEW_CORTEX_M=m7
quietly cmake --build "$work/m7" -j "$(nproc)"
quietly cmake -S "$source_dir/samples/embedded" -B "$work/host"
quietly cmake --build "$work/host" -j "$(nproc)"
for image in bind_1m bind_256k; do
  on_board "$work/m7/$image.elf" >"$work/$image.txt" 2>&1 || fail "$image ended with an error"
  "$work/host/$image" >"$work/$image.host.txt"
  sed 's/^/  /' "$work/$image.txt"
  grep -q '^kernels: dsp$' "$work/$image.txt" || fail "$image did not run the DSP kernels"
  hash=$(sed -n 's/^hash: //p' "$work/$image.txt")
  if [ -z "$hash" ] || [ "$hash" != "$(sed -n 's/^hash: //p' "$work/$image.host.txt")" ]; then
    fail "$image binds otherwise than on this machine"
  fi
  arm-none-eabi-nm "$work/m7/$image.elf" >"$work/$image.symbols"
  if grep -E ' _?(malloc|free|calloc|realloc|_sbrk|_malloc_r|printf|__cxa_[a-z_]*|_Unwind_[A-Za-z]*|_Znwj|_ZdlPv|sqrtf?|expf?|logf?|powf?)$' \
    "$work/$image.symbols"; then
    fail "$image links symbols of an allocator, unwinder or libm"
  fi
done

# The smaller image less what is not the engine's: program, board, model and character, and the C library's memory routines. What is left is
# the engine's functions and constants and the compiler's 64-bit division.
sum() { awk '{ total += $1 } END { print total + 0 }'; }
all=$(arm-none-eabi-size "$work/m7/bind_256k.elf" | awk 'END { print $1 }')
sample=$(find "$work/m7/CMakeFiles/bind_256k.dir" -name '*.obj' -exec arm-none-eabi-size {} + | awk 'NR > 1 && !/TOTALS/' | sum)
library=$(arm-none-eabi-nm -S "$work/m7/bind_256k.elf" | awk '$4 ~ /^mem(cpy|move|set)$/ { print "0x" $2 }' | xargs printf '%d\n' | sum)
[ "$sample" -gt 6000 ] && [ "$library" -gt 100 ] || fail "what is not the engine's was not found in bind_256k"
at_most "engine's text on Cortex-M7, bytes" "$((all - sample - library))" 66560

quietly cmake -S "$source_dir/tests/golden" -B "$work/budget" --toolchain "$toolchain" -DSINEW_CORTEX_M=m7 -DCMAKE_BUILD_TYPE=Release
quietly cmake --build "$work/budget" -j "$(nproc)" --target device_budget
on_board "$work/budget/device_budget" "$source_dir/samples/data/sinew_default.sinew" "$source_dir/tests/golden/models" >"$work/budget.txt" ||
  fail "device_budget ended with an error"
sed 's/^/  /' "$work/budget.txt"
at_most "deepest stack on Cortex-M7, bytes" "$(sed -n 's/^stack_bytes //p' "$work/budget.txt")" 12288
checked=0
while read -r name products; do
  checked=$((checked + 1))
  [ "$products" -ge 700 ] || fail "$name is $products, expected 700 or more"
done < <(grep '^linear_dsp_' "$work/budget.txt")
[ "$checked" = 3 ] || fail "expected three shapes of the linear layer, found $checked"
exit "$fails"
