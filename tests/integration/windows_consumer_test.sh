#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# consumer_test.sh for Windows: the engine as an archive and as a DLL of MinGW, installed; a project finds and links it through CMake, a C
# compiler alone through pkg-config, and what they make runs under wine.
#   windows_consumer_test.sh SOURCE_DIR WORK_DIR
set -euo pipefail
source_dir=$1 work=$2
consumer=$source_dir/tests/integration/consumer
toolchain=$source_dir/engine/cmake/toolchains/windows.cmake
rm -rf "$work"
mkdir -p "$work"
quietly() { "$@" >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }; }
# shellcheck source=tests/support/wine.sh
. "$source_dir/tests/support/wine.sh" "$work/wine"
says_version() { run_wine "$@" | grep '^sinew [0-9]' >/dev/null || { echo "$1 does not run"; exit 1; }; }

for shared in OFF ON; do
  prefix=$work/prefix_$shared
  quietly cmake -S "$source_dir/engine" -B "$work/engine" --toolchain "$toolchain" -DCMAKE_BUILD_TYPE=Release -DBUILD_SHARED_LIBS=$shared \
    -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=12
  quietly cmake --build "$work/engine" -j "${SINEW_JOBS:-$(nproc)}"
  quietly cmake --install "$work/engine" --prefix "$prefix"

  quietly cmake -S "$consumer" -B "$work/consumer_$shared" --toolchain "$toolchain" -DCMAKE_FIND_ROOT_PATH="$prefix"
  quietly cmake --build "$work/consumer_$shared"
  read -ra flags <<<"$(PKG_CONFIG_PATH=$prefix/lib/pkgconfig pkg-config --cflags --libs sinew)"
  x86_64-w64-mingw32-gcc-posix -std=c99 -pedantic-errors -Wall -Wextra -Werror "$consumer/main.c" -o "$work/by_pkg_config_$shared.exe" "${flags[@]}"

  programs=("$work/consumer_$shared/consumer.exe" "$work/consumer_$shared/consumer_cpp.exe" "$work/by_pkg_config_$shared.exe")
  for program in "${programs[@]}"; do
    imports=$(x86_64-w64-mingw32-objdump -p "$program" | sed -n 's/.*DLL Name: //p')
    case $shared:$imports in
      OFF:*sinew*) echo "$program needs the DLL, expected the archive"; exit 1 ;;
      ON:*libsinew.dll*) ;;
      ON:*) echo "$program does not need libsinew.dll, only $imports"; exit 1 ;;
    esac
    WINEPATH=$prefix/bin says_version "$program"
  done
done

# The DLL exports the interface alone, and needs Windows alone.
dll=$work/prefix_ON/bin/libsinew.dll
exported=$(x86_64-w64-mingw32-objdump -p "$dll" | sed -n '/\[Ordinal\/Name Pointer\]/,/^$/s/^\t\[ *[0-9]*\] //p')
others=$(grep -v '^sinew_' <<<"$exported" || true)
[ -z "$others" ] || { echo "the DLL exports more than sinew_*: $others"; exit 1; }
grep -x sinew_bind <<<"$exported" >/dev/null || { echo "the DLL does not export sinew_bind"; exit 1; }
others=$(x86_64-w64-mingw32-objdump -p "$dll" | sed -n 's/.*DLL Name: //p' | grep -v -i -x 'kernel32.dll\|msvcrt.dll' || true)
[ -z "$others" ] || { echo "the DLL needs $others"; exit 1; }
