#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The C# binding of samples/csharp with Mono: structs against the C compiler's, weights and skeletons against the command's.
#   csharp_test.sh SOURCE LIBRARY COMMAND WORK      exits 77 where Mono is missing
#   csharp_test.sh --packages                       what it needs on Debian
set -euo pipefail
packages="mono-mcs mono-runtime libmono-system-core4.0-cil"
if [ "${1:-}" = --packages ]; then
  echo "$packages"
  exit 0
fi
source=$1 library=$2 command=$3 work=$4
if ! command -v mcs >/dev/null || ! command -v mono >/dev/null; then
  echo "csharp_test: SKIPPED, no mcs and mono (Debian: $packages)"
  exit 77
fi
rm -rf "$work" && mkdir -p "$work"
fail() { echo "csharp_test: $*" >&2; exit 1; }
mcs -langversion:7 -warnaserror -out:"$work/Test.exe" "$source/samples/csharp/Sinew.cs" "$source/samples/csharp/Test.cs"
export LD_LIBRARY_PATH=$(dirname "$library")
run() { mono "$work/Test.exe" "$@"; }

# Sizes and offsets of C, of every struct and member that the binding has.
run sizes > "$work/csharp.txt"
{
  echo '#include <stddef.h>'
  echo '#include <stdio.h>'
  echo '#include "sinew/sinew.h"'
  echo 'int main(void) {'
  while read -r what _; do
    case $what in
      *.*) echo "printf(\"$what %zu\\n\", offsetof(${what%.*}, ${what#*.}));" ;;
      *) echo "printf(\"$what %zu\\n\", sizeof($what));" ;;
    esac
  done < "$work/csharp.txt"
  echo 'return 0; }'
} > "$work/sizes.c"
"${CC:-cc}" -I "$source/engine/include" "$work/sizes.c" -o "$work/sizes"
"$work/sizes" > "$work/c.txt"
[ "$(grep -c '\.' "$work/c.txt")" -gt 60 ] || fail "the binding has too few members: $(wc -l < "$work/c.txt") lines"
diff "$work/c.txt" "$work/csharp.txt" || fail "structs differ from those of C (< C, > C#)"

data=$source/samples/data
for name in biped__robed biped__robot bird__winged many-legged__plated quadruped__tailed snake__long; do
  expected=$("$command" bind "$data/$name.obj" --skeleton "$data/$name.rig.txt" --joints all --json -o "$work/$name.glb" |
    sed -n 's/.*"hash": "\([0-9a-f]*\)".*/\1/p')
  found=$(run bind "$data/sinew_default.sinew" "$data/$name.obj")
  [ -n "$expected" ] && [ "$found" = "$expected" ] || fail "$name: weights hash to $found, the command's to $expected"
done
# Mono prints seven digits of a float: compared as numbers.
"$command" rig "$data/biped__robed.obj" --no-bind -o "$work/robed.rig.txt" > /dev/null
grep '^joints' "$work/robed.rig.txt" | awk '{ printf "%s %.4f %.4f %.4f\n", $2, $3, $4, $5 }' > "$work/expected.txt"
run rig "$data/sinew_rig.sinew" "$data/biped__robed.obj" | awk '{ printf "%s %.4f %.4f %.4f\n", $2, $3, $4, $5 }' > "$work/found.txt"
diff "$work/expected.txt" "$work/found.txt" || fail "the skeleton is not the command's"
run errors "$data/sinew_default.sinew" "$data/biped__robed.obj"

# Without the library: one line that names it.
if LD_LIBRARY_PATH=/nowhere run bind "$data/sinew_default.sinew" "$data/biped__robed.obj" 2> "$work/missing.txt"; then
  fail "bound without the library"
fi
grep -q 'DllNotFoundException: .*sinew' "$work/missing.txt" || fail "a missing library is not named: $(cat "$work/missing.txt")"
echo "csharp_test: structs, six binds and a skeleton equal C's and the command's"
