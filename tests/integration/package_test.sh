#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The Debian package of a build, unpacked in an empty folder: control fields, licences, manual page; the command binds there with its own
# model; CMake and pkg-config find library and model, also after the folder moved.
#   package_test.sh SOURCE_DIR BUILD_DIR WORK_DIR
set -euo pipefail
source_dir=$1 build=$2 work=$3
rm -rf "$work"
mkdir -p "$work/elsewhere"
fail() { echo "package: $*"; exit 1; }
quietly() { "$@" >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }; }
# Ninja stands for a generator whose install does not build everything again.
pack() { cpack -G DEB --config "$build/CPackConfig.cmake" -B "$work/packed" -D CPACK_CMAKE_GENERATOR=Ninja "$@" >"$work/log" 2>&1; }

if grep -q '^SINEW_TRAINER_ARCH:[A-Z]*=.' "$build/CMakeCache.txt"; then
  if pack; then fail "cpack made a package of a build for this processor alone"; fi
  grep -e '--preset package' "$work/log" >/dev/null || { cat "$work/log"; fail "cpack does not say how to build a package"; }
fi
pack -D CPACK_SINEW_THIS_MACHINE=ON || { cat "$work/log"; fail "cpack failed"; }
deb=$(find "$work/packed" -maxdepth 1 -name '*.deb')

field() { dpkg-deb -f "$deb" "$1"; }
is() { [ "$(field "$1")" = "$2" ] || fail "field $1 is '$(field "$1")', expected '$2'"; }
version=$("$build/sinew" --version | cut -d ' ' -f 2)
is Package sinew
is Version "$version"
is Architecture "$(dpkg --print-architecture)"
for name in Maintainer Description Installed-Size; do [ -n "$(field "$name")" ] || fail "no field $name"; done
others=$(dpkg-deb -c "$deb" | awk '$1 !~ /^[d-]rw[x-]r-[x-]r-[x-]$/ || $2 != "root/root"')
[ -z "$others" ] || fail "owners or permissions: $others"

dpkg-deb -x "$deb" "$work/first"
root=$work/moved
mv "$work/first" "$root"
sinew=$root/usr/bin/sinew
# Every library that the command loads comes from a package that Depends names.
for library in $(objdump -p "$sinew" | awk '$1 == "NEEDED" { print $2 }'); do
  path=$(ldd "$sinew" | awk -v name="$library" '$1 == name { print $3 }')
  # dpkg knows one of the two where /lib is a link to /usr/lib.
  owner=$({ dpkg -S "$path" "$(realpath "$path")" 2>/dev/null || true; } | sed -n '1s/:.*//p')
  [[ ", $(field Depends)," == *", $owner"[\ ,]* ]] || fail "Depends has no '$owner', which $library belongs to: $(field Depends)"
done

copyright=$root/usr/share/doc/sinew/copyright
grep -F "$(sed -n 's/^Copyright (c) //p' "$source_dir/LICENSE")" "$copyright" >/dev/null || fail "$copyright lacks the line of LICENSE"
# What the command's code is built of; MPI and threads are the system's.
cd "$source_dir"
for library in tinygltf $(sed -n 's/^ *find_package(\([A-Za-z0-9_]*\).*/\1/p' formats/CMakeLists.txt formats/*/CMakeLists.txt trainer/CMakeLists.txt \
                          quant/CMakeLists.txt samples/cli/CMakeLists.txt | grep -v -x 'MPI\|Threads'); do
  case $library in PNG) library=libpng ;; ZLIB) library=zlib ;; esac
  grep -w "$library" "$copyright" >/dev/null || fail "$copyright does not name $library"
done
for command in $("$sinew" --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]*\) .*/\1/p'); do
  gzip -dc "$root/usr/share/man/man1/sinew.1.gz" | grep -x ".B $command" >/dev/null || fail "package/sinew.1 does not name the command $command"
done

# Binds far from the sources, and to the same bytes with the installed model.
cd "$work/elsewhere"
cp "$source_dir"/samples/data/snake__long.* .
bind() { env -i "$1" bind snake__long.obj --skeleton snake__long.rig.txt "${@:3}" -o "$2" >"$work/log" 2>&1 || { cat "$work/log"; fail "the installed command failed"; }; }
bind "$sinew" bundled.glb
export PKG_CONFIG_PATH=$root/usr/lib/pkgconfig
[ -d "$PKG_CONFIG_PATH" ] || PKG_CONFIG_PATH=$(dirname "$(find "$root" -name sinew.pc)")
model=$(pkg-config --variable=default_model sinew)
cmp "$model" "$source_dir/samples/data/sinew_default.sinew" || fail "pkg-config's default_model is '$model'"
rig_model=$(pkg-config --variable=rig_model sinew)
cmp "$rig_model" "$source_dir/samples/data/sinew_rig.sinew" || fail "pkg-config's rig_model is '$rig_model'"
bind "$sinew" file.glb --model "$model"
cmp bundled.glb file.glb
bind "$build/sinew" built.glb
cmp bundled.glb built.glb

# A C program with libsinew_character, by pkg-config and by CMake.
read -ra flags <<<"$(pkg-config --cflags --libs sinew-character)"
cc -std=c99 -pedantic-errors "$source_dir/samples/02_character_c/bind.c" -o by_pkg_config "${flags[@]}"
LD_LIBRARY_PATH=$(pkg-config --variable=libdir sinew-character) ./by_pkg_config snake__long.obj library.glb >"$work/log"
cmp library.glb bundled.glb

quietly cmake -S "$source_dir/tests/integration/consumer" -B "$work/consumer" -DCMAKE_PREFIX_PATH="$root/usr"
quietly cmake --build "$work/consumer"
"$work/consumer/character" snake__long.obj linked.glb >"$work/log"
cmp linked.glb bundled.glb
for name in default rig; do
  [ -e "$root/usr/share/doc/sinew/sinew_$name.md" ] || fail "the card of the $name model is missing"
  "$work/consumer/consumer" | grep -F "opened $root/usr/share/sinew/sinew_$name.sinew" >/dev/null || fail "the CMake package has no $name model in $root"
done
