#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Files of the command in loaders of other makers.
#   three_test.sh usd|vrm NODE SINEW SOURCE WORK      exits 77 where the packages are not installed
set -euo pipefail
test=$1 node=$2 sinew=$3 source=$4 work=$5
if [ ! -d "$source/tests/support/three/node_modules/three" ]; then
  echo "three_test: SKIPPED, no packages (npm ci --prefix tests/support/three)"
  exit 77
fi
mkdir -p "$work"
"$node" "$source/tests/support/three/$test.mjs" "$sinew" "$source" "$work"
