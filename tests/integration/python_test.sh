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
"$python" -m venv --system-site-packages "$work/venv"
"$work/venv/bin/python" -m pip install --quiet --no-index --no-deps "${wheels[@]}"
unset SINEW_LIBRARY SINEW_MODELS PYTHONPATH
cd "$source/samples/python/tests"
export PYTHONDONTWRITEBYTECODE=1 SINEW_PICTURES=$work
"$work/venv/bin/python" -c 'import sinew, sys; sys.exit("venv" not in sinew.__file__)'
"$work/venv/bin/python" -m unittest -v
