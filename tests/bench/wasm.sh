#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# How much slower WebAssembly's SIMD is under node than native AVX2: the linear layer and a whole bind, several rounds in turn, medians.
#   wasm.sh NATIVE_BUILD_DIR WASM_BUILD_DIR [ROUNDS]      NATIVE_BUILD_DIR has sinew_bench_layer and sinew_bench_bind
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd) native=$1/tests/bench wasm=$2 rounds=${3:-3}
. "$here/../wasm/emscripten.sh"
"$here/../wasm/build.sh" "$wasm" layer_bench bind_bench
rows=$(mktemp)
trap 'rm -f "$rows"' EXIT
for _ in $(seq "$rounds"); do
  "$native/sinew_bench_layer" --kernel avx2 >>"$rows"
  node_wasm "$wasm/layer_bench.js" --kernel simd128 >>"$rows"
  "$native/sinew_bench_bind" --kernel avx2 --repeats 5 10000 >>"$rows"
  node_wasm "$wasm/bind_bench.js" --kernel simd128 --repeats 5 10000 >>"$rows"
done
python3 - "$rows" <<'EOF'
import csv, statistics, sys
times, hashes, head = {}, {}, []
for row in csv.reader(open(sys.argv[1])):
    if row[0] == "machine":
        head = row
        continue
    r = dict(zip(head, row))
    what = r.get("shape") or f"bind {r['vertices']} {r['stage']}"
    times.setdefault(what, {}).setdefault(r["kernel"], []).append(float(r["median_ms"]))
    hashes.setdefault(what, set()).add(r["hash"])
print("what,avx2_ms,simd128_ms,ratio,same_hash")
for what, t in times.items():
    if len(t) < 2 or statistics.median(t["avx2"]) < 0.005:  # natively with threads; a stage that had nothing to do
        continue
    a, w = (statistics.median(t[k]) for k in ("avx2", "simd128"))
    print(f"{what},{a:.3f},{w:.3f},{w / a:.2f},{'yes' if len(hashes[what]) == 1 else 'NO'}")
EOF
