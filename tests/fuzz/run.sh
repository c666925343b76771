#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Fuzzes one target (obj, rig, glb, bvh, numpy, vmd, picture, model, bind, skeleton, motion, map, names, transfer or deform) until it has used CPU_SECONDS of processor time, on a growing corpus
# beside the build; stops with 1 at the first finding. Prints how many inputs were run.
#   tests/fuzz/run.sh BUILD_DIR TARGET [CPU_SECONDS]
set -euo pipefail
[ $# -ge 2 ] || { echo "usage: tests/fuzz/run.sh BUILD_DIR obj|rig|glb|bvh|numpy|vmd|picture|model|bind|skeleton|motion|map|names|transfer|deform [CPU_SECONDS]" >&2; exit 2; }
build=$1 target=$2 seconds=${3:-600}
here=$(cd "$(dirname "$0")" && pwd)
program=$build/tests/sinew_fuzz_$target
[ -x "$program" ] || { echo "fuzz: $program is not built: cmake --preset fuzz && cmake --build --preset fuzz --target sinew_fuzz_$target" >&2; exit 1; }
work=$build/fuzz/$target
log=$work/log.txt
mkdir -p "$work/corpus"
# Readers want files; one in memory is faster than one on disk.
[ -d /dev/shm ] && export TMPDIR=${TMPDIR:-/dev/shm}
export ASAN_OPTIONS=${ASAN_OPTIONS:-detect_leaks=0} UBSAN_OPTIONS=${UBSAN_OPTIONS:-print_stacktrace=1}
dictionary=()
[ -e "$here/$target.dict" ] && dictionary=(-dict="$here/$target.dict")
"$program" "$work/corpus" "$here/corpus/$target" "${dictionary[@]}" -max_len=4096 -timeout=60 -rss_limit_mb=2048 \
  -print_final_stats=1 -artifact_prefix="$work/" >"$log" 2>&1 &
pid=$!
used=0
while now=$(ps -o cputimes= -p "$pid"); do
  used=$((now))
  if [ "$used" -ge "$seconds" ]; then
    kill -USR1 "$pid" 2>/dev/null || true  # libFuzzer ends after the input at hand
    break
  fi
  sleep 2
done
if ! wait "$pid"; then
  echo "fuzz: $target: a finding after $used seconds of processor time, see $log" >&2
  grep -E 'ERROR|broken property|SUMMARY|what\(\)|Test unit' "$log" >&2 || tail -5 "$log" >&2
  exit 1
fi
echo "fuzz: $target: $(sed -n 's/^stat::number_of_executed_units: *//p' "$log") inputs in $used seconds of processor time, no finding"
