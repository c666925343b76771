# SPDX-License-Identifier: MIT
# Sourced: what Debian's emscripten needs to run, and node_wasm, which runs what it made.
if ! command -v emcc >/dev/null; then
  echo "wasm: emcc is not installed: run scripts/setup.sh" >&2
  exit 1
fi
# Debian's emscripten looks for its JavaScript tools in the system's modules.
if [ -d /usr/share/nodejs/acorn ]; then export NODE_PATH=/usr/share/nodejs${NODE_PATH:+:$NODE_PATH}; fi
# Programs of emscripten before 3.1.8 take node 18's fetch() for a browser's.
node_wasm() { node --no-experimental-fetch "$@"; }
