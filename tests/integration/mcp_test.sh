#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# `sinew serve --mcp` by the protocol's own client.
#   mcp_test.sh NODE SINEW SOURCE WORK      exits 77 where the client is not installed
set -euo pipefail
node=$1 sinew=$2 source=$3 work=$4
if [ ! -d "$source/tests/support/mcp/node_modules/@modelcontextprotocol/sdk" ]; then
  echo "mcp_test: SKIPPED, no client (npm ci --prefix tests/support/mcp)"
  exit 77
fi
mkdir -p "$work"
"$node" "$source/tests/support/mcp/client.mjs" "$sinew" "$source/samples/data/biped__robot.obj" "$work"
