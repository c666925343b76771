#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# `sinew serve --mcp` by the protocol's own client; outputs of --json against their schemas.
#   mcp_test.sh client|schemas NODE SINEW SOURCE WORK      exits 77 where the packages are not installed
set -euo pipefail
test=$1 node=$2 sinew=$3 source=$4 work=$5
if [ ! -d "$source/tests/support/mcp/node_modules/@modelcontextprotocol/sdk" ]; then
  echo "mcp_test: SKIPPED, no packages (npm ci --prefix tests/support/mcp)"
  exit 77
fi
mkdir -p "$work"
"$node" "$source/tests/support/mcp/$test.mjs" "$sinew" "$source" "$work"
