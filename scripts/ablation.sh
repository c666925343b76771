#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# One cross-family run per file of trainer/configs/ablation, then the table of trainer/configs/RESULTS.md.
set -euo pipefail
if [ $# -lt 3 ]; then
  echo "usage: scripts/ablation.sh TRAIN_DIR VAL_DIR OUT_DIR [NAME ...]   (NAME of trainer/configs/ablation; all without)" >&2
  echo "Runs that are in OUT_DIR already are not run again. SINEW names the command [build/release/sinew]." >&2
  exit 2
fi
root=$(cd "$(dirname "$0")/.." && pwd)
sinew=${SINEW:-$root/build/release/sinew}
train=$1 val=$2 out=$3
shift 3
if [ $# -eq 0 ]; then
  for file in "$root"/trainer/configs/ablation/*.json; do set -- "$@" "$(basename "$file" .json)"; done
fi
mkdir -p "$out"
folders=()
for name in "$@"; do
  "$sinew" crossval "$train" --val "$val" --groups "$root/trainer/configs/groups.json" \
    --config "$root/trainer/configs/ablation/$name.json" --cache "$out/cache" --label "$name" -o "$out/$name" --resume > "$out/$name.log"
  folders+=("$out/$name")
done
"$sinew" crossval --compare "${folders[@]}"
