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
# pack_code FILE NAME: into NAME.zlib, which src/packed.js unpacks.
pack_code() { zopfli --zlib -c "$1" >"$2.zlib"; }
# pack_model FILE NAME: the same of the low bytes of all words of 16 bits, then the high ones, which is a tenth smaller; src/models.js puts them together.
pack_model() {
  node -e 'const bytes = fs.readFileSync(0); process.stdout.write(Buffer.concat([0, 1].map((part) => bytes.filter((_, i) => i % 2 === part))))' <"$1" >"$build/planes"
  pack_code "$build/planes" "$2"
}
