#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The command by programs of other makers, which npm has: tests/support/FOLDER/TEST.mjs SINEW SOURCE WORK.
#   npm_tools_test.sh FOLDER PACKAGE TEST NODE SINEW SOURCE WORK      exits 77 where the folder's packages are not installed, which PACKAGE tells
set -euo pipefail
folder=$1 package=$2 test=$3 node=$4 sinew=$5 source=$6 work=$7
if [ ! -d "$source/tests/support/$folder/node_modules/$package" ]; then
  echo "${folder}_test: SKIPPED, no packages (npm ci --prefix tests/support/$folder)"
  exit 77
fi
mkdir -p "$work"
"$node" "$source/tests/support/$folder/$test.mjs" "$sinew" "$source" "$work"
