#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds the wheel from a clean clone: shared library, models, package. Offline.
#   samples/python/build.sh [OUT]      OUT/sinew-0.1.0-py3-none-PLATFORM.whl, OUT is build/python by default
#   samples/python/build.sh --packages Debian packages that building and testing need and that are not there
#   SINEW_LIBRARY=FILE                 takes this library instead of compiling one
#   PYTHON=FILE                        another python3; Debian's packages belong to Debian's, which need not be the first in PATH
#   SINEW_TOOLCHAIN="-DCMAKE_..."      more for CMake, as --toolchain FILE; SINEW_PLATFORM=win_amd64 names its wheel
set -euo pipefail
if [ "${1:-}" = --packages ]; then
  for package in python3-build python3-setuptools python3-wheel python3-venv python3-numpy python3-matplotlib python3-meshio mypy; do
    dpkg-query -W -f='${Status}' $package 2>/dev/null | grep -q 'install ok installed' || echo $package
  done
  exit 0
fi
root=$(cd "$(dirname "$0")/../.." && pwd)
out=${1:-$root/build/python}
mkdir -p "$out"
out=$(cd "$out" && pwd)

python=
for one in ${PYTHON:-python3 /usr/bin/python3}; do
  if [ -z "$python" ] && "$one" -c 'import build, setuptools, wheel' 2>/dev/null; then python=$one; fi
done
if [ -z "$python" ]; then
  echo "python/build.sh: needs Python's build, setuptools and wheel (Debian: apt-get install python3-build python3-setuptools python3-wheel)" >&2
  exit 1
fi
stage=$out/stage
rm -rf "$stage" && mkdir -p "$stage/src"
cp "$root"/samples/python/{pyproject.toml,setup.py,README.md} "$root/LICENSE" "$stage"
"$root/samples/python/stage.sh" "$out" "$stage/src/sinew"
cd "$stage"
rm -f "$out"/sinew-*.whl
if [ -z "${SINEW_PLATFORM:-}" ] && [ "$(uname -s)" = Linux ]; then
  SINEW_PLATFORM=$("$python" "$root/samples/python/wheel_tag.py" src/sinew/data/*.so*)
  export SINEW_PLATFORM
fi
"$python" -m build --wheel --no-isolation --outdir "$out" . >"$out/wheel.log" 2>&1 || { tail -20 "$out/wheel.log" >&2; exit 1; }
ls "$out"/sinew-*.whl
