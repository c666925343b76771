#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The Debian packages of a build, sinew and sinew-dev, unpacked in an empty folder: control fields, which files are in which, licenses, manual page,
# completion; the command binds there with its own model; CMake and pkg-config find library and model, also after the folder moved.
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
version=$("$build/sinew" --version | cut -d ' ' -f 2)
architecture=$(dpkg --print-architecture)
deb=$work/packed/sinew_${version}_$architecture.deb dev=$work/packed/sinew-dev_${version}_$architecture.deb
field() { dpkg-deb -f "$1" "$2"; }
is() { [ "$(field "$1" "$2")" = "$3" ] || fail "field $2 of $(basename "$1") is '$(field "$1" "$2")', expected '$3'"; }
is "$deb" Package sinew
is "$dev" Package sinew-dev
is "$dev" Section libdevel
is "$dev" Depends "sinew (= $version)"
for one in "$deb" "$dev"; do
  is "$one" Version "$version"
  is "$one" Architecture "$architecture"
  for name in Maintainer Description Installed-Size; do [ -n "$(field "$one" "$name")" ] || fail "no field $name"; done
  others=$(dpkg-deb -c "$one" | awk '($1 !~ /^[d-]rw[x-]r-[x-]r-[x-]$/ && $1 !~ /^l/) || $2 != "root/root"')
  [ -z "$others" ] || fail "owners or permissions: $others"
done
# What runs is in the one, what is built with in the other; no file is in both.
files_of() { dpkg-deb --fsys-tarfile "$1" | tar t | grep -v '/$' | sort; }
has() { files_of "$1" | grep -E "$2" >/dev/null || fail "$(basename "$1") has no file like $2"; }
for name in bin/sinew 'lib/.*libsinew\.so\.[0-9.]*[0-9]' 'lib/.*libsinew_character\.so\.[0-9.]*[0-9]' share/sinew/sinew_default.sinew share/sinew/sinew_rig.sinew share/sinew/sinew_hands.sinew share/sinew/sinew_front.sinew share/doc/sinew/copyright \
            share/man/man1/sinew.1.gz share/bash-completion/completions/sinew; do has "$deb" "^./usr/$name\$"; done
for name in include/sinew/sinew.h 'lib/.*libsinew\.a' 'lib/.*libsinew\.so' 'lib/.*cmake/sinew/sinewConfig.cmake' 'lib/.*pkgconfig/sinew.pc' include/sinew/character.h 'lib/.*libsinew_character\.so' 'lib/.*pkgconfig/sinew-character.pc' \
            share/doc/sinew-dev/copyright; do has "$dev" "^./usr/$name\$"; done
extra=$(files_of "$deb" | grep -E '/include/|\.a$|\.so$|\.cmake$|\.pc$' || true)
[ -z "$extra" ] || fail "sinew has what belongs to sinew-dev: $extra"
both=$(comm -12 <(files_of "$deb") <(files_of "$dev"))
[ -z "$both" ] || fail "in both packages: $both"

dpkg-deb -x "$deb" "$work/first"
dpkg-deb -x "$dev" "$work/first"
root=$work/moved
mv "$work/first" "$root"
sinew=$root/usr/bin/sinew
# Every library that the command loads comes from a package that Depends names.
for library in $(objdump -p "$sinew" | awk '$1 == "NEEDED" { print $2 }'); do
  case $library in ld-linux*) continue ;; esac  # the loader itself, libc6's
  path=$(ldd "$sinew" | awk -v name="$library" '$1 == name { print $3 }')
  # dpkg knows one of the two where /lib is a link to /usr/lib.
  owner=$({ dpkg -S "$path" "$(realpath "$path")" 2>/dev/null || true; } | sed -n '1s/:.*//p')
  [[ ", $(field "$deb" Depends)," == *", $owner"[\ ,]* ]] || fail "Depends has no '$owner', which $library belongs to: $(field "$deb" Depends)"
done

# And of those that it loads when a file needs them.
for library in $(grep -aoE 'lib(assimp|draco)\.so\.[0-9]+' "$sinew" | sort -u); do
  owner=$(dpkg -S "*/$library" 2>/dev/null | sed -n '1s/:.*//p')
  [[ ", $(field "$deb" Depends)," == *", $owner"[\ ,]* ]] || fail "Depends has no '$owner', which $library belongs to: $(field "$deb" Depends)"
done

copyright=$root/usr/share/doc/sinew/copyright
grep -F "$(sed -n 's/^Copyright (c) //p' "$source_dir/LICENSE")" "$copyright" >/dev/null || fail "$copyright lacks the line of LICENSE"
# What the command's code is built of; MPI and threads are the system's.
cd "$source_dir"
for library in tinygltf $(sed -n 's/^ *find_package(\([A-Za-z0-9_]*\).*/\1/p' formats/CMakeLists.txt character/CMakeLists.txt trainer/CMakeLists.txt \
                          trainer/data_sets/CMakeLists.txt quant/CMakeLists.txt samples/cli/CMakeLists.txt | grep -v -x 'MPI\|Threads'); do
  case $library in PNG) library=libpng ;; ZLIB) library=zlib ;; esac
  grep -w "$library" "$copyright" >/dev/null || fail "$copyright does not name $library"
done
# Manual page and completion: every command, and its options as --help lists them.
gzip -dc "$root/usr/share/man/man1/sinew.1.gz" >"$work/sinew.1"
complete_words() { # WORD...: what bash offers for the last word
  bash -c '. "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); "_${COMP_WORDS[0]//-/_}" 2>/dev/null; printf "%s\n" "${COMPREPLY[@]}"' - \
    "$root/usr/share/bash-completion/completions/$1" "$@"
}
commands=$("$sinew" --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]*\) .*/\1/p')
[ -n "$commands" ] || fail "sinew --help lists no commands"
for command in $commands; do
  grep -x ".SS $command" "$work/sinew.1" >/dev/null || fail "the manual page does not name the command $command"
  complete_words sinew "${command:0:1}" | grep -x -e "$command" >/dev/null || fail "the completion does not offer $command"
  offered=$(complete_words sinew "$command" -)
  for option in $("$sinew" "$command" --help | sed -n 's/^  \(-[^ ]*\).*/\1/p' | sed 's/{[^}]*}//g' | tr , ' '); do
    grep -x -e "$option" <<<"$offered" >/dev/null || fail "the completion of $command does not offer $option"
    [[ $option == -h || $option == --help || $option == --help-all ]] && continue
    grep -F -e "${option//-/\\-}" "$work/sinew.1" >/dev/null || fail "the manual page does not name $command $option"
  done
done
complete_words sinew-lab dataset "" | grep -x check >/dev/null || fail "the completion does not offer sinew-lab dataset check"
complete_words sinew rig --for "" | grep -x mixamo >/dev/null || fail "the completion does not offer the values of sinew rig --for"
complete_words sinew map --method "" | grep -x auto >/dev/null || fail "the completion does not offer the values of sinew map --method"

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
hands_model=$(pkg-config --variable=hands_model sinew)
cmp "$hands_model" "$source_dir/samples/data/sinew_hands.sinew" || fail "pkg-config's hands_model is '$hands_model'"
front_model=$(pkg-config --variable=front_model sinew)
cmp "$front_model" "$source_dir/samples/data/sinew_front.sinew" || fail "pkg-config's front_model is '$front_model'"
bind "$sinew" file.glb --model "$model"
cmp bundled.glb file.glb
bind "$build/sinew" built.glb
cmp bundled.glb built.glb

# A C program with libsinew_character, by pkg-config and by CMake.
read -ra flags <<<"$(pkg-config --cflags --libs sinew-character)"
cc -std=c99 -pedantic-errors "$source_dir/samples/02_character_c/bind.c" -o by_pkg_config "${flags[@]}"
LD_LIBRARY_PATH=$(pkg-config --variable=libdir sinew-character) ./by_pkg_config snake__long.obj library.glb >"$work/log"
cmp library.glb bundled.glb
sed -n '/^ \*   #include/,/^ \*   }/s/^ \*   //p' "$root/usr/include/sinew/character.h" >example.c
cc -std=c99 -pedantic-errors -Wall -Wextra -Werror example.c -o example "${flags[@]}" || fail "the example of sinew/character.h does not compile"

quietly cmake -S "$source_dir/tests/integration/consumer" -B "$work/consumer" -DCMAKE_PREFIX_PATH="$root/usr"
quietly cmake --build "$work/consumer"
"$work/consumer/character" snake__long.obj linked.glb >"$work/log"
cmp linked.glb bundled.glb
for name in default rig hands; do
  [ -e "$root/usr/share/doc/sinew/sinew_$name.md" ] || fail "the card of the $name model is missing"
  "$work/consumer/consumer" | grep -F "opened $root/usr/share/sinew/sinew_$name.sinew" >/dev/null || fail "the CMake package has no $name model in $root"
done
