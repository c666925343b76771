# SPDX-License-Identifier: MIT
# Sourced by build.sh: splits a module in what the first bind needs and the rest.
# split_module KIND OUT_DIR: $build/KIND/sinew_web.wasm into OUT_DIR/sinew-KIND.wasm and OUT_DIR/sinew-KIND-rest.wasm.
split_module() {
  local kind=$1 work=$build/$1 features=(--enable-mutable-globals --enable-sign-ext --enable-bulk-memory --enable-nontrapping-float-to-int)
  [ "$kind" = scalar ] || features+=(--enable-simd)
  wasm-split --instrument "${features[@]}" "$work/sinew_web.wasm" -o "$work/instrumented.wasm"
  node "$here/wasm/first_bind.mjs" "$work/sinew_web.mjs" "$work/instrumented.wasm" "$root/samples/data" "$work/first_bind.profile"
  wasm-split --split "${features[@]}" "$work/sinew_web.wasm" --profile="$work/first_bind.profile" -o1 "$2/sinew-$kind.wasm" -o2 "$2/sinew-$kind-rest.wasm"
}
