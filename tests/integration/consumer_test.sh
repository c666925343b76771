#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The engine configures alone (no package is looked for), installs as an archive and as a shared library (this one without published methods,
# and says so), and a 5-line project finds and links it: through CMake, and through pkg-config by a C compiler alone. Every installed header
# compiles alone, in C99 and in C++17.
#   consumer_test.sh SOURCE_DIR WORK_DIR
set -euo pipefail
source_dir=$1 work=$2
consumer=$source_dir/tests/integration/consumer
rm -rf "$work"
mkdir -p "$work"
# `grep -q` would close the pipe on a program that is still writing, which pipefail counts as a failure.
quietly() { "$@" >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }; }
strict=(-pedantic-errors -Wall -Wextra -Werror)

for shared in OFF ON; do
  prefix=$work/prefix_$shared
  published=ON
  [ $shared = OFF ] || published=OFF  # the shared library without the methods of sinew/published.h
  quietly cmake -S "$source_dir/engine" -B "$work/engine" -DCMAKE_BUILD_TYPE=Release -DBUILD_SHARED_LIBS=$shared -DSINEW_PUBLISHED_METHODS=$published
  if grep -q '_DIR:PATH' "$work/engine/CMakeCache.txt"; then
    echo "the engine looked for a package:"; grep '_DIR:PATH' "$work/engine/CMakeCache.txt"; exit 1
  fi
  quietly cmake --build "$work/engine" -j "$(nproc)"
  quietly cmake --install "$work/engine" --prefix "$prefix"

  quietly cmake -S "$consumer" -B "$work/consumer_$shared" -DCMAKE_PREFIX_PATH="$prefix"
  quietly cmake --build "$work/consumer_$shared"
  "$work/consumer_$shared/consumer" | grep '^sinew [0-9]' >/dev/null
  "$work/consumer_$shared/consumer_cpp" | grep '^sinew [0-9]' >/dev/null

  read -ra flags <<<"$(PKG_CONFIG_PATH="$(dirname "$(find "$prefix" -name sinew.pc)")" pkg-config --cflags --libs sinew)"
  cc -std=c99 "${strict[@]}" "$consumer/main.c" -o "$work/by_pkg_config_$shared" "${flags[@]}"
  library=$(find "$prefix" -name 'libsinew.*' -print -quit)
  LD_LIBRARY_PATH=$(dirname "$library") "$work/by_pkg_config_$shared" | grep '^sinew [0-9]' >/dev/null
  cc -std=c99 "${strict[@]}" "$consumer/published.c" -o "$work/published_$shared" "${flags[@]}"
  LD_LIBRARY_PATH=$(dirname "$library") "$work/published_$shared" "$([ $published = ON ] && echo built || echo left-out)"
done
if cmake -S "$source_dir" -B "$work/whole" -DSINEW_PUBLISHED_METHODS=OFF >"$work/log" 2>&1; then
  echo "a trainer without the methods that it trains is no error"; exit 1
fi
grep 'SINEW_BUILD_TRAINER needs SINEW_PUBLISHED_METHODS=ON' "$work/log" >/dev/null || { cat "$work/log"; exit 1; }
ldd "$work/by_pkg_config_ON" | grep 'libsinew\.so\.' >/dev/null || { echo "the shared library was not linked"; exit 1; }
if ldd "$work/by_pkg_config_OFF" | grep libsinew >/dev/null; then echo "the archive was not linked"; exit 1; fi

# The first sample is C99, nothing newer.
cc -std=c99 "${strict[@]}" -fsyntax-only "-I$work/prefix_ON/include" "$source_dir/samples/01_hello_c/hello.c"
for header in "$work"/prefix_ON/include/sinew/*.h; do
  cc -std=c99 "${strict[@]}" -fsyntax-only "-I$work/prefix_ON/include" -x c - <<<"#include <sinew/${header##*/}>"
done
for header in "$work"/prefix_ON/include/sinew/*; do
  c++ -std=c++17 "${strict[@]}" -fsyntax-only "-I$work/prefix_ON/include" -x c++ - <<<"#include <sinew/${header##*/}>"
done

for option in SINEW_INSTALL_MODEL SINEW_INSTALL_RIG_MODEL SINEW_INSTALL_HANDS_MODEL; do
  if cmake -S "$source_dir/engine" -B "$work/engine" "-D$option=$work/none.sinew" >"$work/log" 2>&1; then
    echo "a model to install that is not there is no error"; exit 1
  fi
  grep -F "$option=$work/none.sinew" "$work/log" >/dev/null || { cat "$work/log"; exit 1; }
  quietly cmake -S "$source_dir/engine" -B "$work/engine" "-D$option="
done
