# SPDX-License-Identifier: MIT
# Sourced by build.sh: splits a module in what binds, what makes skeletons, and the rest.
# split_module KIND OUT_DIR: $build/modules/KIND/sinew_web.wasm into OUT_DIR/sinew-KIND.wasm, -rig.wasm and -rest.wasm, each packed.
split_module() {
  local kind=$1 work=$build/modules/$1
  split_features=(--enable-mutable-globals --enable-sign-ext --enable-bulk-memory --enable-nontrapping-float-to-int --enable-exception-handling)
  [ "$kind" = scalar ] || split_features+=(--enable-simd)
  split_by bare "$work/sinew_web.wasm" "$work/two.wasm" "$work/rest.wasm"
  split_by skinned "$work/two.wasm" "$work/first.wasm" "$work/rig.wasm"
  pack_code "$work/first.wasm" "$2/sinew-$kind.wasm"
  for part in rig rest; do pack_code "$work/$part.wasm" "$2/sinew-$kind-$part.wasm"; done
}
# split_by CHARACTERS MODULE USED OTHERS: what first_bind.mjs runs of a module, and its other functions, which may be called all the same.
split_by() {
  wasm-split --instrument "${split_features[@]}" "$2" -o "$work/instrumented.wasm"
  node "$here/wasm/first_bind.mjs" "$1" "$work/sinew_web.mjs" "$work/instrumented.wasm" "$root/samples/data" "$work/$1.profile"
  wasm-split --split "${split_features[@]}" "$2" --profile="$work/$1.profile" -o1 "$3" -o2 "$4"
}
# pack_code FILE NAME, pack_model FILE NAME: into NAME.lzma, which src/lzma.js unpacks. lc, lp, pb: what is best for code, and for words of 16 bits.
pack_code() { xz --format=lzma --lzma1=preset=9e,lc=4,pb=0 -c "$1" >"$2.lzma"; }
pack_model() { xz --format=lzma --lzma1=preset=9e,lc=0,lp=1,pb=1 -c "$1" >"$2.lzma"; }
