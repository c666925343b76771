#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Prints the folder of Assimp's sources, in the version that Debian's libassimp-dev has and the command is linked with. They are Debian's
# source package, fetched once by apt-get into ~/.cache/sinew; the system's own lists of packages stay as they are.
#   SINEW_ASSIMP_SOURCE=FOLDER      sources that are there already
set -euo pipefail
if [ -n "${SINEW_ASSIMP_SOURCE:-}" ]; then
  [ -f "$SINEW_ASSIMP_SOURCE/code/AssetLib/FBX/FBXImporter.cpp" ] || { echo "assimp: $SINEW_ASSIMP_SOURCE: expected Assimp's sources, found none" >&2; exit 1; }
  echo "$SINEW_ASSIMP_SOURCE"
  exit 0
fi
version=$(dpkg-query -W -f='${source:Version}' libassimp-dev 2>/dev/null) || version=
if [ -z "$version" ] || ! command -v dpkg-source >/dev/null; then
  echo "assimp: libassimp-dev and dpkg-dev are not installed: run scripts/setup.sh, or set SINEW_ASSIMP_SOURCE to the sources of Assimp 5.2" >&2
  exit 1
fi
cache=${XDG_CACHE_HOME:-$HOME/.cache}/sinew sources=${XDG_CACHE_HOME:-$HOME/.cache}/sinew/assimp_$version
if [ ! -d "$sources" ]; then
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
  chmod 755 "$work"
  mkdir -p "$work/lists/partial" "$work/parts" "$cache"
  # The places that Debian's packages come from, asked for sources this time.
  for list in /etc/apt/sources.list.d/*.sources; do
    [ ! -f "$list" ] || sed -n 's/^Types:.*/Types: deb-src/; p' "$list" >"$work/parts/$(basename "$list")"
  done
  for list in /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
    [ ! -f "$list" ] || sed -n 's/^deb /deb-src /p' "$list" >"$work/parts/$(basename "$list").list"
  done
  apt=(apt-get -qq -o Dir::Etc::SourceList=/dev/null -o Dir::Etc::SourceParts="$work/parts" -o Dir::State::Lists="$work/lists" -o APT::Sandbox::User=root)
  # A place without sources is no reason to stop: the next line says whether one has them.
  (cd "$work" && { "${apt[@]}" update || true; } && "${apt[@]}" source "assimp=$version") >"$work/log" 2>&1 || { cat "$work/log" >&2; exit 1; }
  rm -rf "$work"/assimp-*/{test,doc,samples,port}
  mv "$work"/assimp-*/ "$sources" 2>/dev/null || [ -d "$sources" ]
fi
echo "$sources"
