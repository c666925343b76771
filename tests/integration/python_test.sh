#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The wheel of samples/python: built offline, installed into a fresh venv, tested there.
#   python_test.sh SOURCE LIBRARY COMMAND WORK      exits 77 where Python's packages are missing
set -euo pipefail
source=$1 library=$2 work=$4
export SINEW_COMMAND=$3 SINEW_SOURCE_DIR=$source
# Debian's packages belong to Debian's python3, which need not be the first one in PATH.
python=
for one in python3 /usr/bin/python3; do
  if "$one" -c 'import build, ensurepip, numpy, setuptools, wheel' 2>/dev/null; then python=$one; break; fi
done
if [ -z "$python" ]; then
  echo "python_test: SKIPPED, no python3 with build, venv, numpy, setuptools and wheel (Debian: python3-build python3-venv python3-numpy python3-setuptools python3-wheel)"
  exit 77
fi
rm -rf "$work" && mkdir -p "$work"
PYTHON=$python SINEW_LIBRARY=$library "$source/samples/python/build.sh" "$work"
wheels=("$work"/sinew-*-py3-none-*.whl)
# The README's install line as it is there: with Debian's python3, which pip may not install into; with that of a plain venv; with another
# that comes first in PATH (pyenv's). Offline where numpy is there.
line=$(grep -o 'python3 -m venv .*pip install [^ ]*' "$source/samples/python/README.md")
[ -n "$line" ] || { echo "python_test: no install line in samples/python/README.md" >&2; exit 1; }
"$python" -m venv "$work/plain"
tries=("$(command -v "$python")" "$work/plain/bin/python3")
[ "$(command -v python3)" = "${tries[0]}" ] || tries+=("$(command -v python3)")
for i in "${!tries[@]}"; do
  try=$work/try$i
  mkdir -p "$try/build" "$try/path"
  ln -s "$work" "$try/build/python"
  printf '#!/bin/sh\nexec "%s" "$@"\n' "${tries[$i]}" >"$try/path/python3"
  chmod +x "$try/path/python3"
  offline=0
  "${tries[$i]}" -m venv --system-site-packages "$try/probe"
  if "$try/probe/bin/python" -c 'import numpy' 2>/dev/null; then offline=1; fi
  if ! (cd "$try" && PATH=$try/path:$PATH PIP_NO_INDEX=$offline bash -ec "$line" >"$try/log" 2>&1); then
    if [ "$offline" = 0 ] && grep -q 'No matching distribution found for numpy' "$try/log"; then
      echo "python_test: SKIPPED the install line with ${tries[$i]}: it has no numpy, and there is no index to get it from"
      continue
    fi
    cat "$try/log" >&2
    echo "python_test: the README's install line fails with ${tries[$i]}" >&2
    exit 1
  fi
  "$try/build/venv/bin/python" -c 'import sinew, sys; sys.exit("build/venv" not in sinew.__file__)'
  echo "python_test: the README's install line works with ${tries[$i]}"
done
ln -s "$work/try0/build/venv" "$work/venv"
unset SINEW_LIBRARY SINEW_MODELS PYTHONPATH
cd "$source/samples/python/tests"
export PYTHONDONTWRITEBYTECODE=1 SINEW_PICTURES=$work
"$work/venv/bin/python" -c 'import sinew, sys; sys.exit("venv" not in sinew.__file__)'
"$work/venv/bin/python" -m unittest -v
