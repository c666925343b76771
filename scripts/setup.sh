#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installs what building and testing need on Debian or Ubuntu, and the packages named as arguments; does nothing for what is there. Other
# systems: vcpkg.json.
set -euo pipefail
cd "$(dirname "$0")/.."

packages=(g++ clang cmake make binutils libeigen3-dev libspectra-dev libopenmesh-dev libtinyobjloader-dev libtinygltf-dev libcereal-dev
          libcli11-dev nlohmann-json3-dev libgtest-dev libbenchmark-dev librapidcheck-dev libpng-dev zlib1g-dev clang-format python3-numpy
          libopenmpi-dev openmpi-bin dpkg-dev file libmeshoptimizer-dev libdraco-dev libassimp-dev libjpeg-dev)
# A node that did not come from Debian's packages is fine too.
command -v node >/dev/null 2>&1 || packages+=(nodejs)
command -v npm >/dev/null 2>&1 || packages+=(npm)
command -v pkg-config >/dev/null 2>&1 || packages+=(pkg-config)
packages+=("$@")

missing=()
for package in "${packages[@]}"; do
  dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'install ok installed' || missing+=("$package")
done
if [ "${#missing[@]}" -gt 0 ]; then
  if ! command -v apt-get >/dev/null 2>&1; then
    echo "setup: this script knows apt-get only; install these yourself: ${missing[*]}" >&2
    exit 1
  fi
  echo "setup: installing ${missing[*]}"
  as_root=()
  [ "$(id -u)" = 0 ] || as_root=(sudo)
  "${as_root[@]}" apt-get update -qq
  DEBIAN_FRONTEND=noninteractive "${as_root[@]}" apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
fi

# The Khronos glTF validator, for the tests; pinned by package-lock.json.
if [ ! -d tests/support/node/node_modules/gltf-validator ]; then
  echo "setup: installing gltf-validator"
  npm ci --silent --no-audit --no-fund --prefix tests/support/node
fi
